// Frozen problems for solvers, and A and the residual computed by definition.
#pragma once

#include "engine/constraints/contact_constraints.h"
#include "engine/solvers/solver.h"
#include "tests/engine/rows.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace pushfactor::tests {

constexpr double problem_dt = 1.0 / 60.0;

// Bodies and the rows between them.
struct Problem {
    std::string name;
    std::vector<engine::Body> bodies;
    std::vector<engine::ConstraintRow> rows;

    Frozen frozen() const { return Frozen(bodies, rows, problem_dt); }
};

inline Problem column_problem(int count) {
    Column column(count);
    return {"column", std::move(column.bodies), std::move(column.rows)};
}

// Balls of 1 kg at the joints of a zigzag of bars that hangs from body 0.
inline Problem chain_problem(int count) {
    Problem chain{"chain", {engine::static_body(engine::Vector3::Zero())}, {}};
    for (int i = 1; i <= count; ++i) {
        const engine::Vector3 along(0.8, i % 2 == 0 ? 0.6 : -0.6, 0);
        engine::Body body = engine::box_body(1.0, engine::Vector3::Ones(), engine::Vector3(0.8 * i, 0, 0));
        body.force = engine::Vector3(0, -10, 0);
        chain.bodies.push_back(body);
        engine::ConstraintRow row;
        row.body_a = i - 1;
        row.body_b = i;
        if (i > 1) row.jacobian.a.head<3>() = -along;
        row.jacobian.b.head<3>() = along;
        chain.rows.push_back(row);
    }
    return chain;
}

// The engine's problem of these bodies' contacts under gravity 10.
inline Problem contact_problem(std::string name, std::vector<engine::Body> bodies,
                               std::vector<engine::collision::Collider> colliders, engine::FrictionRule friction,
                               const engine::ContactChoices& choices) {
    for (engine::Body& body : bodies) {
        if (!body.is_static()) body.force = engine::Vector3(0, -10, 0) / body.inverse_mass;
    }
    engine::ContactConstraints stage(std::move(colliders), choices);
    stage.set_friction(std::move(friction));
    Problem problem{std::move(name), std::move(bodies), {}};
    problem.rows = rows_of(stage, {problem.bodies, problem_dt});
    return problem;
}

inline engine::ContactChoices pushed(engine::PushKind kind, bool four_points = true) {
    engine::ContactChoices choices;
    choices.correction = {kind, 0.2};
    choices.detection.reduce_to_four_points = four_points;
    return choices;
}
inline const engine::ContactChoices persistent = pushed(engine::PushKind::persistent);
inline const engine::ContactChoices single_frame = pushed(engine::PushKind::single_frame);

inline engine::FrictionRule weight_friction() {
    return engine::weight_friction(engine::Vector3(0, -10, 0));
}

// Cubes of 1 m and 1 kg stacked on a plane, overlapping by a centimetre, each turned by `turn` against the one
// below: faces that meet in four points when aligned and in eight at 45 degrees. They move down and sideways.
inline Problem tower_problem(std::string name, int count, double turn, engine::FrictionRule friction,
                             const engine::ContactChoices& choices) {
    std::vector<engine::Body> bodies{engine::static_body(engine::Vector3::Zero())};
    std::vector<engine::collision::Collider> colliders{{.body = 0, .shape = engine::collision::Plane{}}};
    for (int i = 0; i < count; ++i) {
        const engine::Quaternion turned(Eigen::AngleAxisd(turn * i, engine::Vector3::UnitY()));
        engine::Body body = engine::box_body(1.0, engine::Vector3::Ones(), {0.01 * i, 0.49 + 0.99 * i, 0}, turned);
        body.linear_momentum = engine::Vector3(0.3 * i, -0.5, 0.1);
        bodies.push_back(body);
        colliders.push_back({.body = i + 1, .shape = engine::collision::Box{}});
    }
    return contact_problem(std::move(name), std::move(bodies), std::move(colliders), std::move(friction), choices);
}

