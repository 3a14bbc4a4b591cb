// A scene that is shifted, turned about the vertical, mirrored or measured in other units behaves like the
// original.
//
// Where a transformation only moves exponents (powers of two whose roots are powers of two) or signs, the result
// agrees bit for bit; a deviation means a constant with a unit somewhere in the engine. Elsewhere it agrees up to
// rounding errors and their growth during the run.
#include "engine/bodies/diagnostics.h"
#include "tests/catch.h"
#include "tests/demos/scenes/similar_scene.h"
#include "tests/scene_fixture.h"
#include "tests/settings.h"

#include <numbers>

using namespace pushfactor;
using namespace pushfactor::demos;
using engine::Quaternion;
using engine::Vector3;
using tests::Similarity;

namespace {

struct Case {
    std::string name;
    SceneDescription scene;
    double seconds = 1.0;
};

SceneDescription describe(std::string_view scene,
                          std::initializer_list<std::pair<std::string_view, std::string_view>> parameters) {
    const SceneEntry& entry = *find_scene(scene);
    ParameterValues values(entry.parameters);
    for (const auto& [name, text] : parameters) {
        for (const Parameter& parameter : entry.parameters) {
            if (parameter.name == name) values.set(parameter, text);
        }
    }
    return entry.describe(values);
}

// Boxes tumble onto the ground and a ball, with friction and a rebound: nothing is aligned, so rounding decides no
// tie.
SceneDescription tumbling_boxes() {
    SceneDescription scene;
    scene.name = "tumbling boxes";
    scene.contacts = true;
    scene.bodies.push_back({.name = "ground", .shape = PlaneShape{}});
    scene.bodies.push_back({.name = "ball", .shape = SphereShape{0.5}, .mass = 2.0, .position = {0.1, 0.5, 0.2}});
    for (int i = 0; i < 3; ++i) {
        const double turn = 0.4 + 0.5 * i;
        scene.bodies.push_back({.name = "box " + std::to_string(i + 1),
                                .shape = BoxShape{{0.9, 0.5, 0.7}},
                                .mass = 1.0 + i,
                                .position = {0.3 * i - 0.2, 1.6 + 1.1 * i, 0.25 * i},
                                .orientation = Quaternion(Eigen::AngleAxisd(turn, Vector3(1, 2, 3).normalized())),
                                .velocity = {0.5, -1.0, 0.25 * i},
                                .angular_velocity = {1.0, 0.3 * i, -2.0},
                                .restitution = 0.5 * (i % 2)});
    }
    scene.forces.push_back({.body = "box 2", .force = {3, 1, -2}, .from = 0.25, .until = 0.5});
    return scene;
}

std::vector<Case> cases_of_balls() {
    return {{"funnel", describe("funnel", {{"count", "5"}}), 1.5},
            {"chain", describe("chain", {{"links", "6"}, {"end-mass", "10"}, {"angle", "70"}}), 2.0},
            {"wave", describe("pendulum-wave", {}), 1.0}};
}

std::vector<Case> all_cases() {
    auto cases = cases_of_balls();
    cases.push_back({"stack", describe("stack", {{"count", "3"}, {"jitter", "0.05"}, {"gap", "0.1"}}), 1.0});
    cases.push_back({"grid", describe("pendulum-grid", {{"poke", "60"}, {"poke-at", "0.25"}}), 0.5});
    cases.push_back({"tumbling boxes", tumbling_boxes(), 1.0});
    return cases;
}

std::vector<engine::Body> bodies_after(const SceneDescription& scene, const Settings& settings) {
    Simulation simulation(build_scene(scene, settings), settings);
    for (long step = whole_steps(settings); step > 0; --step) simulation.advance();
    return simulation.scene().world.bodies;
}

struct Outcomes {
    std::vector<engine::Body> expected, found;
};

Outcomes run_both(
    const Case& test, const std::string& preset, const Similarity& similarity,
    Settings (*change)(Settings) = [](Settings settings) { return settings; }) {
    Settings settings = change(tests::awake_settings(preset));
    settings.seconds = test.seconds;
    // Convex: with Coulomb's bound a moving heap has several solutions, and rounding decides between them.
    settings.friction_model = FrictionModel::paper;
    Outcomes outcomes{.expected = bodies_after(test.scene, settings),
                      .found = bodies_after(similarity.map(test.scene), similarity.map(settings))};
    for (engine::Body& body : outcomes.expected) body = similarity.map(body);
    return outcomes;
}

// Number for number; a zero may have the other sign. The last body may be the world, which is not transformed.
void check_equal(const Outcomes& outcomes) {
    for (std::size_t i = 0; i < outcomes.expected.size(); ++i) {
        const engine::Body& expected = outcomes.expected[i];
        const engine::Body& found = outcomes.found[i];
        if (expected.is_static()) continue;
        INFO("body " << i);
        CHECK(found.position == expected.position);
        CHECK(found.orientation.coeffs() == expected.orientation.coeffs());
        CHECK(found.linear_momentum == expected.linear_momentum);
        CHECK(found.angular_momentum == expected.angular_momentum);
    }
}

// Largest difference of positions [m] and of orientations [rad].
double difference(const Outcomes& outcomes) {
    double largest = 0.0;
    for (std::size_t i = 0; i < outcomes.expected.size(); ++i) {
        const engine::Body& expected = outcomes.expected[i];
        const engine::Body& found = outcomes.found[i];
        if (expected.is_static()) continue;
        largest = std::max(largest, (found.position - expected.position).norm());
        largest = std::max(largest, 2.0 * (found.orientation.conjugate() * expected.orientation).vec().norm());
    }
    return largest;
}

constexpr std::array presets_of_interest{"default", "exact", "paper"};

}  // namespace

