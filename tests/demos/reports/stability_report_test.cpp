// The stability report command: its table, thumbnails, commands that show the same; and how a case is judged.
#include "demos/reports/stability/stability.h"
#include "tests/catch.h"
#include "tests/demos/csv.h"
#include "tests/demos/pages/check_page.h"
#include "tests/demos/program.h"

#include <set>

using namespace pushfactor::tests;
using namespace pushfactor::demos::reports::stability;
using pushfactor::demos::SceneDescription;

namespace {

std::string after(const std::string& text, const std::string& words) {
    const auto at = text.find(words);
    return at == std::string::npos ? "" : text.substr(at + words.size());
}

// A stack of five for one step.
Case short_case() {
    return {.name = "short",
            .scene = "stack",
            .options = {{"seconds", "0.02"}},
            .wanted = "creep",
            .checks = {{.measure = "max_penetration_m", .bar = 1.0}}};
}

struct Judged {
    std::string outcome;
    bool met = false, holds = false;
};

Judged judged(const Case& one, const Expected& expected) {
    const Folder folder;
    write_scenes({{.name = "chapter", .heading = "Chapter", .cases = {one}}}, folder.path());
    Trial trial(one, expected, folder.path());
    trial.judge(trial.run(PUSHFACTOR_PROGRAM, [] {}));
    return {trial.outcome(), trial.verdicts().front().met, trial.holds()};
}

}  // namespace

TEST_CASE("the quick stability report holds, shows every end, and its commands show the same", "[long]") {
    const Folder folder;
    const Ended ended = shell(folder, "pushfactor report stability --quick --out .");
    INFO(ended.err);
    REQUIRE(ended.status == 0);
    CHECK(ended.out == "./index.html\n");

    const auto lines = table_of(folder.read("stability.csv"));
    CHECK(lines.front() == std::vector<std::string>{"case", "preset", "outcome", "expected", "measure", "value",
                                                    "bar", "holds", "command"});
    std::set<std::string> presets;
    int misses = 0;
    for (std::size_t i = 1; i < lines.size(); ++i) {
        INFO(lines[i].front());
        REQUIRE(lines[i].size() == 9);
        presets.insert(lines[i][1]);
        // The paper's method misses some bars, as is known.
        const bool may_miss =
            lines[i][1] == "paper" || lines[i][3].find(" instead of the bar") != std::string::npos;
        CHECK((lines[i][7] == "yes" || (may_miss && lines[i][7] == "known miss")));
        misses += lines[i][7] == "known miss";
        CHECK(lines[i][8].starts_with("pushfactor run "));
    }
    CHECK(presets == std::set<std::string>{"default", "exact", "paper"});
    CHECK(misses > 0);

    const std::string page = folder.read("index.html");
    check_page(page);
    for (const char* const chapter : {"heavy-on-light", "impacts", "chains", "bounces"}) {
        CHECK(page.find(std::string("<img src=\"") + chapter + ".png\"") != std::string::npos);
        CHECK(std::filesystem::file_size(folder / (std::string(chapter) + ".png")) > 3000);
    }
    for (const char* const name : {"cube-200-m-per-s-from-4.1", "at-1e6-m", "chain-1000-kg"}) {
        const auto line = std::find_if(lines.begin(), lines.end(), [&](const auto& l) { return l[0] == name; });
        REQUIRE(line != lines.end());
        const Ended again = shell(folder, (*line)[8]);
        CHECK(again.status == 0);
        CHECK(after(again.out, "\"outcome\": \"").starts_with((*line)[2] + '"'));
        const std::string value = after(again.out, "\"" + fields_of((*line)[4]).front() + "\": ");
        CHECK(std::stod(value) == std::stod((*line)[5]));
    }
}

