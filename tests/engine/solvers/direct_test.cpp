// The exact solution of problems where other solvers fail, and where it is not unique.
#include "engine/constraints/distance_constraints.h"
#include "engine/solvers/solver.h"
#include "tests/catch.h"
#include "tests/engine/random_contacts.h"
#include "tests/engine/random_rows.h"
#include "tests/engine/rows.h"
#include "tests/scene_fixture.h"
#include "tests/settings.h"

using namespace pushfactor;
using namespace pushfactor::engine;
using pushfactor::tests::Frozen;
using solvers::make_solver;

namespace {

constexpr double dt = 1.0 / 60.0;
constexpr solvers::Termination to_rounding{.iterations = 1000, .tolerance_high = 1e-12, .tolerance_low = 1e-12};

struct Answer {
    Columns lambda;
    double residual;  // m/s
    solvers::SolveCount count;
};

Answer solve(const char* solver, const Frozen& frozen, const solvers::Termination& termination = to_rounding) {
    Answer answer{.lambda = frozen.zero(), .residual = 0.0, .count = {}};
    answer.count = make_solver(solver)->solve(frozen.system, termination, answer.lambda);
    answer.residual = natural_residual(frozen.system, answer.lambda);
    return answer;
}

// A chain of balls that hangs from the ground, the last `ratio` times heavier, with `twice` as many rows if asked.
struct Chain {
    std::vector<Body> bodies{static_body(Vector3::Zero())};
    std::vector<Distance> distances;

    Chain(int links, double ratio) {
        for (int i = 1; i <= links; ++i) {
            bodies.push_back(ball_body(i == links ? ratio : 1.0, 0.1, {0.8 * i, -0.6 * i, 0}));
            bodies.back().force = Vector3(0, -10.0 * bodies.back().mass(), 0);
            distances.push_back({.body_a = i - 1, .body_b = i, .length = 1.0});
        }
    }
    Frozen frozen() const {
        std::vector<ConstraintRow> rows = pushfactor::tests::rows_of(
            DistanceConstraints(distances, {PushKind::persistent, 1.0}, false), {bodies, dt});
        return {bodies, rows, dt};
    }
};

}  // namespace

TEST_CASE("direct solves random problems with redundant rows and both columns to rounding") {
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        const Frozen frozen =
            tests::random_rows(seed, static_cast<int>(3 + seed % 6), static_cast<int>(seed % 45), 2.0);
        const Answer answer = solve("direct", frozen);
        INFO("seed " << seed << ", " << frozen.rows.size() << " rows");
        // Rounding in a row that moves at up to 1e3 m/s.
        CHECK(answer.residual < 1e-9);
    }
}

TEST_CASE("direct and a very long sweep move the bodies alike, also where the forces are not unique") {
    auto simulation =
        tests::simulate("intersecting-stack", tests::solved_exactly(tests::awake_settings("default")));
    tests::advance(simulation, 0.1);
    const World& world = simulation.scene().world;
    const Frozen frozen(world.bodies, world.rows(), dt);
    const Answer exact = solve("direct", frozen);
    const Answer swept =
        solve("pgs", frozen, {.iterations = 100000, .tolerance_high = 1e-12, .tolerance_low = 1e-12});
    CHECK(exact.residual < 1e-12);
    for (Eigen::Index column = 0; column < frozen.system.column_count(); ++column) {
        std::vector<Vector6> a, b;
        constraint_forces(frozen.system, exact.lambda, column, a);
        constraint_forces(frozen.system, swept.lambda, column, b);
        for (std::size_t i = 0; i < a.size(); ++i) {
            const bool moves = frozen.system.inverse_mass[i].linear > 0.0;
            if (moves) CHECK((a[i] - b[i]).norm() < 1e-7);
        }
    }
}

TEST_CASE("direct holds a chain whose end is a thousand or a million times heavier, where sweeps do not") {
    for (const double ratio : {1e3, 1e6}) {
        const Frozen frozen = Chain(20, ratio).frozen();
        const Answer exact = solve("direct", frozen);
        CHECK(exact.residual < 1e-9);
        CHECK(solve("pgs", frozen, {.iterations = 100}).residual > 1e-3);
    }
}

TEST_CASE("one factorisation solves bars alone, whatever their number, at a cost that grows with it") {
    const Answer ten = solve("direct", Chain(10, 1.0).frozen());
    const Answer forty = solve("direct", Chain(40, 1.0).frozen());
    CHECK(ten.residual < 1e-12);
    CHECK(forty.residual < 1e-12);
    CHECK(ten.count.iterations == 1);
    CHECK(forty.count.iterations == 1);
    CHECK(forty.count.multiply_adds < 4.2 * ten.count.multiply_adds);
}