TEST_CASE("with masses four times as large everything moves as before, bit for bit") {
    for (const Case& test : all_cases()) {
        for (const char* preset : presets_of_interest) {
            INFO(test.name << ", " << preset);
            check_equal(run_both(test, preset, {.mass = 4.0}));
        }
    }
}

TEST_CASE("a scene of a quarter of the size in half the time does the same, bit for bit") {
    for (const Case& test : all_cases()) {
        for (const char* preset : presets_of_interest) {
            INFO(test.name << ", " << preset);
            check_equal(run_both(test, preset, {.length = 0.25, .time = {1, 2}}));
        }
    }
}

TEST_CASE("each unit may be another power of two alone, and heaps do not notice: no constant has a unit") {
    // Masses by powers of four, because the solvers take their roots.
    const std::array units{
        std::pair{"lengths", Similarity{.length = 4.0}},
        std::pair{"small", Similarity{.length = 1.0 / 1024}},
        std::pair{"times", Similarity{.time = {1, 2}}},
        std::pair{"slow", Similarity{.time = {64, 1}}},
        std::pair{"all", Similarity{.length = 2.0, .mass = 4.0, .time = {1, 4}}},
    };
    auto cases = all_cases();
    cases.push_back({"heap", describe("funnel", {{"count", "30"}}), 4.0});
    cases.push_back({"pyramid of jittered cubes", describe("stack", {{"count", "12"}, {"jitter", "0.1"}}), 2.0});
    for (const Case& test : cases) {
        for (const char* preset : presets_of_interest) {
            for (const auto& [name, similarity] : units) {
                INFO(test.name << ", " << preset << ", " << name);
                check_equal(run_both(test, preset, similarity));
            }
        }
    }
}

TEST_CASE("a scene of balls in a mirror is the mirrored scene, bit for bit") {
    for (const Case& test : cases_of_balls()) {
        for (const char* preset : presets_of_interest) {
            INFO(test.name << ", " << preset);
            check_equal(run_both(test, preset, {.mirrored = true}));
        }
    }
}

TEST_CASE("shifted, turned about the vertical, or in other units, a scene does the same to rounding") {
    const Quaternion turn(Eigen::AngleAxisd(0.7, Vector3::UnitY()));
    const std::array similarities{
        std::pair{"shifted", Similarity{.shift = {10, 20, -30}}},         // measured at most 3.1e-11 without margin
        std::pair{"turned", Similarity{.turn = turn}},                    // 1.3e-11
        std::pair{"masses", Similarity{.mass = 10.0}},                    // 1.9e-12
        std::pair{"lengths", Similarity{.length = 9.0, .time = {3, 1}}},  // 3.9e-10
        std::pair{"thirds", Similarity{.length = 1.0 / 3.0}},
        std::pair{"sevenfold", Similarity{.length = 7.0}},
    };
    for (const Case& test : all_cases()) {
        for (const char* preset : presets_of_interest) {
            for (const auto& [name, similarity] : similarities) {
                INFO(test.name << ", " << preset << ", " << name);
                // A point that lands within the margin ends slightly below the surface, or by a rounding error is
                // there already: that may change a thousandth of the slop.
                const bool lands = test.name == std::string("stack") && preset == std::string("default");
                CHECK(difference(run_both(test, preset, similarity)) < (lands ? 1e-5 : 1e-8));
            }
        }
    }
}

TEST_CASE("a scene of boxes in a mirror is the mirrored scene, to rounding, once each step is solved") {
    // A mirror reverses the order of a box's corners, so truncated sweeps end elsewhere: after a second the paper's
    // 25 sweeps leave the tumbling boxes 0.67 m apart. Measured with all solved: at most 1.3e-11.
    const auto solved = [](Settings settings) {
        if (settings.preset == "paper") return tests::solved_exactly(settings);
        settings.solver = "direct";  // what lands takes small steps otherwise, by sweeps
        return settings;
    };
    for (const Case& test : all_cases()) {
        for (const char* preset : presets_of_interest) {
            INFO(test.name << ", " << preset);
            CHECK(difference(run_both(test, preset, {.mirrored = true}, solved)) < 1e-8);
        }
    }
}
