// Paper section 6: the system equation 6.2.9 and its consequences.
#include "engine/system/system_equation.h"

#include "engine/solvers/solver.h"
#include "tests/catch.h"
#include "tests/engine/rows.h"
#include "tests/random.h"
#include "tests/scene_fixture.h"
#include "tests/settings.h"

using namespace pushfactor;
using namespace pushfactor::engine;
using pushfactor::tests::Column;
using pushfactor::tests::Frozen;

TEST_CASE("J v2 equals the push after a step with the solved lambda, row for row") {
    // 6.2.9 rebuilt forwards: v2 = v1 + dt M^-1 (J^T lambda + f_ext) must satisfy every row that is not at a bound.
    auto simulation =
        tests::simulate("intersecting-stack", tests::solved_exactly(tests::awake_settings("default")));
    tests::advance(simulation, 0.05);
    const World& world = simulation.scene().world;
    const SystemEquation& system = world.system();
    REQUIRE(system.column_count() == 2);

    for (const Eigen::Index column : {0, 1}) {
        std::vector<Vector6> forces;
        constraint_forces(system, world.lambda(), column, forces);
        int free_rows = 0;
        for (Eigen::Index j = 0; j < system.row_count(); ++j) {
            const ConstraintRow& row = system.rows[static_cast<std::size_t>(j)];
            const double lambda = world.lambda()(j, column);
            const auto [low, high] = bounds_of(row, world.lambda(), column);
            if (lambda <= low || lambda >= high) continue;
            ++free_rows;
            const auto v2 = [&](int body) -> Vector6 {
                const auto i = static_cast<std::size_t>(body);
                return system.dt * (system.free_acceleration[i] + accelerate(system.inverse_mass[i], forces[i]));
            };
            const double push = row.push.lasting + (column == 0 ? row.push.correcting : 0.0);
            REQUIRE(row.jacobian.a.dot(v2(row.body_a)) + row.jacobian.b.dot(v2(row.body_b)) ==
                    Approx(push).margin(1e-10));
        }
        CHECK(free_rows > 30);
    }
}

TEST_CASE("b has one column while nothing corrects for a single frame, and two when something does") {
    Column column(3);
    for (ConstraintRow& row : column.rows) row.push.lasting = 0.5;
    CHECK(Frozen(column.bodies, column.rows, 0.1).system.column_count() == 1);
    column.rows[1].push.correcting = 0.25;
    const Frozen two(column.bodies, column.rows, 0.1);
    REQUIRE(two.system.column_count() == 2);
    CHECK(two.system.b(1, 0) - two.system.b(1, 1) == Approx(0.25 / 0.1));
    CHECK(two.system.b(0, 0) == two.system.b(0, 1));
}

TEST_CASE("the forces of a resting column carry the weight above, and leave no residual") {
    const int n = 6;
    const Column column(n);
    const Frozen frozen(column.bodies, column.rows, 1.0 / 60.0);
    Columns lambda = frozen.zero();
    for (int i = 0; i < n; ++i) lambda(i, 0) = 10.0 * (n - i);
    CHECK(natural_residual(frozen.system, lambda) < 1e-14);
    // One newton too little at the ground is wrong by dt A_11 1 N = 1/60 m/s.
    lambda(0, 0) -= 1.0;
    CHECK(natural_residual(frozen.system, lambda) == Approx(1.0 / 60.0));
}

TEST_CASE("a bound that follows another row is taken from that row and column") {
    ConstraintRow row;
    row.bounds = {.c_min = -0.5, .c_max = 0.5, .of_row = 1};
    Columns lambda(2, 2);
    lambda << 0.0, 0.0, 8.0, 3.0;
    CHECK(bounds_of(row, lambda, 0).high == 4.0);
    CHECK(bounds_of(row, lambda, 1).low == -1.5);
}
