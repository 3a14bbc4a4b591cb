// The file of a replay as the program writes it: its size, and that it is whole or absent.
#include "tests/catch.h"
#include "tests/demos/program.h"

#include <regex>

using namespace pushfactor::tests;

namespace {

// Characters in the parts of a page's data; those of a part with this name.
std::size_t data_in(const std::string& page, const std::string& part = "\\w+") {
    const std::regex start("data-part=\"" + part + "\"[^>]*>");
    std::size_t size = 0;
    for (std::sregex_iterator match(page.begin(), page.end(), start), end; match != end; ++match) {
        const auto at = static_cast<std::size_t>(match->position() + match->length());
        size += page.find('<', at) - at;
    }
    return size;
}

std::string page_of(const std::string& options) {
    const Folder folder;
    const Ended ended = shell(folder, "pushfactor run " + options + " --replay run.html");
    INFO(ended.err);
    REQUIRE(ended.status == 0);
    return folder.read("run.html");
}

}  // namespace

TEST_CASE("ten seconds of a stack take 150 kB at most, and the viewer 120 kB") {
    const std::string page = page_of("stack --seconds 10");
    CHECK(data_in(page) <= 150'000);                // 17 kB
    CHECK(data_in(page) > 1000);                    // the test can fail
    CHECK(page.size() - data_in(page) <= 120'000);  // 114 kB
}

TEST_CASE("bodies at rest cost next to nothing, and no mesh is stored per frame") {
    const std::string poses = "(?:poses|velocities|forces|stage|meshes)";
    const std::size_t short_run = data_in(page_of("stack --seconds 10"), poses);
    const std::size_t long_run = data_in(page_of("stack --seconds 60"), poses);
    CHECK(long_run - short_run <= 20'000);  // 3000 frames of five cubes
    const std::string page = page_of("platonic --seconds 0.2 --replay-data poses");
    CHECK(std::regex_search(page, std::regex("data-part=\"meshes\"")));
    CHECK(page.find("data-part=\"meshes\"") == page.rfind("data-part=\"meshes\""));
}

TEST_CASE("with --replay-data poses there are no velocities and no forces") {
    const std::string page = page_of("stack --seconds 0.5 --replay-data poses");
    CHECK(data_in(page, "poses") > 0);
    CHECK(data_in(page, "velocities") + data_in(page, "forces") == 0);
}

TEST_CASE("a replay asks for nothing from elsewhere") {
    const std::string page = page_of("heavy-on-light --seconds 0.1");
    CHECK(page.find("default-src 'none'") != std::string::npos);
    for (const char* const word : {"http://", "https://", "@import", "url("}) {
        INFO(word);
        CHECK(page.find(word) == std::string::npos);
    }
    // All marks of the template are filled in.
    CHECK_FALSE(std::regex_search(page, std::regex("@(style|about|data|meshes|shaders|script)@")));
}

TEST_CASE("a replay must have a name and frames that it can have") {
    check_refused("run stack --overlay forces", "--overlay forces: must be with --glb or --replay");
    check_refused("run stack --replay run.mp4", "--replay run.mp4: must end in .html");
    check_refused("render stack --replay run.htm", "must end in .html");
    check_refused("run stack --replay run.html --replay-data forces", "--replay-data forces: must be all or poses");
    check_refused("render stack --replay run.html --at 1", "not of stills");
    check_refused("render stack funnel --replay run.html", "one scene at a time");
    check_refused("render stack --frames off", "must be with --video or --replay");
    check_refused("run stack --replay run.html --dt 1/50 --fps 60", "rates that fit are 50");
    const Ended ended = run_program("run stack --replay /proc/no/run.html");
    CHECK(ended.status == 4);
    CHECK(ended.err.find("/proc/no") != std::string::npos);
}

TEST_CASE("a run that stops early keeps its replay up to there, and a run that fails to write keeps the old one") {
    const Folder folder;
    const Ended ended = stopped_when(folder, "test -s .*.partial", "run stack --seconds 100000 --replay run.html");
    CHECK(ended.status == 1);
    CHECK(ended.err.find("run.html holds the run up to frame ") != std::string::npos);
    const std::string page = folder.read("run.html");
    CHECK(page.find("interrupted") != std::string::npos);
    CHECK(page.ends_with("</html>\n"));
    CHECK(folder.files() == std::vector<std::string>{"run.html"});
}
