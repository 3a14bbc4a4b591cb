#include "demos/runs/summary.h"
#include "tests/catch.h"
#include "tests/texts.h"

#include <fmt/format.h>

#include <algorithm>

using namespace pushfactor;

TEST_CASE("the touchstone is in the list of bits, and this build gives it") {
    const std::vector<std::string> lines =
        tests::lines_of(tests::read_file(PUSHFACTOR_SOURCE_DIR "/tests/hashes/lines.txt"));
    CHECK(std::any_of(lines.begin(), lines.end(), [](const std::string& line) {
        return line.starts_with(fmt::format("{:016x} ", demos::touchstone)) &&
               line.find("run intersecting-stack --preset paper") != std::string::npos;
    }));
    CHECK(demos::gives_listed_bits());
}
