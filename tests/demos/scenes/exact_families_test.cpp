// Families of scenes with random parameters, under the exact preset: what stands by mechanics stands, every step is
// solved, and the work per step is bounded.
#include "demos/options/settings.h"
#include "demos/runs/scene.h"
#include "demos/runs/simulation.h"
#include "tests/catch.h"
#include "tests/random.h"
#include "tests/settings.h"

#include <algorithm>
#include <string>

using namespace pushfactor;
using namespace pushfactor::demos;
using engine::Vector3;

namespace {

constexpr double cube = 0.3;  // m

SceneDescription on_the_ground(std::string name) {
    SceneDescription scene;
    scene.name = std::move(name);
    scene.contacts = true;
    scene.bodies.push_back({.name = "ground", .shape = PlaneShape{}});
    return scene;
}

void add_box(SceneDescription& scene, const Vector3& size, double mass, const Vector3& position) {
    const std::string name = "box " + std::to_string(scene.bodies.size());
    scene.bodies.push_back({.name = name, .shape = BoxShape{size}, .mass = mass, .position = position});
}

// A ball of `mass` on a cube of n x n x n cubes of 1 kg, with gaps between them.
SceneDescription ball_on_cubes(int n, double mass, double gap) {
    SceneDescription scene = on_the_ground("ball on cubes");
    const double pitch = cube + gap;
    for (int i = 0; i < n * n * n; ++i) {
        const Vector3 cell(i % n - 0.5 * (n - 1), i / (n * n), (i / n) % n - 0.5 * (n - 1));
        add_box(scene, Vector3::Constant(cube), 1.0,
                Vector3(pitch * cell.x(), pitch * cell.y() + 0.5 * cube, pitch * cell.z()));
    }
    const double top = (n - 1) * pitch + cube;
    scene.bodies.push_back(
        {.name = "ball", .shape = SphereShape{0.4}, .mass = mass, .position = Vector3(0, top + 0.4, 0)});
    return scene;
}

// Rows of touching cubes, one less in each, the top one `ratio` times as heavy.
SceneDescription pyramid(int rows, double ratio) {
    SceneDescription scene = on_the_ground("pyramid");
    for (int row = 0; row < rows; ++row) {
        for (int i = 0; i < rows - row; ++i) {
            const double mass = row == rows - 1 ? ratio : 1.0;
            add_box(scene, Vector3::Ones(), mass, Vector3(i - 0.5 * (rows - row - 1), row + 0.5, 0));
        }
    }
    return scene;
}

// Bricks in running bond.
SceneDescription wall(int rows, int length) {
    SceneDescription scene = on_the_ground("wall");
    const Vector3 brick(0.5, 0.25, 0.25);
    for (int row = 0; row < rows; ++row) {
        for (int i = 0; i < length - row % 2; ++i) {
            const double x = (i + 0.5 * (row % 2)) * brick.x();
            add_box(scene, brick, 1.0, Vector3(x, (row + 0.5) * brick.y(), 0));
        }
    }
    return scene;
}

// Measures of three seconds.
struct Seen {
    double worst_residual = 0.0, speed = 0.0, gain = 0.0, moved = 0.0;
    int unsolved = 0, most_factorisations = 0;
};

Seen run(const SceneDescription& scene, FrictionModel friction, double seconds) {
    Settings settings = tests::awake_settings("exact");
    settings.friction_model = friction;
    Simulation simulation(build_scene(scene, settings), settings);
    const auto energy = [&] { return simulation.sample().kinetic_energy + simulation.sample().potential_energy; };
    const double start = energy();
    Seen seen;
    for (double t = 0.0; t < seconds; t += settings.dt.value()) {
        const Sample& sample = simulation.advance();
        seen.worst_residual = std::max(seen.worst_residual, sample.residual);
        seen.gain = std::max(seen.gain, energy() - start);
        seen.unsolved += sample.count.islands_unsolved;
        seen.most_factorisations = std::max(seen.most_factorisations, sample.count.sweeps);
        seen.speed = sample.max_speed;
    }
    const auto& bodies = simulation.scene().world.bodies;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        seen.moved = std::max(seen.moved, (bodies[i].position - scene.bodies[i].position).norm());
    }
    return seen;
}

void check(const SceneDescription& scene, const Seen& seen, double may_sink) {
    INFO(scene.name << " of " << scene.bodies.size() << ": residual " << seen.worst_residual << ", speed "
                    << seen.speed << ", moved " << seen.moved << ", gain " << seen.gain << ", unsolved "
                    << seen.unsolved << ", factorisations " << seen.most_factorisations);
    CHECK(seen.worst_residual <= 1e-7);
    CHECK(seen.speed <= 1e-6);
    CHECK(seen.moved <= may_sink + 1e-6);
    CHECK(seen.gain <= 1e-6);
    // Factorisations of two columns, and the sweeps that may follow: 2 (6 + 10 + 10 + 2 x 60) + 400.
    CHECK(seen.most_factorisations <= 692);
}

}  // namespace

TEST_CASE("a heavy ball rests on small cubes, whatever it weighs and whether they touch", "[long]") {
    tests::Random random(17);
    for (int i = 0; i < 12; ++i) {
        const int n = i % 6 == 2 ? 3 : 2;
        const double mass = std::pow(10.0, random.in(1.0, 3.0));
        const double gap = i % 2 == 0 ? 0.0 : random.in(0.0, 1e-3);
        // Under Coulomb's law cubes that lean on each other are the next test.
        const auto friction = gap > 0.0 || random.in(0, 1) < 0.5 ? FrictionModel::paper : FrictionModel::coulomb;
        const SceneDescription scene = ball_on_cubes(n, mass, gap);
        check(scene, run(scene, friction, 1.5), 2.0 * n * gap);
    }
}

// Their steps stay unsolved by 1e-8 to 1e-6 m/s.
TEST_CASE("a heavy ball presses cubes with gaps together under Coulomb's law, and they nearly rest", "[long]") {
    tests::Random random(17);
    for (int i = 0; i < 20; ++i) {
        const double mass = std::pow(10.0, random.in(1.0, 3.0)), gap = random.in(0.0, 1e-3);
        const Seen seen = run(ball_on_cubes(2, mass, gap), FrictionModel::coulomb, 1.5);
        INFO(mass << " kg, gap " << gap << " m");
        CHECK(seen.worst_residual < 2e-6);
        CHECK(seen.speed < 1e-3);
        CHECK(seen.moved <= 4.0 * gap + 1e-6);
        CHECK(seen.gain <= 1e-6);
    }
}

TEST_CASE("pyramids and walls stand, whatever their size and however heavy their top", "[long]") {
    tests::Random random(18);
    for (int i = 0; i < 4; ++i) {
        const auto friction = i % 2 == 0 ? FrictionModel::paper : FrictionModel::coulomb;
        const int rows = 3 + static_cast<int>(random.in(0, 6));
        const SceneDescription heavy = pyramid(rows, std::pow(10.0, random.in(0.0, 2.0)));
        check(heavy, run(heavy, friction, 1.0), 0.0);
        const int height = 3 + static_cast<int>(random.in(0, 5));
        const SceneDescription bricks = wall(height, 3 + static_cast<int>(random.in(0, 4)));
        check(bricks, run(bricks, friction, 1.0), 0.0);
    }
}
