// Runs that are saved and resumed, and runs that become non-finite.
#include "demos/runs/checkpoint.h"

#include "demos/base/text/json.h"
#include "demos/options/named_run.h"
#include "demos/runs/simulation.h"
#include "demos/scenes/scene_file.h"
#include "tests/catch.h"
#include "tests/demos/program.h"

#include <algorithm>

using namespace pushfactor;
using namespace pushfactor::demos;
using tests::Folder;
using tests::shell;

namespace {

std::uint64_t hash_of(const Simulation& simulation) {
    return engine::state_hash(simulation.scene().world.bodies);
}

void advance(Simulation& simulation, int steps) {
    for (int i = 0; i < steps; ++i) simulation.advance();
}

// The same run, saved to a file and read again.
Simulation saved_and_read(const Choices& choices, const Simulation& run) {
    const Folder folder;
    folder.write("saved.json", scene_file_text(resumed(spelled_out(choices), run.scene(), run.checkpoint())));
    const Choices read = understand((folder / "saved.json").string(), {});
    return Simulation(read);
}

std::string hash_after(const Folder& folder, const std::string& scene) {
    REQUIRE(shell(folder, "pushfactor run " + scene + " --seconds 1 --summary s.json").status == 0);
    return parse_json(folder.read("s.json")).at("state_hash");
}

void step(BuiltScene& scene, const Settings& settings, int steps) {
    for (int i = 0; i < steps; ++i) scene.step(scene.world, settings.dt.value());
}

struct Case {
    std::string scene;
    OptionTexts options;
    int steps;  // before it is saved
};

const std::vector<Case> cases{
    {"stack", {}, 70},
    {"stack", {{"jitter", "0.01"}, {"friction-model", "coulomb"}}, 45},
    {"stack", {{"preset", "paper"}}, 60},
    {"stack", {{"preset", "exact"}, {"gap", "-0.001"}}, 20},
    {"stack", {{"solver", "nncg"}, {"substeps", "3"}}, 50},
    {"intersecting-stack", {}, 5},
    {"heavy-on-light", {{"substeps", "auto"}}, 30},
    {"funnel", {}, 60},
    {"pendulum-grid", {{"poke", "60"}, {"poke-at", "0.5"}}, 20},
    {"pendulum-grid", {{"poke", "60"}, {"poke-at", "0.5"}}, 40},
    {"pendulum-wave", {}, 40},
    {"pendulum-wave", {{"scheme", "rattle4"}, {"tolerance", "1e-12"}}, 40},
    {"chain", {{"end-mass", "1000"}, {"substeps", "auto"}}, 61},
    {"chain", {{"links", "5"}, {"preset", "paper"}}, 61},
    {"bridge", {}, 20},
    {"restitution", {}, 50},
    {"conveyor", {}, 50},
    {"starting_belt", {}, 100},  // before the belt runs, at rest
    {"newtons_cradle", {}, 50},
    {"moved", {}, 50},
    {"moved", {{"rest", "on"}}, 331},
    {"stack", {{"rest", "on"}}, 75},  // before it rests, and when it does
    {"stack", {{"rest", "on"}}, 100},
    {"pendulum-grid", {{"poke", "60"}, {"poke-at", "0.5"}, {"rest", "on"}}, 40},
    {"funnel", {{"count", "20"}, {"rest", "on"}}, 400},
};

// Two masses that a force drives apart until the length of their bar overflows.
const std::string runaway = R"({"version": 1, "name": "runaway", "bodies": [
    {"name": "left", "shape": "sphere", "radius_m": 1, "mass_kg": 1, "velocity_m_per_s": [-1e200, 0, 0]},
    {"name": "right", "shape": "sphere", "radius_m": 1, "mass_kg": 2, "position_m": [3, 0, 0],
     "velocity_m_per_s": [1e200, 0, 0]}], "contacts": true})";

// A force that begins at 0.2 s and makes the state non-finite in a few steps, next to a stack that has caches.
std::string late() {
    SceneDescription stack = run_of("stack", {{"gap", "-0.001"}}).description;
    stack.name = "late";
    stack.forces.push_back({.body = "cube 3", .force = {0, 1e307, 0}, .from = 0.2});
    stack.forces.push_back({.body = "cube 3", .force = {0, 1.7e308, 0}, .from = 0.25});
    stack.forces.push_back({.body = "cube 3", .force = {0, 1.7e308, 0}, .from = 0.25});
    return scene_file_text(stack);
}

std::vector<std::string> sorted(std::vector<std::string> names) {
    std::sort(names.begin(), names.end());
    return names;
}

std::string between(const std::string& text, const std::string& before, const std::string& after) {
    const std::size_t begin = text.find(before) + before.size();
    return text.substr(begin, text.find(after, begin) - begin);
}

}  // namespace

