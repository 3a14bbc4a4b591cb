// Whether the code that the pages show is code that is compiled: pure functions over texts.
//
// A page marks a block of C++ with the region of a source file that it shows,
//
//     <!-- tests/examples/constraint.cpp: constraint -->
//
// in the line before the block; the region stands between the lines "// [example: constraint]" and "// [end]".
#pragma once

#include "tests/texts.h"

#include <string>
#include <vector>

namespace pushfactor::tests {

// What is wrong, a line each; nothing when all is well:
//  - a block of C++ without a mark, or a mark without a block;
//  - a block whose region is not there, or is not the same byte for byte;
//  - a region without an end, within another one, or of a name that its file has already;
//  - a region that no page shows.
std::vector<std::string> example_faults(const Sources& pages, const Sources& sources);

}  // namespace pushfactor::tests
