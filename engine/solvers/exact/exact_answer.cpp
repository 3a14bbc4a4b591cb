#include "engine/solvers/exact/exact_answer.h"

#include <limits>

namespace pushfactor::engine::solvers {

double asked_speed(const UnitProblem& problem) {
    double fastest = 0.0;
    for (const UnitProblem::Row& row : problem.rows) {
        const double alone = row.leader < 0 ? clamped(row, row.t, 1.0) : 0.0;
        fastest = std::max(fastest, row.scale * std::abs(alone));
    }
    return fastest;
}

namespace {

// Changes of the active set at first, and after the interior point method. From near the answer a few are enough;
// more of them find no end more often than one.
constexpr int first_changes = 6;
constexpr int later_changes = 10;
// And of careful ones, where discs slide.
constexpr int first_careful_changes = 3;
// They come first where the guess is as near as this share of the largest speed that a row asks for, and as long as
// what the interior point method may take is left besides.
constexpr double careful_share = 1e-2;
constexpr double interior_factorisations = 14.0;
constexpr int careful_changes = 40;
constexpr auto bold = ActiveSet::Pace::bold;
// Steps of the interior point method.
constexpr int most_steps = 60;
// It stays a little inside the bounds and takes long to get to rounding. But at this share of the largest speed
// that a row asks for it knows which rows are clamped, and from there the active set gets to the end; if not, a
// longer way shows more.
constexpr double near_share = 1e-8;
// Rows whose residual no force can lower: their axes, weighted with it, sum up to this share of it or less.
constexpr double cancelled = 1e-6;

// What the residual of a row can be told to with forces of this size [m/s]; forces that are larger than what is
// asked for explains are no excuse.
double rounding_of(const UnitProblem& problem, const std::vector<double>& y) {
    double largest = 0.0;
    for (std::size_t j = 0; j < y.size(); ++j) largest = std::max(largest, problem.rows[j].scale * std::abs(y[j]));
    return std::min(2.0 * std::numeric_limits<double>::epsilon() * largest, near_share * asked_speed(problem));
}

}  // namespace

// Farkas: where p, the change of force that each row still asks for, moves no body, no forces between the bounds
// lower the residual. Writes p. Bounds that follow another row might give way, so p has to do without theirs.
bool ExactAnswer::contradicts() {
    follow(problem_, y_, x_, r_);
    p_.resize(y_.size());
    x_.assign(problem_.bodies, Vector6::Zero());
    double asked = 0.0, by_followers = 0.0;
    for (std::size_t j = 0; j < y_.size(); ++j) {
        const UnitProblem::Row& row = problem_.rows[j];
        if (row.disc == Disc::first) continue;
        const Change change = natural_change(problem_, y_, r_, j);
        asked += change.squared();
        if (row.leader >= 0) by_followers += change.squared();
        p_[j] = change.of_row;
        push(row, p_[j], x_);
        if (row.disc == Disc::none) continue;
        p_[j - 1] = change.of_first;
        push(problem_.rows[j - 1], p_[j - 1], x_);
    }
    double moved = by_followers;
    for (int i = 0; i < structure_->movable; ++i) moved += x_[static_cast<std::size_t>(i)].squaredNorm();
    return moved <= cancelled * cancelled * asked;
}

// What the forces have of p they have for nothing, and the methods let it grow. It is taken off, and p is taken
// from the right side: what is left of the problem has an answer. Once more, because p is known better then.
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
        active_set_.solve(structure_->order, problem_, bold, tolerance, later_changes, y_, effort, count);
        for (std::size_t j = 0; j < p_.size(); ++j) problem_.rows[j].t += p_[j];
    }
    if (energy() > allowed) y_ = before;
}

bool ExactAnswer::settle(double tolerance, double will_do, Effort& effort, SolveCount& count) {
    const Elimination& order = structure_->order;
    const auto enough = [&] { return std::max(tolerance, rounding_of(problem_, y_)); };
    double reached = active_set_.solve(order, problem_, bold, tolerance, first_changes, y_, effort, count);
    const auto slide_carefully = [&](int changes) {
        if (!problem_.has_discs || reached <= enough()) return;
        reached =
            active_set_.solve(order, problem_, ActiveSet::Pace::careful, tolerance, changes, y_, effort, count);
    };
    const double others = interior_factorisations * (order.general_work() + problem_.assembly_work());
    const bool is_near = reached <= careful_share * asked_speed(problem_);
    if (is_near && effort.affords(others)) slide_carefully(first_careful_changes);
    const double near = near_share * asked_speed(problem_);
    for (const double aim : {std::max(tolerance, near), tolerance}) {
        if (reached <= enough()) return true;
        interior_.solve(order, problem_, aim, most_steps, y_, effort, count);
        reached = active_set_.solve(order, problem_, bold, tolerance, later_changes, y_, effort, count);
        if (problem_.has_discs && reached <= will_do) return reached <= enough();
    }
    slide_carefully(careful_changes);
    if (reached <= enough()) return true;
    if (contradicts()) {
        count.contradicts = true;
        solve_without_contradiction(tolerance, effort, count);
    }
    return false;
}

}  // namespace pushfactor::engine::solvers
