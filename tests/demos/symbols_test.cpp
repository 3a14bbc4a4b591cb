// The mathematical functions that the libraries behind a state take from the C library.
#include "tests/catch.h"
#include "tests/demos/program.h"

#include <regex>
#include <set>
#include <sstream>

using namespace pushfactor::tests;

TEST_CASE("what moves bodies takes no function of the C library that may round in its own way") {
    const std::set<std::string> rounding{"sin",   "cos",   "sincos", "tan",  "asin",  "acos",  "atan", "atan2",
                                         "sinh",  "cosh",  "tanh",   "exp",  "exp2",  "expm1", "log",  "log2",
                                         "log10", "log1p", "pow",    "cbrt", "hypot", "fma",   "erf",  "tgamma"};
    std::istringstream libraries(PUSHFACTOR_STATE_LIBRARIES);
    int count = 0;
    for (std::string library; libraries >> library; ++count) {
        INFO(library);
        const Ended symbols = shell(Folder(), "nm --undefined-only '" + library + "'");
        REQUIRE(symbols.status == 0);
        std::istringstream lines(symbols.out);
        int seen = 0;
        for (std::string line; std::getline(lines, line);) {
            std::smatch match;
            if (!std::regex_search(line, match, std::regex(R"( U (\w+?)[fl]?$)"))) continue;
            ++seen;
            INFO(line);
            CHECK(!rounding.contains(match[1].str()));
        }
        CHECK(seen > 10);
    }
    CHECK(count == 2);
}