TEST_CASE("a scene that is taken back to a checkpoint moves as it did before") {
    auto all = cases;
    all.push_back({"stack", {}, 160});          // comes to rest
    all.push_back({"pendulum-grid", {}, 300});  // the same
    for (const Case& tried : all) {
        INFO(tried.scene << " after step " << tried.steps);
        const Choices choices = run_of(tried.scene, tried.options);
        BuiltScene scene = build_scene(choices);
        step(scene, choices.settings, tried.steps);
        Checkpoint before;
        take_checkpoint(scene, 1.0, before);
        step(scene, choices.settings, 40);
        const std::uint64_t once = engine::state_hash(scene.world.bodies);
        go_back(scene, before);
        CHECK(scene.world.time() == before.state.time);
        step(scene, choices.settings, 40);
        CHECK(engine::state_hash(scene.world.bodies) == once);
    }
}

TEST_CASE("a saved run goes on to the bits of the run that was not interrupted, caches and substeps included") {
    for (const Case& one : cases) {
        INFO(command_text("run", one.scene, one.options) << " saved after " << one.steps << " steps");
        const Choices choices = run_of(one.scene, one.options);
        Simulation whole(choices);
        advance(whole, one.steps);
        Simulation resumed = saved_and_read(choices, whole);
        CHECK(hash_of(resumed) == hash_of(whole));
        for (const int steps : {1, 1, 38}) {
            advance(whole, steps);
            advance(resumed, steps);
            CHECK(hash_of(resumed) == hash_of(whole));
        }
    }
}

TEST_CASE(
    "without the forces of the last step a run goes on to other bits, so that the caches are what was tested") {
    for (const char* const scene : {"stack", "pendulum-grid"}) {
        const Choices choices = run_of(scene, {{"solver", "pgs"}});
        Simulation whole(choices);
        advance(whole, 60);
        SceneDescription forgetful = resumed(spelled_out(choices), whole.scene(), whole.checkpoint());
        RunState state = *forgetful.state;
        state.contact_forces = {};
        for (engine::DistanceForce& force : state.distance_forces) force = {};
        forgetful.state = std::make_shared<RunState>(state);
        Simulation other(build_scene(forgetful, choices.settings), choices.settings);
        advance(whole, 2);
        advance(other, 2);
        CHECK(hash_of(other) != hash_of(whole));
    }
}

TEST_CASE("what earlier versions saved of their solver is read and changes nothing, and wrong values are refused") {
    const auto text = [](const std::string& memory) {
        return R"({"version": 1, "bodies": [
        {"name": "one", "shape": "sphere", "radius_m": 0.1, "mass_kg": 1, "position_m": [0, -1, 0]},
        {"name": "two", "shape": "sphere", "radius_m": 0.1, "mass_kg": 1, "position_m": [3, -1, 0]}],
        "distance_constraints": [{"a": {"body": "world"}, "b": {"body": "one"}}],
        "state": {"time_s": 1.5, )" +
               memory + R"( "distance_forces_n": [[-10, -10]]}})";
    };
    const Folder folder;
    folder.write("plain.json", text(""));
    const std::string plain = hash_after(folder, "plain.json");
    for (const std::string memory : {R"("solved_exactly": true, "kept_steps": 4,)",
                                     R"("warm_start": [{"bodies": ["one"], "solved_exactly": true, "kept_steps": 7,
             "exact_debt_multiply_adds": 1e6, "exact_failures": 2}],)"}) {
        folder.write("old.json", text(memory));
        CHECK(hash_after(folder, "old.json") == plain);
    }
    folder.write("wrong.json", text(R"("warm_start": [{"bodies": ["one"], "kept_steps": 0.5}],)"));
    CHECK(shell(folder, "pushfactor run wrong.json").status == 2);
}

TEST_CASE("the program saves the state at the end, and going on from it is going on") {
    const Folder folder;
    REQUIRE(
        shell(folder, "pushfactor run stack --seconds 1 --save-state one.json --summary one-summary.json").status ==
        0);
    const std::string on = shell(folder, "pushfactor run one.json --seconds 1").out;
    const std::string whole = shell(folder, "pushfactor run stack --seconds 2").out;
    CHECK(between(on, "\"state_hash\": \"", "\"") == between(whole, "\"state_hash\": \"", "\""));
    // And reading and writing it again gives the same file.
    shell(folder, "pushfactor scene one.json > again.json");
    CHECK(folder.read("again.json") == folder.read("one.json"));
}

