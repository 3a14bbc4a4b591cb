// Which program this is.
#pragma once

#include <string>

namespace pushfactor::demos {

std::string version_number();  // "0.1.0"

// "0.1.0, commit 0123456789ab": the commit that was checked out when the program was built, with "-dirty" where
// files had been changed since; "unknown" where the sources were no checkout.
std::string version_text();

// Build type and the compiler's options of the build.
std::string compile_flags();

}  // namespace pushfactor::demos