TEST_CASE("a run that fails is exit 3 and named, and the others are judged all the same") {
    const Folder folder;
    std::filesystem::create_directories(folder / "runs/bouncing-ball-exact.json");  // in place of its summary
    const std::string command = "pushfactor report stability --quick --only bounces,turning --out .";
    const Ended ended = shell(folder, command);
    CHECK(ended.status == 3);
    INFO(ended.err);
    CHECK(ended.err.find("the first is bouncing-ball (exact): failed") != std::string::npos);
    CHECK(std::count(ended.err.begin(), ended.err.end(), '\n') == 1);
    int unexpected = 0;
    const auto lines = table_of(folder.read("stability.csv"));
    for (const auto& line : lines) unexpected += line[7] == "no" ? 1 : 0;
    CHECK(unexpected == 1);
    CHECK(lines.size() == 1 + 3 + 9);
    const std::string page = folder.read("index.html");
    check_page(page);
    CHECK(page.find("fails: </span>1</span>") != std::string::npos);

    // A run that failed is not kept as a piece, so that it is made again once the reason is gone.
    std::filesystem::remove(folder / "runs/bouncing-ball-exact.json");
    CHECK(shell(folder, command).status == 0);
}

TEST_CASE("a case holds when its outcome is the expected or the wanted one and its bars are met") {
    Case one = short_case();
    CHECK(judged(one, {.preset = "default", .outcome = "creep"}).holds);
    CHECK(judged(one, {.preset = "default", .outcome = "fall"}).holds);  // better than expected
    one.wanted = "rest";
    CHECK(!judged(one, {.preset = "default", .outcome = "rest"}).holds);
    CHECK(judged(one, {.preset = "default", .outcome = "creep"}).holds);
    one.checks = {{.measure = "max_penetration_m", .bar = 1.0, .target = 2.0}};  // |0 - 2|
    CHECK(judged(one, {.preset = "default", .outcome = "creep"}).holds);
    CHECK(judged(one, {.preset = "default", .outcome = "creep", .reached = {2.5}}).holds);
    CHECK(!judged(one, {.preset = "default", .outcome = "creep", .reached = {1.5}}).holds);
}

TEST_CASE("a bar that is missed holds up to what is known to be reached, on either side") {
    Case one = short_case();
    one.checks = {{.measure = "max_penetration_m", .bar = 0.25, .target = 2.0, .scale = 4.0}};  // |0 - 2| / 4
    CHECK(!judged(one, {"default", "creep"}).holds);
    CHECK(!judged(one, {"default", "creep", {0.45}}).holds);
    const Judged known = judged(one, {"default", "creep", {0.55}});
    CHECK(known.holds);
    CHECK(!known.met);
    one.checks.front().bar = 0.5;
    CHECK(judged(one, {"default", "creep"}).met);
    one.checks.front().bar = 0.6;
    one.checks.front().at_least = true;
    CHECK(!judged(one, {"default", "creep"}).holds);
    CHECK(judged(one, {"default", "creep", {0.4}}).holds);
}

TEST_CASE("of several bodies the worst is judged, on either side of the target") {
    Case one = short_case();
    SceneDescription cubes = cubes_in_16_directions(3.0, 0.3, false);
    cubes.bodies[3].velocity *= 0.5;  // and of all others the last speed is about 2.9 m/s
    one.scene = cubes;
    one.wanted = "moving";
    one.checks = {{.measure = "last_speed_m_per_s", .bar = 1.0, .target = 2.9}};
    CHECK(!judged(one, {"default", "moving"}).holds);
    one.checks.front().bar = 1.6;
    CHECK(judged(one, {"default", "moving"}).holds);
    one.checks.front() = {.measure = "last_speed_m_per_s", .bar = 2.0, .at_least = true};
    CHECK(!judged(one, {"default", "moving"}).holds);
    one.checks.front().bar = 1.0;
    CHECK(judged(one, {"default", "moving"}).holds);
}

TEST_CASE("the stability report refuses what it does not know in one line") {
    check_refused("report stabilty", "did you mean stability?");
    check_refused("report stability --only chain", "did you mean chains?");
    check_refused("report stability --export x", "--export x: must be with report error");
    CHECK(run_program("report stability --quick --out /dev/null/x").status == 4);
}
