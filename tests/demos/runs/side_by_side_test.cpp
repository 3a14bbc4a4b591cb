// Distant events do not interact: scenes in one world, too far apart to touch, behave bit for bit as each of them
// alone.
#include "demos/scenes/named/side_by_side.h"

#include "engine/bodies/diagnostics.h"
#include "tests/catch.h"
#include "tests/demos/scenes/similar_scene.h"
#include "tests/random.h"
#include "tests/scene_fixture.h"
#include "tests/settings.h"

#include <map>
#include <tuple>

using namespace pushfactor;
using namespace pushfactor::demos;
using demos::scenes::side_by_side;
using engine::Quaternion;
using engine::Vector3;

namespace {

constexpr double far = 200.0;  // m
constexpr int steps = 150;

// Planes are infinite, so nothing would be outside them: the same face on a slab of 30 m instead.
SceneDescription on_slabs(SceneDescription scene) {
    for (BodyDescription& body : scene.bodies) {
        if (!std::holds_alternative<PlaneShape>(body.shape)) continue;
        body.shape = BoxShape{{30.0, 2.0, 30.0}};
        body.position -= body.orientation * Vector3::UnitY();
    }
    return scene;
}

// Balls thrown into rows of balls: each ball that is hit hits the next, which only a repeated search finds.
SceneDescription skittles() {
    SceneDescription scene;
    scene.name = "skittles";
    scene.contacts = true;
    scene.bodies.push_back({.name = "ground", .shape = PlaneShape{}});
    for (int row = 0; row < 3; ++row) {
        for (int i = 0; i < 5; ++i) {
            BodyDescription ball{.name = "ball " + std::to_string(row) + " " + std::to_string(i),
                                 .shape = SphereShape{0.5},
                                 .mass = 1.0 + 0.3 * i};
            ball.position = {1.2 * i + 0.1 * row, 0.5, 3.0 * row + 0.05 * i};
            if (i == 0) ball.velocity = {80.0 - 30.0 * row, 0, 0};
            ball.restitution = 0.5 * row;
            scene.bodies.push_back(ball);
        }
    }
    return scene;
}

std::vector<SceneDescription> all_scenes() {
    std::vector<SceneDescription> scenes;
    const std::map<std::string_view, std::map<std::string_view, std::string_view>> given{
        {"dominoes", {{"count", "8"}}}, {"platonic", {{"count", "3"}}}};
    for (const SceneEntry& entry : catalogue()) {
        ParameterValues values(entry.parameters);
        for (const Parameter& parameter : entry.parameters) {
            const auto own = given.find(entry.name);
            if (own == given.end() || !own->second.contains(parameter.name)) continue;
            REQUIRE(values.set(parameter, own->second.at(parameter.name)));
        }
        scenes.push_back(entry.describe(values));
    }
    scenes.push_back(skittles());
    return scenes;
}

Settings fixed_settings(const std::string& preset) {
    Settings settings = tests::awake_settings(preset);
    settings.substeps = 1;
    settings.start_kick = StartKick::off;
    return settings;
}

using State = std::vector<engine::Body>;  // of movable bodies

State state_after(const SceneDescription& scene, const Settings& settings, int count) {
    Simulation simulation(build_scene(scene, settings), settings);
    for (int i = 0; i < count; ++i) simulation.advance();
    State bodies = simulation.scene().world.bodies;
    std::erase_if(bodies, [](const engine::Body& body) { return body.is_static(); });
    return bodies;
}

std::uint64_t hash_of(const State& state, std::size_t first, std::size_t count) {
    return engine::state_hash(std::span(state).subspan(first, count));
}

// The states of the scenes in a common world, one after the other, in the order given.
void check_alike(const std::vector<SceneDescription>& parts, const std::vector<State>& alone,
                 const Settings& settings, int count) {
    const State together = state_after(side_by_side("all", parts), settings, count);
    std::size_t first = 0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        INFO(parts[i].name << ", part " << i + 1 << " of " << parts.size());
        REQUIRE(first + alone[i].size() <= together.size());
        CHECK(hash_of(together, first, alone[i].size()) == hash_of(alone[i], 0, alone[i].size()));
        first += alone[i].size();
    }
    CHECK(first == together.size());
}

}  // namespace

TEST_CASE("two scenes in one world equal each of them alone, bit for bit: every pair, every preset, either first") {
    const std::vector<SceneDescription> scenes = all_scenes();
    const tests::Similarity shift{.shift = {far, 0, 0}};
    std::vector<SceneDescription> here, there;
    for (const SceneDescription& scene : scenes) {
        here.push_back(on_slabs(scene));
        there.push_back(shift.map(here.back()));
    }
    for (const char* preset : {"paper", "default", "exact"}) {
        const Settings settings = fixed_settings(preset);
        std::map<std::tuple<const SceneDescription*, bool>, State> known;
        const auto alone = [&](const SceneDescription& scene, bool contacts) {
            const auto [entry, is_new] = known.try_emplace({&scene, contacts});
            if (is_new) {
                SceneDescription own = scene;
                own.contacts = contacts;
                entry->second = state_after(own, settings, steps);
            }
            return entry->second;
        };
        for (std::size_t i = 0; i < scenes.size(); ++i) {
            for (std::size_t k = i; k < scenes.size(); ++k) {
                INFO(preset << ": " << scenes[i].name << " and " << scenes[k].name);
                const bool contacts = here[i].contacts || there[k].contacts;
                const State a = alone(here[i], contacts), b = alone(there[k], contacts);
                // In turn, so that each scene is the first of some pairs and the second of others.
                if ((i + k) % 2 == 0) {
                    check_alike({here[i], there[k]}, {a, b}, settings, steps);
                } else {
                    check_alike({there[k], here[i]}, {b, a}, settings, steps);
                }
            }
        }
    }
}

