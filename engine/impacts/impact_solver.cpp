#include "engine/impacts/impact_solver.h"

#include "engine/solvers/auto.h"

#include <algorithm>
#include <cmath>

namespace pushfactor::engine {

namespace {

// Share of the work that all rows do, whatever its sign, up to which a gain is rounding.
constexpr double rounding = 1e-9;

// Accuracy of the impulses, as a share of the speed of the approach, and sweeps for it where no exact answer is
// found.
constexpr double accuracy = 1e-12;
constexpr int most_sweeps = 1000;

// Work of the pair between the solutions without and with rebounds: W(k) = a + b k + c k^2.
struct Work {
    double a = 0.0, b = 0.0, c = 0.0;

    // The largest k up to 1 where W does not exceed zero, if it does at 1; 0 if there is none.
    double last_zero() const {
        if (!(a + b + c > 0.0)) return 1.0;
        if (!(a < 0.0)) return 0.0;
        // a < 0 < W(1): one zero between; the form that does not cancel.
        const double root = std::sqrt(std::max(0.0, b * b - 4.0 * a * c));
        const double k = b > 0.0 ? -2.0 * a / (b + root) : (root - b) / (2.0 * c);
        return std::clamp(k, 0.0, 1.0);
    }
};

double along(const ConstraintRow& row, std::span<const Vector6> velocities) {
    return row.jacobian.a.dot(velocities[static_cast<std::size_t>(row.body_a)]) +
           row.jacobian.b.dot(velocities[static_cast<std::size_t>(row.body_b)]);
}

}  // namespace

ImpactSolver::ImpactSolver() : solver_(solvers::make_auto()) {}

// What each row is to aim at, and what it has before.
void ImpactSolver::aim(ImpactProblem& problem) {
    aims_.clear();
    for (std::size_t j = 0; j < problem.rows.size(); ++j) {
        ConstraintRow& row = problem.rows[j];
        const double before = along(row, system_.free_acceleration) - problem.carried[j];
        Aim aim{.before = before};
        if (row.label.kind == RowKind::friction) {
            aim.before -= row.push.lasting;  // relative to a belt
        } else if (j >= problem.own_rows) {
            // It keeps its velocity; one that is open on one side may open further.
            const double kept = row.bounds.c_min >= 0.0   ? std::min(before, 0.0)
                                : row.bounds.c_max <= 0.0 ? std::max(before, 0.0)
                                                          : before;
            row.push = {.correcting = 0.0, .lasting = kept};
        } else {
            const double rebound = -problem.restitution * before;
            if (rebound > problem.least_rebound) aim.rebounds = rebound;
            if (before >= 0.0) row.bounds.c_max = 0.0;  // has not come closer: it bounces in its turn
        }
        aims_.push_back(aim);
    }
}

void ImpactSolver::find(const ImpactProblem& problem, bool with_rebounds, Columns& impulses) {
    double fastest = 0.0;
    for (std::size_t j = 0; j < problem.rows.size(); ++j) {
        const ConstraintRow& row = problem.rows[j];
        const bool is_own = j < problem.own_rows && row.label.kind == RowKind::contact;
        const double wanted = is_own && with_rebounds ? aims_[j].rebounds : row.push.lasting;
        system_.b(static_cast<Eigen::Index>(j), 0) = wanted - unconstrained(system_, j);
        if (is_own) fastest = std::max(fastest, -aims_[j].before);
    }
    impulses.setZero(static_cast<Eigen::Index>(problem.rows.size()), 1);
    const solvers::Termination termination{
        .iterations = most_sweeps, .tolerance_high = accuracy * fastest, .tolerance_low = accuracy * fastest};
    solver_->solve(system_, termination, impulses);
}

// What the impulses on the bodies change along the row [m/s].
double ImpactSolver::change(const ConstraintRow& row, std::span<const Vector6> impulses) const {
    const auto half = [&](int body, const Vector6& axis) {
        const auto i = static_cast<std::size_t>(body);
        return axis.dot(accelerate(system_.inverse_mass[i], impulses[i]));
    };
    return half(row.body_a, row.jacobian.a) + half(row.body_b, row.jacobian.b);
}

// Whether the solution with rebounds makes more energy than rounding does.
bool ImpactSolver::gains(const ImpactProblem& problem) const {
    double work = 0.0, all = 0.0;
    for (std::size_t j = 0; j < problem.own_rows; ++j) {
        const double mean = aims_[j].before + 0.5 * change(problem.rows[j], on_bodies_);
        const double own = impulses_(static_cast<Eigen::Index>(j), 0) * mean;
        work += own;
        all += std::abs(own);
    }
    return work > rounding * all;
}

// k, with both solutions in place.
double ImpactSolver::share_without_gain(const ImpactProblem& problem) const {
    Work work;
    for (std::size_t j = 0; j < problem.own_rows; ++j) {
        const auto index = static_cast<Eigen::Index>(j);
        const double without = change(problem.rows[j], on_bodies_stopped_);
        const double stopped = stopped_(index, 0), more = impulses_(index, 0) - stopped;
        const double mean = aims_[j].before + 0.5 * without;
        const double faster = 0.5 * (change(problem.rows[j], on_bodies_) - without);
        work.a += stopped * mean;
        work.b += stopped * faster + more * mean;
        work.c += more * faster;
    }
    return work.last_zero();
}

std::span<const Vector6> ImpactSolver::solve(ImpactProblem& problem) {
    system_.carried.assign(problem.carried.begin(), problem.carried.end());
    build_system(problem.bodies, problem.rows.all(), 1.0, system_);
    aim(problem);
    find(problem, true, impulses_);
    constraint_forces(system_, impulses_, 0, on_bodies_);
    if (gains(problem)) {
        find(problem, false, stopped_);
        constraint_forces(system_, stopped_, 0, on_bodies_stopped_);
        const double k = share_without_gain(problem);
        impulses_ = stopped_ + k * (impulses_ - stopped_);
        for (std::size_t i = 0; i < on_bodies_.size(); ++i) {
            on_bodies_[i] = on_bodies_stopped_[i] + k * (on_bodies_[i] - on_bodies_stopped_[i]);
        }
    }
    external_work_ = 0.0;
    for (std::size_t j = 0; j < problem.rows.size(); ++j) {
        const bool slides = problem.rows[j].label.kind == RowKind::friction;
        const double outside = problem.carried[j] + (slides ? problem.rows[j].push.lasting : 0.0);
        external_work_ += impulses_(static_cast<Eigen::Index>(j), 0) * outside;
    }
    return on_bodies_;
}

}  // namespace pushfactor::engine