TEST_CASE("bars that contradict each other share the error, and their forces stay finite from step to step") {
    Chain chain(1, 1.0);
    chain.bodies[1].position = Vector3(0, -1, 0);
    chain.distances = {{.body_a = 0, .body_b = 1, .length = 0.9}, {.body_a = 0, .body_b = 1, .length = 1.1}};
    Answer answer = solve("direct", chain.frozen());
    CHECK(answer.lambda.allFinite());
    // Between the two, with its weight carried.
    CHECK(answer.lambda.sum() == Approx(-10.0).epsilon(1e-3));
    const double once = answer.lambda.cwiseAbs().maxCoeff();
    for (int step = 0; step < 10; ++step) {
        const Frozen frozen = chain.frozen();
        make_solver("direct")->solve(frozen.system, to_rounding, answer.lambda);
    }
    CHECK(answer.lambda.allFinite());
    CHECK(answer.lambda.cwiseAbs().maxCoeff() < 3.0 * once);
}

TEST_CASE("direct finds the bounds of Coulomb friction: a box on a slope slides as theory says, or holds") {
    for (const auto& [angle, moves] : {std::pair{0.3, false}, std::pair{0.6, true}}) {
        demos::Settings settings = tests::awake_settings("exact");
        settings.friction_model = demos::FrictionModel::coulomb;
        demos::SceneDescription scene;
        scene.name = "slope";
        scene.contacts = true;
        const Quaternion tilt(Eigen::AngleAxisd(angle, Vector3::UnitZ()));
        scene.bodies.push_back({.name = "slope", .shape = demos::PlaneShape{}, .orientation = tilt});
        scene.bodies.push_back({.name = "box", .shape = demos::BoxShape{}, .mass = 1.0});
        scene.bodies.back().position = tilt * Vector3(0, 0.5, 0);
        scene.bodies.back().orientation = tilt;
        demos::Simulation run(demos::build_scene(scene, settings), settings);
        tests::advance(run, 1.0);
        const double speed = velocity(run.scene().world.bodies[1]).norm();
        const double theory = 10.0 * (std::sin(angle) - 0.5 * std::cos(angle));
        CHECK(speed == Approx(moves ? theory : 0.0).margin(moves ? 1e-6 : 1e-9).epsilon(1e-6));
    }
}

TEST_CASE(
    "direct solves a settling heap with friction on the cone, also where its residual has to rise on the way") {
    for (const char* const seed : {"1", "2", "3"}) {
        demos::Settings settings = tests::awake_settings("exact");
        settings.friction_model = demos::FrictionModel::cone;
        auto run = tests::simulate("funnel", settings, {{"seed", seed}});
        int solved = 0;
        constexpr int steps = 180;
        for (int step = 0; step < steps; ++step) {
            tests::advance(run, dt);
            solved += run.sample().residual <= 1e-8;
        }
        INFO("seed " << seed << ": " << solved);
        CHECK(solved >= 0.99 * steps);
    }
}

TEST_CASE("direct solves random contacts with friction on the cone, and says so") {
    int solved = 0;
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        const Frozen frozen = tests::random_contacts(seed, tests::RandomFriction::cone, 0.5);
        const Answer answer =
            solve("direct", frozen, {.iterations = 1000, .tolerance_high = 1e-9, .tolerance_low = 1e-9});
        INFO("seed " << seed << ", " << frozen.rows.size() << " rows, residual " << answer.residual);
        if (answer.count.exact) CHECK(answer.residual < 2e-9);
        solved += answer.residual < 2e-9;
    }
    CHECK(solved == 100);
}

TEST_CASE("auto sweeps once where no two rows share a body, is exact on threads, and sweeps heaps") {
    const auto of_step = [](const char* scene, const char* solver, double seconds) {
        demos::Settings settings = tests::awake_settings("default");
        settings.solver = solver;
        auto run = tests::simulate(scene, settings);
        tests::advance(run, seconds);
        return run.sample();
    };
    const demos::Sample wave = of_step("pendulum-wave", "auto", 0.5);
    CHECK(wave.count.sweeps == 1);
    CHECK(wave.residual < 1e-12);
    // A landing stack, which 25 sweeps leave far from the solution.
    CHECK(of_step("stack", "auto", 0.55).residual < 1e-9);
    CHECK(of_step("stack", "pgs", 0.55).residual > 1e-4);
    // A heap is solved by sweeps in small steps, and the additional cost is bounded.
    const demos::Sample heap = of_step("funnel", "auto", 3.0);
    CHECK(heap.count.islands_in_small_steps > 0);
    CHECK(heap.count.multiply_adds <= 5.0 * of_step("funnel", "pgs", 3.0).count.multiply_adds);
}
