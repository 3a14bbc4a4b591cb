// Checks that the code on the pages is compiled code: pure functions of texts.
//
// A page marks a block of C++ with the region of a source file that it shows,
//
//     <!-- tests/examples/constraint.cpp: constraint -->
//
// in the line before the block; the region is between the lines "// [example: constraint]" and "// [end]".
#pragma once

#include "tests/texts.h"

#include <string>
#include <vector>

namespace pushfactor::tests {

// The faults, one line each; empty when there are none: - a block of C++ without a mark, or a mark without a block;
// - a block whose region is missing, or is not the same byte for byte; - a region without an end, within another
// one, or of a name that its file has already; - a region that no page shows.
std::vector<std::string> example_faults(const Sources& pages, const Sources& sources);

}  // namespace pushfactor::tests
