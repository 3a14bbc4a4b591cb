// Lines of a table as ratios to its reference lines.
#pragma once

#include "tests/peers/table.h"

namespace pushfactor::tests::peers {

// Appends to each line the measures `of.ratios`, divided by those of every reference line.
void append_ratios(const Case& of, std::vector<Line>& lines);

}  // namespace pushfactor::tests::peers
