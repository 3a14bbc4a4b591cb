#include "engine/impacts/impact_solver.h"

#include "engine/solvers/direct.h"

#include <algorithm>
#include <cmath>

namespace pushfactor::engine {

namespace {

// Share of the work that all rows do, whatever its sign, up to which a gain is rounding.
constexpr double rounding = 1e-9;

// Accuracy of the impulses, as a share of the speed of the approach, that an exact answer has; what is enough where
// none is found, and sweeps for it.
constexpr double accuracy = 1e-12, enough = 1e-6;
constexpr int most_sweeps = 1000;

// Speed at which a contact that holds opens, as a share of that of the impact, up to which it counts as closed.
constexpr double lies = 1e-6;

// Work of all rows between the solutions without and with rebounds: W(k) = a + b k + c k^2.
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

}  // namespace

ImpactSolver::ImpactSolver() : solver_(solvers::make_auto()) {}

// What each row is to aim at, and what it has before. One-sided rows that open resist nothing: what comes back to
// them hits them in its turn, and as part of this impact they would make energy.
void ImpactSolver::aim(ImpactProblem& problem) {
    aims_.clear();
    fastest_ = 0.0;
    auto pair = problem.pairs.begin();
    for (std::size_t j = 0; j < problem.rows.size(); ++j) {
        ConstraintRow& row = problem.rows[j];
        while (pair != problem.pairs.end() && j == pair->rows_end) ++pair;
        const bool is_own = pair != problem.pairs.end(), slides = row.label.kind == RowKind::friction;
        const double belt = slides ? row.push.lasting : 0.0;
        const double before = unconstrained(system_, j) - belt;
        aims_.push_back({.before = before});
        if (slides) continue;
        const double opening = row.bounds.c_min >= 0.0 ? before : row.bounds.c_max <= 0.0 ? -before : 0.0;
        if (is_own) fastest_ = std::max(fastest_, -before);
        if (opening > (is_own ? 0.0 : lies * fastest_)) row.bounds.c_min = row.bounds.c_max = 0.0;
        const bool is_one_sided = row.bounds.c_min > -infinity || row.bounds.c_max < infinity;
        row.push = {.correcting = 0.0, .lasting = is_own ? 0.0 : is_one_sided ? before : row.push.lasting};
        if (!is_own) continue;
        const double rebound = -pair->restitution * before;
        if (rebound > pair->least_rebound) aims_.back().rebounds = rebound;
    }
}

void ImpactSolver::find(const ImpactProblem& problem, bool with_rebounds, Columns& impulses) {
    for (std::size_t j = 0; j < problem.rows.size(); ++j) {
        const double rebound = with_rebounds ? aims_[j].rebounds : 0.0;
        system_.b(static_cast<Eigen::Index>(j), 0) =
            problem.rows[j].push.lasting + rebound - unconstrained(system_, j);
    }
    impulses.setZero(static_cast<Eigen::Index>(problem.rows.size()), 1);
    const solvers::Termination termination{
        .iterations = most_sweeps, .tolerance_high = enough * fastest_, .tolerance_low = accuracy * fastest_};
    solver_->solve(system_, termination, impulses);
}

// Whether the solution with rebounds makes more energy than rounding does.
bool ImpactSolver::gains(const ImpactProblem& problem) const {
    double work = 0.0, all = 0.0;
    for (std::size_t j = 0; j < problem.rows.size(); ++j) {
        const double mean = aims_[j].before + 0.5 * acceleration_along(system_, j, on_bodies_);
        const double own = impulses_(static_cast<Eigen::Index>(j), 0) * mean;
        work += own;
        all += std::abs(own);
    }
    return work > rounding * all;
}

// k, with both solutions in place.
double ImpactSolver::share_without_gain(const ImpactProblem& problem) const {
    Work work;
    for (std::size_t j = 0; j < problem.rows.size(); ++j) {
        const auto index = static_cast<Eigen::Index>(j);
        const double without = acceleration_along(system_, j, on_bodies_stopped_);
        const double stopped = stopped_(index, 0), more = impulses_(index, 0) - stopped;
        const double mean = aims_[j].before + 0.5 * without;
        const double faster = 0.5 * (acceleration_along(system_, j, on_bodies_) - without);
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
    is_solved_ = natural_residual(system_, impulses_) <= enough * fastest_;
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
