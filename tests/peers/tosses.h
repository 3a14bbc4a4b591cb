// The tosses of assets/measured in other engines, each with the law of contact that suits it best.
#pragma once

#include <iosfwd>
#include <string>

namespace pushfactor::tests::peers {

// Writes engine, what, at_s, value, error: the lines that `report reality --beside` reads. `measured` is the folder
// of measured motion.
void write_tosses(const std::string& measured, std::ostream& csv);

}  // namespace pushfactor::tests::peers