TEST_CASE("scenes that share their ground equal each of them alone, bit for bit") {
    for (const char* preset : {"paper", "default", "exact"}) {
        const Settings settings = fixed_settings(preset);
        std::vector<SceneDescription> parts;
        for (const char* name : {"stack", "intersecting-stack", "heavy-on-light"}) {
            const SceneEntry& entry = *find_scene(name);
            SceneDescription scene = entry.describe(ParameterValues(entry.parameters));
            for (BodyDescription& body : scene.bodies) {
                if (body.mass) body.position.x() += 10.0 * static_cast<double>(parts.size());
            }
            parts.push_back(scene);
        }
        std::vector<State> alone;
        for (const SceneDescription& part : parts) alone.push_back(state_after(part, settings, steps));
        INFO(preset);
        check_alike(parts, alone, settings, steps);
    }
}

TEST_CASE("a tower, a chain and a heap beside each other are three islands when they rest, and each its own") {
    const auto describe = [](const char* name, const char* parameter, const char* value) {
        const SceneEntry& entry = *find_scene(name);
        ParameterValues values(entry.parameters);
        for (const Parameter& known : entry.parameters) {
            if (known.name == parameter) values.set(known, value);
        }
        return on_slabs(entry.describe(values));
    };
    const std::vector<SceneDescription> parts{
        describe("stack", "count", "10"),
        tests::Similarity{.shift = {far, 0, 0}}.map(describe("chain", "links", "12")),
        tests::Similarity{.shift = {0, 0, far}}.map(describe("funnel", "count", "40"))};
    const Settings settings = fixed_settings("default");
    std::vector<State> alone;
    for (SceneDescription part : parts) {
        part.contacts = true;
        alone.push_back(state_after(part, settings, 600));
    }
    check_alike(parts, alone, settings, 600);

    Simulation simulation(build_scene(side_by_side("all", parts), settings), settings);
    for (int i = 0; i < 600; ++i) simulation.advance();
    int kept = 0;
    for (int i = 0; i < 60; ++i) {
        const engine::StepCount& count = simulation.advance().count;
        CHECK(count.islands == 3);
        // The chain swings, and takes small steps where its balls touch.
        CHECK(count.islands_exact + count.islands_in_small_steps >= 1);
        CHECK(count.islands_kept + count.islands_swept + count.islands_exact + count.islands_in_small_steps == 3);
        kept += count.islands_kept;
    }
    CHECK(kept > 60 + 30);  // the tower always, the heap mostly: measured 60 + 53
}

TEST_CASE("two thousand islands do the work of two thousand, each as if it were alone") {
    const auto crowd = [](int count) {
        tests::Random random(5);
        SceneDescription scene;
        scene.name = "crowd";
        scene.contacts = true;
        scene.bodies.push_back({.name = "ground", .shape = PlaneShape{}});
        for (int i = 0; i < count; ++i) {
            BodyDescription body{.name = "body " + std::to_string(i), .mass = random.in(0.5, 5.0)};
            if (i % 2 == 0) {
                body.shape = BoxShape{{1, 1, 1}};
            } else {
                body.shape = SphereShape{0.5};
            }
            body.position = {3.0 * (i % 50), random.in(0.5, 0.6), 3.0 * std::floor(i / 50.0)};
            scene.bodies.push_back(body);
        }
        return scene;
    };
    Settings settings = fixed_settings("default");
    settings.solver = "pgs";
    settings.tolerance_high = settings.tolerance_low = 0.0;
    std::map<int, double> work;
    for (const int count : {500, 1000, 2000}) {
        Simulation simulation(build_scene(crowd(count), settings), settings);
        for (int i = 0; i < 30; ++i) simulation.advance();
        CHECK(simulation.sample().count.islands == count);
        CHECK(simulation.sample().count.sweeps == 25);
        work[count] = simulation.sample().count.row_updates;
    }
    // Columns differ slightly from body to body while they settle, so the work per island is only about equal.
    CHECK(work[1000] == Approx(2.0 * work[500]).epsilon(0.05));
    CHECK(work[2000] == Approx(4.0 * work[500]).epsilon(0.05));

    const State few = state_after(crowd(500), fixed_settings("default"), 60);
    const State many = state_after(crowd(2000), fixed_settings("default"), 60);
    CHECK(hash_of(many, 0, 500) == hash_of(few, 0, 500));
}
