// Version and build of the program.
#pragma once

#include <string>

namespace pushfactor::demos {

std::string version_number();  // "0.1.0"

// "0.1.0, commit 0123456789ab": the commit of the build, with "-dirty" if tracked files were modified; "unknown"
// outside a checkout.
std::string version_text();

// Build type and compiler options.
std::string compile_flags();

}  // namespace pushfactor::demos
