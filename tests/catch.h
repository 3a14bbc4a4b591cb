// Includes the installed Catch2: 2.13 (one header, `catch.hpp`) or 3 (`catch_all.hpp`). The file with main()
// defines PUSHFACTOR_CATCH_MAIN first; version 3 brings its own main().
#pragma once

#if __has_include(<catch2/catch_all.hpp>)

#include <catch2/catch_all.hpp>

// The names of version 2, which the tests use.
using Catch::Approx;
namespace Catch {
using Matchers::EndsWith;
using Matchers::StartsWith;
inline auto Contains(const std::string& text) {
    return Matchers::ContainsSubstring(text);
}
}  // namespace Catch

#else

#ifdef PUSHFACTOR_CATCH_MAIN
#define CATCH_CONFIG_MAIN
#endif
#include <catch2/catch.hpp>

#endif
