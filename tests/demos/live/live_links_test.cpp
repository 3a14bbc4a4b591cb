// Links from commands on pages to the page in a browser.
#include "demos/base/platform/shell_words.h"
#include "demos/pictures/live/links.h"
#include "tests/catch.h"

using namespace pushfactor::demos;

namespace {

std::vector<std::string> addresses(const std::string& command) {
    std::vector<std::string> found;
    for (const pictures::live::PageLink& link : pictures::live::page_links(command)) found.push_back(link.address);
    return found;
}

}  // namespace

TEST_CASE("a command on a page leads to the instant that it shows last, with the options that decide the run") {
    using List = std::vector<std::string>;
    CHECK(addresses("pushfactor run stack --preset paper --seconds 2 --csv a.csv") ==
          List{"live.html#scenes&scene=stack&preset=paper&step=120"});
    CHECK(addresses("pushfactor render funnel --at 2,30 --samples 4") ==
          List{"live.html#scenes&scene=funnel&step=1800"});
    CHECK(addresses("pushfactor run chain --end-mass 1000 --dt 1/240 --seconds 1/2 --timing --threads 2") ==
          List{"live.html#scenes&scene=chain&end-mass=1000&dt=1/240&step=120"});
    const auto compared = pictures::live::page_links(
        "pushfactor render intersecting-stack --preset paper --compare push=persistent,single-frame --at 0,0.5 "
        "--camera fit --overlay velocities:10,trails");
    REQUIRE(compared.size() == 2);
    CHECK(compared[0].address ==
          "live.html#scenes&scene=intersecting-stack&preset=paper&push=persistent&step=30&show=velocities&fit=on");
    CHECK(compared[1].differs == "push single-frame");
    for (const char* const other : {"pushfactor report error", "pushfactor run my.json --seconds 1", "pushfactor",
                                    "", "pushfactor family wall >f.json; pushfactor run f.json"}) {
        CHECK(addresses(other).empty());
    }
}

TEST_CASE("the words of a command are those that it was made of") {
    for (const std::vector<std::string>& words :
         {std::vector<std::string>{"run", "my scene.json", "--name", "it's"}, {"", "a'b'", "--x", "$HOME;*"}}) {
        std::vector<std::string> expected{"pushfactor"};
        expected.insert(expected.end(), words.begin(), words.end());
        CHECK(words_of(command_of(words)) == expected);
    }
}
