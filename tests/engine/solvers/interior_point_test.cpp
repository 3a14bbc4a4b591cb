// The two exact methods separately, on problems that are harder than those of scenes.
#include "engine/solvers/exact/interior_point.h"

#include "engine/solvers/exact/active_set.h"
#include "tests/catch.h"
#include "tests/engine/random_contacts.h"
#include "tests/engine/random_rows.h"

using namespace pushfactor;
using namespace pushfactor::engine;
using namespace pushfactor::engine::solvers;

namespace {

Effort effort_of(double factorisations = infinity) {
    Effort effort(1e12, 1, factorisations);
    effort.begin_column();
    return effort;
}

// A frozen problem in its first column, and the order of elimination for it; its static body becomes the last one.
struct UnitColumn {
    explicit UnitColumn(const tests::Frozen& frozen) {
        const SystemEquation& system = frozen.system;
        problem.bodies = system.inverse_mass.size();
        const int movable = static_cast<int>(problem.bodies) - 1;
        const auto number_of = [movable](int body) { return body == 0 ? movable : body - 1; };
        std::vector<std::pair<int, int>> pairs;
        std::vector<UnitRow> rows;
        for (std::size_t j = 0; j < frozen.rows.size(); ++j) {
            const auto row = static_cast<Eigen::Index>(j);
            units.push_back(
                unit_axis(system, system.rows[static_cast<std::size_t>(row)], std::sqrt(system.diagonal[row])));
        }
        for (std::size_t j = 0; j < frozen.rows.size(); ++j) {
            const ConstraintRow& row = frozen.rows[j];
            const auto index = static_cast<Eigen::Index>(j);
            const double scale = std::sqrt(system.diagonal[index]);
            const int leader = row.bounds.of_row;
            const double bound = leader < 0 ? system.dt * scale : scale / std::sqrt(system.diagonal[leader]);
            rows.push_back({.unit = &units[j],
                            .a = number_of(row.body_a),
                            .b = number_of(row.body_b),
                            .t = system.b(index, 0) * system.dt / scale,
                            .low = row.bounds.c_min * bound,
                            .high = row.bounds.c_max * bound,
                            .leader = leader,
                            .scale = scale});
            problem.bounds_follow = problem.bounds_follow || leader >= 0;
            if (row.body_a > 0 && row.body_b > 0) {
                pairs.emplace_back(number_of(row.body_a), number_of(row.body_b));
            }
        }
        problem.take(rows);
        order.find(movable, pairs);
    }

    double solve_by_interior_point(double tolerance, std::vector<double>& y) {
        Effort effort = effort_of();
        return InteriorPoint().solve(order, problem, tolerance, 1000, y, effort, count);
    }
    double solve_by_changes(double tolerance, std::vector<double>& y) {
        Effort effort = effort_of();
        return ActiveSet().solve(order, problem, tolerance, 1000, y, effort, count);
    }
    double residual_of(const std::vector<double>& y) const {
        std::vector<double> r;
        BodyVelocities x;
        follow(problem, y, x, r);
        return residual(problem, y, r);
    }

    std::vector<Jacobian> units;  // of the rows of the problem
    UnitProblem problem;
    Elimination order;
    SolveCount count;
};

bool is_within_bounds(const UnitProblem& problem, const std::vector<double>& y) {
    for (std::size_t j = 0; j < y.size(); ++j) {
        const UnitRow& row = problem.rows[j];
        const double scale = bound_scale(row, y);
        if (!(y[j] >= row.low * scale && y[j] <= row.high * scale)) return false;
    }
    return true;
}

}  // namespace

TEST_CASE("the interior point method settles every random problem, in a number of steps that hardly grows") {
    for (const int rows : {10, 40, 160}) {
        for (std::uint64_t seed = 1; seed <= 30; ++seed) {
            const tests::Frozen frozen = tests::random_rows(seed, rows / 8 + 2, rows, 2.0);
            UnitColumn column(frozen);
            std::vector<double> y(frozen.rows.size(), 0.0);
            INFO("seed " << seed << ", " << frozen.rows.size() << " rows");
            CHECK(column.solve_by_interior_point(1e-7, y) <= 1e-7);
            CHECK(column.count.iterations <= 40);
            CHECK(is_within_bounds(column.problem, y));
        }
    }
}

TEST_CASE("bounds that lie closer together than rounding do not stop the interior point method") {
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        tests::Frozen frozen = tests::random_contacts(seed, tests::RandomFriction::box, 3.0);
        UnitColumn column(frozen);
        std::vector<double> y(frozen.rows.size(), 0.0);
        INFO("seed " << seed << ", " << frozen.rows.size() << " rows");
        CHECK(column.solve_by_interior_point(1e-7, y) <= 1e-7);
        CHECK(column.count.iterations <= 40);
        CHECK(is_within_bounds(column.problem, y));
    }
}

TEST_CASE("with bounds that follow another row the interior point method does no harm, and mostly gets there") {
    const auto friction = GENERATE(tests::RandomFriction::coulomb, tests::RandomFriction::cone);
    int solved = 0;
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        const tests::Frozen frozen = tests::random_contacts(seed, friction, 0.5);
        UnitColumn column(frozen);
        std::vector<double> y(frozen.rows.size(), 0.0);
        const double before = column.residual_of(y);
        const double reached = column.solve_by_interior_point(1e-7, y);
        INFO("seed " << seed << ", " << frozen.rows.size() << " rows");
        CHECK(reached <= before);
        CHECK(column.residual_of(y) == Approx(reached).margin(1e-12));
        CHECK(is_within_bounds(column.problem, y));
        solved += reached <= 1e-7;
    }
    CHECK(solved >= 90);
}

TEST_CASE("from near the answer the active set gets there in a few steps, from far away it does no harm") {
    for (std::uint64_t seed = 1; seed <= 50; ++seed) {
        const tests::Frozen frozen = tests::random_rows(seed, 10, 60, 1.0);
        UnitColumn column(frozen);
        std::vector<double> y(frozen.rows.size(), 0.0);
        const double before = column.residual_of(y);
        std::vector<double> cold = y;
        CHECK(column.solve_by_changes(1e-12, cold) <= before);

        column.solve_by_interior_point(1e-7, y);
        column.count = {};
        INFO("seed " << seed);
        CHECK(column.solve_by_changes(1e-9, y) <= 1e-9);
        CHECK(column.count.iterations <= 4);
    }
}

TEST_CASE("an effort that is used up ends a solve with the best that was found") {
    const tests::Frozen frozen = tests::random_rows(7, 20, 160, 2.0);
    double last = std::numeric_limits<double>::infinity();
    for (const double factorisations : {0.0, 5.0, 10.0, 20.0, 40.0}) {
        UnitColumn column(frozen);
        std::vector<double> y(frozen.rows.size(), 0.0);
        Effort effort = effort_of(factorisations);
        const double reached =
            InteriorPoint().solve(column.order, column.problem, 1e-9, 1000, y, effort, column.count);
        CHECK(column.count.iterations <= factorisations);
        CHECK(reached <= last);
        CHECK(column.residual_of(y) == Approx(reached).margin(1e-12));
        last = reached;
    }
    CHECK(last <= 1e-9);
}
