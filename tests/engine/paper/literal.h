// One step with rows written out by hand, to compare the printed reading of the paper with the right one.
#pragma once

#include "engine/bodies/integrator.h"
#include "engine/solvers/solver.h"
#include "tests/engine/rows.h"

#include <span>
#include <vector>

namespace pushfactor::tests {

// The effect of a step of dt on the bodies.
struct Literal {
    Frozen frozen;
    engine::Columns lambda;               // N
    std::vector<engine::Vector6> forces;  // f_c = J^T lambda, N and N m
    std::vector<engine::Vector6> after;   // v2, m/s and rad/s
    std::vector<engine::Body> bodies;     // moved by 3.2.1 to 3.2.3 and 12.4.1

    double speed_along(std::size_t row) const {  // j_c v2
        const engine::ConstraintRow& r = frozen.rows[row];
        return r.jacobian.a.dot(after[static_cast<std::size_t>(r.body_a)]) +
               r.jacobian.b.dot(after[static_cast<std::size_t>(r.body_b)]);
    }
    double power() const {  // f_c v2, W
        double sum = 0.0;
        for (std::size_t i = 0; i < after.size(); ++i) sum += forces[i].dot(after[i]);
        return sum;
    }
};

// Solves by sweeps until nothing changes, then applies the whole lambda to both momenta and positions.
inline Literal step_with(std::span<const engine::Body> bodies, std::span<const engine::ConstraintRow> rows,
                         double dt) {
    Literal step{.frozen = Frozen(bodies, rows, dt),
                 .lambda = {},
                 .forces = {},
                 .after = {},
                 .bodies = {bodies.begin(), bodies.end()}};
    const engine::SystemEquation& system = step.frozen.system;
    step.lambda = step.frozen.zero();
    engine::solvers::make_solver("pgs")->solve(
        system, {.iterations = 100000, .tolerance_high = 1e-14, .tolerance_low = 1e-14}, step.lambda);
    constraint_forces(system, step.lambda, 0, step.forces);
    for (std::size_t i = 0; i < step.bodies.size(); ++i) {
        step.after.emplace_back(dt *
                                (system.free_acceleration[i] + accelerate(system.inverse_mass[i], step.forces[i])));
        engine::Body& body = step.bodies[i];
        if (body.is_static()) continue;
        body.linear_momentum =
            engine::advance_momentum(body.linear_momentum, body.force + step.forces[i].head<3>(), dt);
        body.angular_momentum =
            engine::advance_momentum(body.angular_momentum, body.torque + step.forces[i].tail<3>(), dt);
        body.position = engine::advance_position(body, body.linear_momentum, dt);
        body.orientation = engine::rotate_exponential(body, body.angular_momentum, dt);
    }
    return step;
}

// A row between body 0 and body 1 along `axis` at their centres, which aims at `push` [m/s].
inline engine::ConstraintRow row_along(const engine::Vector3& axis, double push) {
    engine::ConstraintRow row;
    row.body_a = 0;
    row.body_b = 1;
    row.jacobian.a.head<3>() = -axis;
    row.jacobian.b.head<3>() = axis;
    row.push.lasting = push;
    return row;
}

}  // namespace pushfactor::tests
