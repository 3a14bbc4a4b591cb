// Polyhedra in scenes: a cube of eight points is a box, and what is dropped stays above the ground.
#include "demos/options/named_run.h"
#include "tests/catch.h"
#include "tests/engine/collision/hulls.h"
#include "tests/scene_fixture.h"
#include "tests/settings.h"

#include <algorithm>

using namespace pushfactor;
using namespace pushfactor::demos;
using engine::Vector3;

namespace {

// The same scene with every box as the hull of its corners.
SceneDescription with_polyhedra(SceneDescription scene) {
    for (BodyDescription& body : scene.bodies) {
        if (const auto* box = std::get_if<BoxShape>(&body.shape)) {
            give_polyhedron(body, make_polyhedron(tests::box_points(0.5 * box->size)));
        }
    }
    return scene;
}

SceneDescription named(std::string_view name) {
    const SceneEntry& entry = *find_scene(name);
    return entry.describe(ParameterValues(entry.parameters));
}

// A cube thrown over the ground so that it tumbles.
SceneDescription tumbling() {
    SceneDescription scene;
    scene.name = "tumbling";
    scene.contacts = true;
    scene.bodies.push_back({.name = "ground", .shape = PlaneShape{}});
    scene.bodies.push_back({.name = "cube",
                            .shape = BoxShape{Vector3::Ones()},
                            .mass = 2.0,
                            .position = Vector3(0, 2, 0),
                            .velocity = Vector3(3, 0, 1),
                            .angular_velocity = Vector3(1, 2, -4)});
    return scene;
}

// The largest distance between the places of a body in both runs at any time [m].
double largest_difference(const SceneDescription& boxes, const Settings& settings, double seconds) {
    Simulation one(build_scene(boxes, settings), settings);
    Simulation other(build_scene(with_polyhedra(boxes), settings), settings);
    double largest = 0.0;
    for (long i = 0; i < std::lround(seconds / settings.dt.value()); ++i) {
        one.advance();
        other.advance();
        for (std::size_t k = 0; k < boxes.bodies.size(); ++k) {
            const engine::Body &p = one.scene().world.bodies[k], &q = other.scene().world.bodies[k];
            largest = std::max({largest, (p.position - q.position).norm(),
                                (p.orientation.toRotationMatrix() - q.orientation.toRotationMatrix()).norm()});
        }
    }
    return largest;
}

double lowest_vertex(const engine::Body& body, const PolyhedronShape& polyhedron) {
    double lowest = std::numeric_limits<double>::infinity();
    for (const Vector3& point : polyhedron.points()) {
        lowest = std::min(lowest, (body.position + body.orientation * point).y());
    }
    return lowest;
}

// Random hulls above the ground, in layers on a square of `side` places a side.
SceneDescription dropped_hulls(int count, int side, std::uint64_t seed) {
    tests::Random random(seed);
    SceneDescription scene;
    scene.name = "dropped";
    scene.contacts = true;
    scene.bodies.push_back({.name = "ground", .shape = PlaneShape{}});
    for (int i = 0; i < count; ++i) {
        BodyDescription body{.name = std::to_string(i), .mass = random.in(0.5, 4)};
        body.position = Vector3(2.2 * (i % side), 2 + 2.2 * (i / (side * side)), 2.2 * (i / side % side));
        body.orientation = random.rotation();
        body.velocity = random.vector(-3, 3);
        body.angular_velocity = random.vector(-5, 5);
        give_polyhedron(body, make_polyhedron(tests::random_points(random)));
        scene.bodies.push_back(body);
    }
    return scene;
}

// Steps the scene and requires that no hull gets through the ground or through another, that all numbers stay
// finite, and that no energy is gained.
void require_harmless(const SceneDescription& scene, double seconds) {
    const Settings settings = tests::awake_settings("default");
    Simulation simulation(build_scene(scene, settings), settings);
    const double start = simulation.sample().kinetic_energy + simulation.sample().potential_energy;
    double deepest = 0.0, gain = 0.0;
    for (long i = 0; i < std::lround(seconds / settings.dt.value()); ++i) {
        const Sample& sample = simulation.advance();  // throws unless all is finite
        gain = std::max(gain, sample.energy_gain);
        if (i % 4 != 0) continue;
        for (std::size_t k = 1; k < scene.bodies.size(); ++k) {
            const engine::Body& body = simulation.scene().world.bodies[k];
            const auto& polyhedron = std::get<PolyhedronShape>(scene.bodies[k].shape);
            deepest = std::max(deepest, -lowest_vertex(body, polyhedron) / polyhedron.mesh->hull().size);
        }
    }
    INFO("deepest below the ground " << deepest << " of the size, gain " << gain << " of " << start << " J");
    CHECK(deepest < 0.5);
    CHECK(gain < 1e-3 * start);
    CHECK(simulation.sample().penetration.max < 0.3);
}

}  // namespace

// Positions and normals of the contacts of cubes differ by rounding. Forces with a residual of up to `--tolerance`
// m/s are kept, so either run may be off by what that allows within ten seconds.
TEST_CASE("a cube of eight points behaves as a box for ten seconds: standing, intersecting, tumbling") {
    Settings strict = tests::awake_settings("default");
    strict.tolerance_high = strict.tolerance_low;
    strict.solver = "direct";  // in whole steps
    for (const Settings& settings : {tests::awake_settings("paper"), tests::awake_settings("exact"), strict}) {
        INFO(settings.preset);
        CHECK(largest_difference(named("stack"), settings, 10) < 1e-9);
        CHECK(largest_difference(named("intersecting-stack"), settings, 10) < 1e-9);
        CHECK(largest_difference(tumbling(), settings, 10) < 1e-9);
    }
    const Settings settings = tests::awake_settings("default");
    CHECK(largest_difference(named("intersecting-stack"), settings, 10) < 2.0 * settings.tolerance_high * 10);
    CHECK(largest_difference(tumbling(), settings, 10) < 1e-9);
}

// Where several bodies collide at once, small steps sweep on until little changes; which sweep is the last one may
// turn on rounding.
TEST_CASE("stacks of cubes of eight points and of boxes end within a millimetre of each other") {
    const Settings settings = tests::awake_settings("default");
    for (const char* const jitter : {"0", "0.006", "0.012", "0.018", "0.024", "0.03"}) {
        INFO(jitter);
        const Choices choices = run_of("stack", {{"jitter", jitter}, {"seed", "3"}});
        CHECK(largest_difference(choices.description, settings, 10) < 1e-3);  // 3e-6 to 4.4e-4 m
    }
}

TEST_CASE("random hulls that are dropped stay above the ground, stay finite and gain no energy") {
    require_harmless(dropped_hulls(40, 4, 1), 3);
}

TEST_CASE("a thousand random hulls that are dropped stay above the ground, stay finite and gain no energy", "[.]") {
    for (std::uint64_t seed = 1; seed <= 25; ++seed) require_harmless(dropped_hulls(40, 4, seed), 3);
    require_harmless(dropped_hulls(1000, 10, 100), 2);
}