TEST_CASE("a run that leaves the finite numbers writes its last good state, which fails alike in its first step") {
    for (const auto& [name, text] : {std::pair{std::string("runaway"), runaway}, {std::string("late"), late()}}) {
        const Folder folder;
        folder.write("my.json", text);
        const tests::Ended first = shell(folder, "pushfactor run my.json");
        INFO(first.err);
        CHECK(first.status == 5);
        CHECK(first.out.empty());
        const std::string what = between(first.err, name + ": ", " is not finite");
        CHECK_THAT(what, Catch::StartsWith("body "));
        const std::string file = between(first.err, "is in ", "\n");
        CHECK(file == name + "-last-good.json");
        CHECK(folder.files() == sorted({file, "my.json"}));

        const std::string saved = folder.read(file);
        const tests::Ended second = shell(folder, "pushfactor run " + file);
        CHECK(second.status == 5);
        CHECK_THAT(second.err, Catch::Contains(name + ": " + what + " is not finite after step 1 "));
        // Its output exists already.
        CHECK(folder.files() == sorted({file, "my.json"}));
        CHECK(folder.read(file) == saved);
    }
}

TEST_CASE("a run that leaves the finite numbers keeps the steps before that in its CSV files, and no other file") {
    for (const std::string command : {"run late.json", "render late.json --at 0,1 --size 64x36 --out frames"}) {
        const Folder folder;
        folder.write("late.json", late());
        const tests::Ended ended = shell(folder, "pushfactor " + command +
                                                     " --seconds 10 --csv steps.csv --rows "
                                                     "rows.csv --summary summary.json "
                                                     "--save-state state.json");
        INFO(ended.err);
        CHECK(ended.status == 5);
        const long failed = std::stol(between(ended.err, "not finite after step ", " "));
        REQUIRE(failed > 1);
        const std::vector<std::string> lines = tests::lines_of(folder.read("steps.csv"));
        CHECK(static_cast<long>(lines.size()) == failed);  // header and earlier steps
        CHECK(lines.back().starts_with(std::to_string(failed - 1) + ","));
        CHECK_THAT(ended.err,
                   Catch::Contains("note: steps.csv holds the run up to step " + std::to_string(failed - 1) + ","));
        CHECK(folder.read("rows.csv").ends_with("\n"));
        for (const std::string& name : folder.files()) {
            INFO(name);
            CHECK(!name.ends_with("summary.json"));
            CHECK(!name.ends_with("state.json"));
            CHECK(!name.ends_with(".partial"));
        }
    }
}

TEST_CASE("the last good state lies beside the outputs, and replaces nothing") {
    const Folder folder;
    folder.write("my.json", runaway);
    std::filesystem::create_directory(folder / "out");
    folder.write("out/runaway-last-good.json", "precious");
    const tests::Ended ended = shell(folder, "pushfactor run my.json --csv out/steps.csv");
    CHECK(ended.status == 5);
    CHECK_THAT(ended.err, Catch::Contains("is in out/runaway-last-good-2.json"));
    CHECK(folder.read("out/runaway-last-good.json") == "precious");
    CHECK(folder.files() == std::vector<std::string>{"my.json", "out/runaway-last-good-2.json",
                                                     "out/runaway-last-good.json", "out/steps.csv"});

    const tests::Ended rendered = shell(folder, "pushfactor render my.json --at 0,1 --size 64x36 --out frames");
    CHECK(rendered.status == 5);
    CHECK_THAT(rendered.err, Catch::Contains("is in frames/runaway-last-good.json"));
    CHECK(folder.read("frames/at_0s.png").ends_with(std::string("IEND\xAE\x42\x60\x82")));

    const tests::Ended nowhere =
        shell(folder, "pushfactor run my.json --summary none/summary.json");  // its folder is made
    CHECK(nowhere.status == 5);
    CHECK_THAT(nowhere.err, Catch::Contains("is in none/runaway-last-good.json"));
}

// Its angle alone does not tell how often it has turned.
TEST_CASE("a servo that is resumed more than a turn from its start goes on towards its angle") {
    const Folder folder;
    folder.write("servo.json", R"({"version": 1, "gravity_m_per_s2": [0, 0, 0], "bodies": [
        {"name": "arm", "shape": "box", "size_m": [1, 0.1, 0.1], "mass_kg": 2, "position_m": [0.5, 0, 0]}],
        "joints": [{"type": "hinge", "a": {"body": "world"}, "b": {"body": "arm", "point_m": [-0.5, 0, 0]},
        "axis": [0, 0, 1], "motor": {"target_angle_rad": 9, "stiffness_n_m_per_rad": 20,
        "damping_n_m_s_per_rad": 4}}]})");
    const Choices choices = understand((folder / "servo.json").string(), {});
    Simulation whole(choices);
    advance(whole, 90);
    REQUIRE(whole.scene().joints->angles()[0] > 7.0);
    Simulation resumed = saved_and_read(choices, whole);
    advance(whole, 200);
    advance(resumed, 200);
    CHECK(hash_of(resumed) == hash_of(whole));
    CHECK(resumed.scene().joints->angles()[0] == Approx(9.0).epsilon(1e-6));
}
