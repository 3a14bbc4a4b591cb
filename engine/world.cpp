// The step, paper sections 3.2, 5, 6 and 8.1.
//
// The paper solves twice when the single-frame push is used: f_cv with the whole push moves the bodies, f_c0 with
// the lasting part alone sets their velocity. Both have the same A, so here they are two columns of one solve.
#include "engine/world.h"

#include <algorithm>
#include <cassert>

namespace pushfactor::engine {

namespace {

// How often a step is solved anew because bodies that it has thrown would meet others: one more body of a chain of
// collisions each time.
constexpr int most_looks = 8;
// What a method that goes to rounding leaves only where no answer exists [m/s].
constexpr double contradiction = 1e-3;

}  // namespace

StepCount World::step(double dt, StageObserver* observer) {
    assert(dt > 0.0);
    const auto ended = [observer](Stage stage) {
        if (observer) observer->stage_ended(stage);
    };
    add_forces();  // 3.1
    ended(Stage::forces);
    append_rows(dt);  // 5
    ended(Stage::rows);
    build_system(bodies, rows_, dt, system_);  // 6: A lambda = b, 6.2.9
    ended(Stage::system);
    const solvers::SolveCount solved = solve_and_look(dt);  // 7
    ended(Stage::solve);
    remember();  // 6.2.3
    ended(Stage::remember);
    integrate(dt);  // 3.2, 8.1
    time_ += dt;
    ended(Stage::integrate);
    return count(solved);
}

void World::add_forces() {
    for (Body& body : bodies) {
        body.force.setZero();
        body.torque.setZero();
    }
    for (const auto& source : forces) source->add_forces(bodies, time_);
}

void World::append_rows(double dt) {
    rows_.clear();
    row_ends_.clear();
    for (const auto& source : constraints) {
        source->append_rows(bodies, dt, rows_);
        row_ends_.push_back(rows_.size());
    }
}

solvers::SolveCount World::solve() {
    const Eigen::Index last = system_.column_count() - 1;
    lambda_.resize(system_.row_count(), system_.column_count());
    for (Eigen::Index j = 0; j < lambda_.rows(); ++j) {
        const Lambda& guess = rows_[static_cast<std::size_t>(j)].guess;
        lambda_(j, 0) = guess.first;
        lambda_(j, last) = guess.last;
    }
    if (rows_.empty()) return {};
    // An exact answer that has just stopped a motion holds the force that stopped it, and kept for the next step it
    // would start the motion again, the other way round. So after one the guess must be as good as an answer, and
    // better: what is left grows while nothing is solved.
    solvers::Termination now = termination;
    if (was_exact_) now.tolerance_high = now.tolerance_low = 0.1 * termination.tolerance_low;
    const solvers::SolveCount count = solver->solve(system_, now, lambda_);
    was_exact_ = count.exact;
    kept_before_ = kept_;
    kept_ = count.iterations > 0 ? 0 : kept_ + 1;
    contradicted_ = count.exact && count.residual > contradiction;
    return count;
}

solvers::SolveCount World::solve_and_look(double dt) {
    solvers::SolveCount solved = solve();
    constraint_forces(system_, lambda_, 0, moving_);
    for (int look = 0; look < most_looks && !foresaw(dt); ++look) {
        append_rows(dt);
        build_system(bodies, rows_, dt, system_);
        const solvers::SolveCount again = solve();
        constraint_forces(system_, lambda_, 0, moving_);
        solved.iterations += again.iterations;
        solved.multiply_adds += again.multiply_adds;
    }
    return solved;
}

bool World::foresaw(double dt) {
    return std::all_of(constraints.begin(), constraints.end(),
                       [&](const auto& source) { return source->foresaw(bodies, moving_, dt); });
}

void World::remember() {
    const Eigen::Index last = lambda_.cols() - 1;
    // Forces that were kept for k steps and wrong by e have made a motion of k e meanwhile. A solve takes off that
    // and e itself; the next step needs e alone. An exact one shows this by itself, as it is looked at anew
    // (solve()).
    const double share = kept_ == 0 && !was_exact_ ? 1.0 / (1 + kept_before_) : 1.0;
    const auto next = [share](double guess, double answer) { return guess + share * (answer - guess); };
    answers_.assign(rows_.size(), {});
    // Forces of rows that contradict each other are as large as the method lets them, and nobody's guess.
    for (Eigen::Index j = 0; j < lambda_.rows() && !contradicted_; ++j) {
        const Lambda& guess = rows_[static_cast<std::size_t>(j)].guess;
        answers_[static_cast<std::size_t>(j)] = {next(guess.first, lambda_(j, 0)),
                                                 next(guess.last, lambda_(j, last))};
    }
    std::size_t begin = 0;
    for (std::size_t s = 0; s < constraints.size(); ++s) {
        constraints[s]->remember(std::span(answers_).subspan(begin, row_ends_[s] - begin));
        begin = row_ends_[s];
    }
}

void World::set_memory(const Memory& memory) {
    time_ = memory.time;
    was_exact_ = memory.was_exact;
    kept_ = memory.kept;
}

void World::prepare(double dt) {
    add_forces();
    append_rows(dt);
    build_system(bodies, rows_, dt, system_);
    solve();
    remember();
}

void World::kick_back_half(double dt) {
    prepare(dt);
    constraint_forces(system_, lambda_, lambda_.cols() - 1, lasting_);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        Body& body = bodies[i];
        if (body.is_static()) continue;
        const Vector6& f_c = lasting_[i];
        body.linear_momentum = advance_momentum(body.linear_momentum, body.force + f_c.head<3>(), -0.5 * dt);
        body.angular_momentum = advance_momentum(body.angular_momentum, body.torque + f_c.tail<3>(), -0.5 * dt);
    }
}

void World::integrate(double dt) {
    const Eigen::Index last = lambda_.cols() - 1;
    if (last > 0) constraint_forces(system_, lambda_, last, lasting_);
    const std::vector<Vector6>& momentum_forces = last > 0 ? lasting_ : moving_;

    for (std::size_t i = 0; i < bodies.size(); ++i) {
        Body& body = bodies[i];
        if (body.is_static()) continue;
        const Vector6& f_cv = moving_[i];
        const Vector6& f_c0 = momentum_forces[i];

        // Momenta that live for this move only (8.1).
        const Vector3 p = advance_momentum(body.linear_momentum, body.force + f_cv.head<3>(), dt);
        const Vector3 l = advance_momentum(body.angular_momentum, body.torque + f_cv.tail<3>(), dt);
        body.position = advance_position(body, p, dt);
        body.orientation = rotate(body, l, dt);

        body.linear_momentum = advance_momentum(body.linear_momentum, body.force + f_c0.head<3>(), dt);
        body.angular_momentum = advance_momentum(body.angular_momentum, body.torque + f_c0.tail<3>(), dt);
    }
}

StepCount World::count(const solvers::SolveCount& solved) const {
    StepCount count;
    for (const ConstraintRow& row : rows_) ++count.rows_of_kind[static_cast<std::size_t>(row.label.kind)];
    count.columns = rows_.empty() ? 0 : static_cast<int>(system_.column_count());
    count.sweeps = solved.iterations;
    count.multiply_adds = solved.multiply_adds;
    return count;
}

}  // namespace pushfactor::engine