// Six balls in a gutter of two planes, one row across and one on top of it.
inline Problem gutter_problem(engine::FrictionRule friction) {
    const auto tilted = [](double angle) {
        return engine::static_body(engine::Vector3::Zero(),
                                   engine::Quaternion(Eigen::AngleAxisd(angle, engine::Vector3::UnitZ())));
    };
    std::vector<engine::Body> bodies{tilted(0.7), tilted(-0.7)};
    std::vector<engine::collision::Collider> colliders{{.body = 0, .shape = engine::collision::Plane{}},
                                                       {.body = 1, .shape = engine::collision::Plane{}}};
    for (int i = 0; i < 6; ++i) {
        // Touching both planes: 0.5 / cos(0.7) above the edge; the upper ones lie between two lower ones.
        const bool upper = i >= 4;
        const engine::Vector3 position(0, upper ? 1.5 : 0.65, upper ? i - 3.5 : 0.99 * i);
        bodies.push_back(engine::ball_body(1.0 + 0.5 * i, 0.5, position));
        colliders.push_back({.body = i + 2, .shape = engine::collision::Sphere{}});
    }
    engine::ContactChoices choices = persistent;
    choices.slop = 0.0;
    choices.detection.margin = 0.05;
    return contact_problem("gutter", std::move(bodies), std::move(colliders), std::move(friction), choices);
}

// Problems on which all sweeping solvers converge.
inline std::vector<Problem> solvable_problems() {
    std::vector<Problem> problems;
    problems.push_back(column_problem(5));
    problems.push_back(chain_problem(6));

    problems.push_back(column_problem(3));
    problems.back().name = "column whose ground gives way";
    problems.back().rows[0].bounds.c_max = 15.0;

    problems.push_back(column_problem(3));
    problems.back().name = "column with a row that moves nothing";
    engine::ConstraintRow idle;
    idle.push.lasting = 1.0;
    problems.back().rows.insert(problems.back().rows.begin() + 1, idle);

    problems.push_back(column_problem(3));
    problems.back().name = "column with a row three times, singular";
    for (int i = 0; i < 2; ++i) problems.back().rows.push_back(problems.back().rows[1]);

    problems.push_back(gutter_problem(weight_friction()));
    problems.push_back(gutter_problem(pushfactor::engine::coulomb_friction));
    problems.back().name = "gutter, Coulomb";
    problems.push_back(tower_problem("box, singular", 1, 0.0, weight_friction(), single_frame));
    problems.push_back(tower_problem("box, Coulomb", 1, 0.0, pushfactor::engine::coulomb_friction, single_frame));
    problems.push_back(gutter_problem(pushfactor::engine::cone_friction));
    problems.back().name = "gutter, cone";
    problems.push_back(tower_problem("box, cone", 1, 0.0, pushfactor::engine::cone_friction, single_frame));
    problems.push_back(tower_problem("two boxes in two columns", 2, 0.0, weight_friction(), single_frame));
    return problems;
}

inline engine::Columns solve(const char* solver, const engine::SystemEquation& system, engine::Columns lambda,
                             const engine::solvers::Termination& termination) {
    engine::solvers::make_solver(solver)->solve(system, termination, lambda);
    return lambda;
}

// A = J M^-1 J^T, column by column from unit forces (6.2.1).
inline engine::MatrixX dense_matrix(const engine::SystemEquation& system) {
    engine::MatrixX A(system.row_count(), system.row_count());
    std::vector<engine::Vector6> forces;
    for (Eigen::Index j = 0; j < A.cols(); ++j) {
        engine::Columns unit = engine::Columns::Zero(A.rows(), 1);
        unit(j, 0) = 1.0;
        engine::constraint_forces(system, unit, 0, forces);
        for (Eigen::Index i = 0; i < A.rows(); ++i) {
            const engine::ConstraintRow& row = system.rows[static_cast<std::size_t>(i)];
            const auto a = static_cast<std::size_t>(row.body_a), b = static_cast<std::size_t>(row.body_b);
            A(i, j) = row.jacobian.a.dot(engine::accelerate(system.inverse_mass[a], forces[a])) +
                      row.jacobian.b.dot(engine::accelerate(system.inverse_mass[b], forces[b]));
        }
    }
    return A;
}

// The largest eigenvalue of A with rows scaled to A_jj = 1. A_jj must not be zero.
inline double largest_eigenvalue(const engine::SystemEquation& system) {
    const engine::VectorX scale = system.diagonal.cwiseSqrt().cwiseInverse();
    const engine::MatrixX unit = scale.asDiagonal() * dense_matrix(system) * scale.asDiagonal();
    engine::VectorX v = engine::VectorX::LinSpaced(unit.rows(), 1.0, 1.5);
    for (int i = 0; i < 1000; ++i) v = (unit * v).normalized();
    return v.dot(unit * v);
}

}  // namespace pushfactor::tests
