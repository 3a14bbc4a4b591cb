// Runs that the page in a browser steps, tried without a browser.
#include "demos/pictures/live/live_run.h"

#include "demos/base/text/errors.h"
#include "demos/scenes/catalogue.h"
#include "engine/bodies/diagnostics.h"
#include "tests/catch.h"
#include "tests/demos/program.h"

#include <fmt/format.h>

using namespace pushfactor;
using namespace pushfactor::demos;
using pictures::live::LiveRun;

TEST_CASE("the command that the page shows makes the same run, up to the same step") {
    const tests::Folder folder;
    const auto agrees = [&](const std::string& scene, const OptionTexts& options, const std::vector<long>& steps) {
        LiveRun run(scene, options);
        for (const long some : steps) run.advance(some);
        INFO(run.command());
        const tests::Ended ended = shell(folder, run.command() + " --summary run.json");
        INFO(ended.err);
        REQUIRE(ended.status == 0);
        const Json summary = parse_json(folder.read("run.json"));
        CHECK(summary["state_hash"] == run.state_hash());
        CHECK(summary["steps"] == run.simulation().sample().step);
    };
    agrees("intersecting-stack", {{"preset", "paper"}, {"push", "single-frame"}, {"gap", "-0.7"}}, {30, 1, 9});
    agrees("stack", {{"preset", "paper"}, {"dt", "1/50"}}, {7});
    agrees("pendulum-grid", {{"preset", "default"}}, {20});
    agrees("chain", {{"preset", "exact"}, {"dt", "0.007"}}, {33});
    folder.write("my scene.json", tests::read_file(PUSHFACTOR_SOURCE_DIR "/assets/scenes/conveyor.json"));
    const auto before = std::filesystem::current_path();
    std::filesystem::current_path(folder.path());
    agrees("my scene.json", {{"rest", "off"}}, {25});
    std::filesystem::current_path(before);
}

TEST_CASE("the page gets the state with its last bit, and a line of measures for each step") {
    LiveRun run("intersecting-stack", {{"preset", "paper"}});
    CHECK(run.numbers()[2] == 1.0);  // of the start
    run.advance(12);
    const std::vector<double> numbers = run.numbers();
    const auto& bodies = run.simulation().scene().world.bodies;
    REQUIRE(numbers[0] == 12.0);
    REQUIRE(numbers[2] == 12.0);
    REQUIRE(numbers[3] == static_cast<double>(bodies.size()));
    REQUIRE(numbers[4] == 5.0);
    REQUIRE(numbers.size() == 6 + 6 * 12 + 7 * bodies.size() + 6 * 5 + 15 * static_cast<std::size_t>(numbers[5]));
    const std::size_t positions = 6 + 6 * 12, velocities = positions + 7 * bodies.size();
    double upwards = 0.0;
    for (std::size_t i = 1; i < bodies.size(); ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto axis = static_cast<Eigen::Index>(k);
            CHECK(numbers[positions + 3 * i + k] == bodies[i].position[axis]);
            CHECK(numbers[velocities + 6 * (i - 1) + k] == velocity(bodies[i])[axis]);
        }
        upwards = std::max(upwards, velocity(bodies[i]).y());
    }
    CHECK(numbers[positions - 1] == upwards);
    CHECK(run.numbers()[2] == 0.0);  // none since
}

TEST_CASE("the page refuses what the command line refuses, in the same words") {
    const auto refused = [](const std::string& scene, const OptionTexts& options) -> std::string {
        try {
            LiveRun run(scene, options);
        } catch (const UsageError& error) {
            return error.what();
        }
        return "not refused";
    };
    CHECK(refused("stack", {{"beta", "2"}}) == "--beta 2: must be a number from 0 to 1");
    CHECK(refused("stack", {{"count", "0"}}).find("--count 0: must be") == 0);
    CHECK(refused("stak", {}).find("scene stak: must be one of") == 0);
    CHECK(refused("stack", {{"preset", "best"}}).find("--preset best: must be one of") == 0);
}

TEST_CASE(
    "the page's menu has every scene with its parameters, every preset, and the options that make sense there") {
    const Json menu = pictures::live::menu();
    CHECK(menu["scenes"].size() == catalogue().size());
    CHECK(menu["presets"].size() == presets().size());
    std::vector<std::string> options;
    for (const Json& option : menu["options"]) options.push_back(option["name"]);
    CHECK(std::count(options.begin(), options.end(), "beta") == 1);
    CHECK(std::count(options.begin(), options.end(), "seconds") == 0);
    // Each value that it shows as a preset's is one that the option takes.
    for (const Json& option : menu["options"]) {
        for (const Preset& preset : presets()) {
            const std::string value = option["values"][std::string(preset.name)];
            if (value.empty()) continue;
            INFO(option["name"] << " " << value);
            LiveRun run("stack", {{"preset", std::string(preset.name)}, {option["name"], value}});
            CHECK(run.state_hash().size() == 16);
        }
    }
}
