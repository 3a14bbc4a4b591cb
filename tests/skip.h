// How a test says that it cannot run here: ctest then reports it as skipped, with the reason.
#pragma once

#include <iostream>
#include <string_view>

namespace pushfactor::tests {

inline void skip(std::string_view why) {
    std::cout << "skipped: " << why << "\n";
}

}  // namespace pushfactor::tests
