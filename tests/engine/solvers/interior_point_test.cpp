// The two exact methods by themselves, on problems that are harder than those of scenes.
#include "engine/solvers/interior_point.h"

#include "engine/solvers/active_set.h"
#include "tests/catch.h"
#include "tests/engine/random_rows.h"

using namespace pushfactor;
using namespace pushfactor::engine;
using namespace pushfactor::engine::solvers;

namespace {

// A frozen problem in its first column, and the matrix for it.
struct UnitColumn {
    explicit UnitColumn(const tests::Frozen& frozen) {
        const SystemEquation& system = frozen.system;
        problem.bodies = system.inverse_mass.size();
        std::vector<std::pair<int, int>> pairs;
        std::vector<int> alone;
        for (int i = 1; i < static_cast<int>(problem.bodies); ++i) alone.push_back(i);
        for (std::size_t j = 0; j < frozen.rows.size(); ++j) {
            const ConstraintRow& row = frozen.rows[j];
            const auto index = static_cast<Eigen::Index>(j);
            const double scale = system.scale[index];
            problem.rows.push_back({.a = row.body_a,
                                    .b = row.body_b,
                                    .unit = &system.unit_axes[j],
                                    .t = system.b(index, 0) * system.dt / scale,
                                    .low = row.bounds.c_min * system.dt * scale,
                                    .high = row.bounds.c_max * system.dt * scale,
                                    .scale = scale});
            if (row.body_a > 0 && row.body_b > 0) pairs.emplace_back(row.body_a, row.body_b);
        }
        matrix.connect(problem.bodies, pairs, alone);
    }

    UnitProblem problem;
    BodyMatrix matrix;
    SolveCount count;
};

}  // namespace

TEST_CASE("the interior point method settles every random problem, in a number of steps that hardly grows") {
    for (const int rows : {10, 40, 160}) {
        for (std::uint64_t seed = 1; seed <= 30; ++seed) {
            const tests::Frozen frozen = tests::random_rows(seed, rows / 8 + 2, rows, 2.0);
            UnitColumn column(frozen);
            std::vector<double> y(frozen.rows.size(), 0.0);
            const double reached =
                InteriorPoint().solve(column.matrix, column.problem, 1e-7, 1000, y, column.count);
            INFO("seed " << seed << ", " << frozen.rows.size() << " rows");
            CHECK(reached <= 1e-7);
            CHECK(column.count.iterations <= 40);
            for (std::size_t j = 0; j < y.size(); ++j) {
                const UnitProblem::Row& row = column.problem.rows[j];
                REQUIRE((y[j] >= row.low && y[j] <= row.high));
            }
        }
    }
}

TEST_CASE("from near the answer the active set gets there in a few steps, from far away it does no harm") {
    for (std::uint64_t seed = 1; seed <= 50; ++seed) {
        const tests::Frozen frozen = tests::random_rows(seed, 10, 60, 1.0);
        UnitColumn column(frozen);
        std::vector<double> y(frozen.rows.size(), 0.0);
        std::vector<double> r;
        BodyVelocities x;
        follow(column.problem, y, x, r);
        const double before = residual(column.problem, y, r);
        ActiveSet active_set;
        std::vector<double> cold = y;
        CHECK(active_set.solve(column.matrix, column.problem, 1e-12, 1000, cold, column.count) <= before);

        InteriorPoint().solve(column.matrix, column.problem, 1e-7, 1000, y, column.count);
        active_set.start();
        SolveCount count;
        INFO("seed " << seed);
        CHECK(active_set.solve(column.matrix, column.problem, 1e-9, 1000, y, count) <= 1e-9);
        CHECK(count.iterations <= 4);
    }
}
