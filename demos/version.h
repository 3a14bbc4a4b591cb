// Which program this is.
#pragma once

#include <string>

namespace pushfactor::demos {

// "0.1.0, commit 0123456789ab": the commit that was checked out when the program was built, with "-dirty" where
// files had been changed since; "unknown" where the sources were no checkout.
std::string version_text();

}  // namespace pushfactor::demos
