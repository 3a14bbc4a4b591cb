#include "engine/solvers/exact/exact_answer.h"

#include <limits>

namespace pushfactor::engine::solvers {

double asked_speed(const UnitProblem& problem) {
    double fastest = 0.0;
    for (const UnitRow& row : problem.rows) {
        const double alone = row.leader < 0 ? clamped(row, row.t, 1.0) : 0.0;
        fastest = std::max(fastest, row.scale * std::abs(alone));
    }
    return fastest;
}

namespace {

// Limit on active set steps: near the solution a few are enough, and more of them seldom help.
constexpr int most_changes = 10;
// Limit on those to proximal points.
constexpr int most_proximal_changes = 1000;
// Limit on interior point steps.
constexpr int most_steps = 60;
// Residual at which the interior point method hands over, as a share of asked_speed(). It stays slightly inside the
// bounds and converges slowly to rounding, but at this point it has identified the clamped rows, and the active set
// method finishes, or proximal points do; if not, it starts again and goes on to the tolerance.
constexpr double near_share = 1e-8;
// Rows contradict if the sum of their axes weighted with their residuals is at most this share of the residuals.
constexpr double cancelled = 1e-6;

// Rounding error of residuals for forces of this size [m/s], capped: forces beyond what asked_speed() explains are
// no excuse.
double rounding_of(const UnitProblem& problem, const std::vector<double>& y) {
    double largest = 0.0;
    for (std::size_t j = 0; j < y.size(); ++j) largest = std::max(largest, problem.rows[j].scale * std::abs(y[j]));
    return std::min(2.0 * std::numeric_limits<double>::epsilon() * largest, near_share * asked_speed(problem));
}

}  // namespace

// Farkas: if p, the change of force that each row still asks for, moves no body, no forces within the bounds lower
// the residual. Writes p. Bounds that follow another row might give way, so p must vanish on those rows.
bool ExactAnswer::contradicts() {
    follow(problem_, y_, x_, r_);
    p_.resize(y_.size());
    x_.assign(problem_.bodies, Vector6::Zero());
    double asked = 0.0, by_followers = 0.0, yielded = 0.0;
    for (std::size_t j = 0; j < y_.size(); ++j) {
        const UnitRow& row = problem_.rows[j];
        if (row.disc == Disc::first) continue;
        const Change change = natural_change(problem_, y_, r_, j);
        asked += change.squared();
        if (row.leader >= 0) by_followers += change.squared();
        p_[j] = change.of_row;
        yielded += row.soft * change.squared();
        if (row.disc == Disc::second) p_[j - 1] = change.of_first;
    }
    push(problem_, p_, x_);
    double moved = by_followers + yielded;  // a soft row gives way to p even where no body does
    for (int i = 0; i < structure_->movable; ++i) moved += x_[static_cast<std::size_t>(i)].squaredNorm();
    return moved <= cancelled * cancelled * asked;
}

// The component of the forces along p has no effect, and the methods let it grow: it is removed, and p is
// subtracted from the right-hand side, which leaves a solvable problem. Done twice, because p is more accurate the
// second time.
void ExactAnswer::solve_without_contradiction(double tolerance, Effort& effort, SolveCount& count) {
    const std::vector<double> before = y_;
    const auto energy = [&] {
        follow(problem_, y_, x_, r_);
        return objective(problem_, y_, x_);
    };
    const double allowed = std::max(0.0, energy());
    for (int round = 0; round < 2 && contradicts(); ++round) {
        double along_p = 0.0, asked = 0.0;
        for (std::size_t j = 0; j < y_.size(); ++j) {
            along_p += p_[j] * y_[j];
            asked += p_[j] * p_[j];
        }
        for (std::size_t j = 0; j < y_.size(); ++j) {
            y_[j] -= along_p / asked * p_[j];
            problem_.rows[j].t -= p_[j];
        }
        clamp(problem_, y_);
        active_set_.solve(structure_->order, problem_, tolerance, most_changes, y_, effort, count);
        for (std::size_t j = 0; j < p_.size(); ++j) problem_.rows[j].t += p_[j];
    }
    if (energy() > allowed) y_ = before;
}

bool ExactAnswer::solve(UnitRows& rows, double tolerance, double will_do, Effort& effort, SolveCount& count) {
    problem_.take(rows.rows);
    problem_.bodies = rows.velocity.size();
    problem_.bounds_follow = rows.bounds_follow();
    problem_.has_discs = rows.has_discs();
    problem_.has_soft = rows.has_soft();
    y_.resize(rows.rows.size());
    for (std::size_t j = 0; j < y_.size(); ++j) y_[j] = rows.rows[j].y;
    clamp(problem_, y_);
    const bool solved = settle(tolerance, will_do, effort, count);
    for (std::size_t j = 0; j < y_.size(); ++j) rows.rows[j].y = y_[j];
    rows.follow();
    return solved;
}

bool ExactAnswer::settle(double tolerance, double will_do, Effort& effort, SolveCount& count) {
    const Elimination& order = structure_->order;
    const auto enough = [&] { return std::max(tolerance, rounding_of(problem_, y_)); };
    double reached = active_set_.solve(order, problem_, tolerance, most_changes, y_, effort, count);
    if (reached <= enough()) return true;
    const double near = std::max(tolerance, near_share * asked_speed(problem_));
    const auto good = [&] { return reached <= std::max(enough(), will_do); };
    for (const double aim : {near, tolerance}) {
        interior_.solve(order, problem_, aim, most_steps, y_, effort, count);
        reached = active_set_.solve(order, problem_, tolerance, most_changes, y_, effort, count);
        if (!good()) {
            reached = active_set_.solve_by_proximal_points(order, problem_, std::max(tolerance, will_do),
                                                           most_proximal_changes, y_, effort, count);
        }
        if (good()) return reached <= enough();
    }
    if (contradicts()) {
        count.contradicts = true;
        solve_without_contradiction(tolerance, effort, count);
    }
    return false;
}

}  // namespace pushfactor::engine::solvers
