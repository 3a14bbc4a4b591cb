// Other engines over their knobs: points of error against CPU time, with the columns of error.csv and the true
// errors of `pushfactor report error`.
#pragma once

#include "tests/peers/program.h"

#include <iosfwd>

namespace pushfactor::tests::peers {

void write_sweeps(const Program& program, std::ostream& csv);

}  // namespace pushfactor::tests::peers
