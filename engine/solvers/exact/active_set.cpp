#include "engine/solvers/exact/active_set.h"

#include <algorithm>

namespace pushfactor::engine::solvers {

namespace {

// Of all steps but those to a proximal point. A step leaves 1 / rho of what is missing, and rounding errors of the
// factor that grow with rho. Without sliding the matrix is symmetric, and they stay small; where bodies slide,
// those of 1e9 would hide what is free from what is not: three in four problems of figures whose limbs touch, which
// 1e7 solves, would go to the interior point method. A stack of a hundred takes four times as many steps with 1e7.
constexpr double rho_symmetric = 1e9, rho_general = 1e7;
// To a proximal point rho grows after one that is reached, by less after a failure or many changes, and shrinks
// after one that is not, until it falls below least_rho.
constexpr double first_rho = 1e6, least_rho = 1e-3, greatest_rho = 1e9;
constexpr double rho_gain = 10.0, small_rho_gain = 3.0, rho_loss = 0.1;
constexpr int few_changes = 3;
// A proximal point is reached at this share of the residual that the step to it leaves; limit on changes.
constexpr double reached_share = 0.1;
constexpr int most_changes_to_a_point = 8;
// The best iterate on the way to a point that is not reached is the next centre if its error is at most this share
// of its distance.
constexpr double close_share = 0.01;
// Steps without improvement before the method gives up; one whose residual is worse by this factor is the last.
constexpr int most_changes_without_gain = 3;
constexpr double diverged = 1e3;
// Rows that touch separate by rounding errors up to this share of the largest error of a row.
constexpr double touching_share = 1e-9;

}  // namespace

// A row whose leader acts on other bodies is set to its current bound.
void ActiveSet::find_states(const UnitProblem& problem, const std::vector<double>& y) {
    states_.resize(y.size());
    slides_.clear();
    for (std::size_t j = 0; j < y.size(); ++j) {
        const UnitRow& row = problem.rows[j];
        const double scale = bound_scale(row, y);
        const double moved = y[j] + step_size(j) * r_[j];
        states_[j] = State::set;
        if (!(row.scale > 0.0)) continue;
        const bool touches = row.leader < 0 && row.low < row.high && std::abs(r_[j]) * row.scale < touching_;
        const bool may_follow = row.leader >= 0 && states_[static_cast<std::size_t>(row.leader)] == State::free &&
                                act_on_the_same(row, problem.rows[static_cast<std::size_t>(row.leader)]);
        if (row.disc != Disc::none) {
            if (row.disc == Disc::second) find_disc_state(problem, y, j, may_follow);
        } else if (touches || (may_follow && scale == 0.0) ||
                   (moved > row.low * scale && moved < row.high * scale)) {
            states_[j] = State::free;
        } else if (may_follow) {
            states_[j] = moved <= row.low * scale ? State::follows_low : State::follows_high;
        }
    }
}

// Both rows of the disc whose second row is `j`. On the circle, with w = y + r and radius R, the solution is R w /
// |w|; to first order in the changes of w and R this is a force along d = w / |w| that follows R, and across it a
// damper, delta y = -k (y / a + u . delta x) with a = R / |w| and k = a / (1 - a). Around a proximal point c, w = c
// + rho (t - U x) does not depend on y, and the damper is y' = -a rho u . delta x.
void ActiveSet::find_disc_state(const UnitProblem& problem, const std::vector<double>& y, std::size_t j,
                                bool may_follow) {
    const UnitRow &first = problem.rows[j - 1], &second = problem.rows[j];
    const double step = step_size(j);
    const double w_1 = y[j - 1] + step * r_[j - 1], w_2 = y[j] + step * r_[j];
    const double length = std::sqrt(w_1 * w_1 + w_2 * w_2);
    const double radius = second.high * bound_scale(second, y);
    if (length < radius || (may_follow && radius == 0.0)) {
        states_[j - 1] = states_[j] = State::free;
        return;
    }
    states_[j - 1] = states_[j] = State::slides;
    Slide slide{.second = j, .follows = may_follow, .d_1 = w_1 / length, .d_2 = w_2 / length};
    if (!(length > 0.0)) slide.d_1 = 1.0, slide.d_2 = 0.0;
    const double a = length > 0.0 ? radius / length : 0.0;
    slide.k = around_a_point_ ? a * rho_ : std::min(a / (1.0 - a), rho_general);
    slide.own = around_a_point_ ? 0.0 : 1.0;
    slide.along = between(first, slide.d_1, second, slide.d_2);
    slide.across = between(first, -slide.d_2, second, slide.d_1);
    slides_.push_back(slide);
}

// Whether no row follows another.
bool ActiveSet::is_symmetric() const {
    const auto follows = [](State state) { return state == State::follows_low || state == State::follows_high; };
    return slides_.empty() && std::ranges::none_of(states_, follows);
}

double ActiveSet::factor_of(const UnitRow& row, State state) const {
    return state == State::follows_low ? row.low : row.high;
}

void ActiveSet::factor(const Elimination& order, const UnitProblem& problem, Effort& effort, SolveCount& count) {
    if (states_ == factored_ && slides_.empty()) return;
    matrix_.begin(order);
    pushed_.start(problem);
    for (std::size_t j = 0; j < states_.size(); ++j) {
        const UnitRow& row = problem.rows[j];
        if (states_[j] != State::follows_low && states_[j] != State::follows_high) continue;
        pushed_.follow(row.leader, factor_of(row, states_[j]), *row.unit);
    }
    for (const Slide& slide : slides_) {
        const UnitRow& row = problem.rows[slide.second];
        if (slide.follows) pushed_.follow(row.leader, row.high, slide.along);
    }
    double work = 0.0;
    for (std::size_t j = 0; j < states_.size(); ++j) {
        if (states_[j] != State::free) continue;
        pushed_.add(problem, j, rhos_[j], matrix_);
        work += pushed_.leads(j) ? 180.0 : 108.0;
    }
    for (const Slide& slide : slides_) {
        const UnitRow& row = problem.rows[slide.second];
        matrix_.add(row.a, slide.across.a, row.b, slide.across.b, slide.k);
        work += 108.0;
    }
    work += matrix_.factor_work();
    matrix_.factor();
    effort.spend_factorisation(work);
    count.multiply_adds += work;
    ++count.iterations;
    factored_ = states_;
}

// One step. Returns whether the states of the rows are those of the previous step.
bool ActiveSet::change(const Elimination& order, const UnitProblem& problem, std::vector<double>& y, Effort& effort,
                       SolveCount& count) {
    find_states(problem, y);
    if (!around_a_point_) set_rho(problem, is_symmetric() ? rho_symmetric : rho_general);
    const bool stayed = states_ == factored_ && slides_.empty();
    factor(order, problem, effort, count);

    // New values of the rows that are not solved for; with the leader's old value for those that follow.
    moved_.resize(y.size());
    pushes_.resize(y.size());
    for (std::size_t j = 0; j < y.size(); ++j) {
        const UnitRow& row = problem.rows[j];
        switch (states_[j]) {
            case State::free:
                pushes_[j] = rhos_[j] * r_[j];
                continue;
            case State::slides:
                continue;
            case State::set:
                moved_[j] = y[j] + step_size(j) * r_[j];
                clamp(problem, row.leader < 0 ? y : moved_, j, moved_);
                break;
            default:
                moved_[j] = factor_of(row, states_[j]) * bound_scale(row, y);
        }
        pushes_[j] = moved_[j] - y[j];
    }
    for (const Slide& slide : slides_) start_slide(problem, slide, y);
    d_.assign(problem.bodies, Vector6::Zero());
    push(problem, pushed_.all(), pushes_, d_);
    matrix_.solve(d_);
    find_speeds(problem, d_, speeds_);
    for (std::size_t j = 0; j < y.size(); ++j) {
        if (states_[j] == State::free) moved_[j] = y[j] + rhos_[j] * (r_[j] - speeds_[j]);
    }
    auto slide = slides_.begin();
    for (std::size_t j = 0; j < y.size(); ++j) {
        const UnitRow& row = problem.rows[j];
        const double scale = bound_scale(row, y);  // uses the leader's new value
        if (states_[j] == State::slides) {
            if (row.disc == Disc::second) end_slide(problem, *slide++, y);
            continue;
        }
        const bool follows = states_[j] == State::follows_low || states_[j] == State::follows_high;
        y[j] = follows ? factor_of(row, states_[j]) * scale : moved_[j];
        clamp(problem, y, j, y);
    }
    const double work = 2.0 * problem.look_work() + matrix_.solve_work();
    effort.spend(work);
    count.multiply_adds += work;
    return stayed;
}

// The change of a sliding point's force for unchanged leader and velocities.
void ActiveSet::start_slide(const UnitProblem& problem, const Slide& slide, const std::vector<double>& y) {
    const UnitRow& row = problem.rows[slide.second];
    const double y_1 = y[slide.second - 1], y_2 = y[slide.second];
    const double along = slide.d_1 * y_1 + slide.d_2 * y_2, across = slide.d_1 * y_2 - slide.d_2 * y_1;
    const double radius = row.high * bound_scale(row, slide.follows || row.leader < 0 ? y : moved_);
    const double more_along = radius - along, more_across = -(1.0 + slide.own * slide.k) * across;
    pushes_[slide.second - 1] = slide.d_1 * more_along - slide.d_2 * more_across;
    pushes_[slide.second] = slide.d_2 * more_along + slide.d_1 * more_across;
}

// Writes the forces of a sliding point, on the circle.
void ActiveSet::end_slide(const UnitProblem& problem, const Slide& slide, std::vector<double>& y) {
    const UnitRow& row = problem.rows[slide.second];
    double &y_1 = y[slide.second - 1], &y_2 = y[slide.second];
    const double radius = row.high * bound_scale(row, y);
    const double before = slide.d_1 * y_2 - slide.d_2 * y_1;
    const double speed = slide.d_1 * speeds_[slide.second] - slide.d_2 * speeds_[slide.second - 1];
    const double across = -slide.k * (slide.own * before + speed);
    const double length = std::sqrt(radius * radius + across * across);
    const double share = length > 0.0 ? radius / length : 0.0;
    y_1 = share * (radius * slide.d_1 - across * slide.d_2);
    y_2 = share * (radius * slide.d_2 + across * slide.d_1);
}

void ActiveSet::set_rho(const UnitProblem& problem, double rho) {
    rho_ = rho;
    rhos_.assign(problem.rows.size(), rho);
    if (!problem.has_soft) return;
    for (std::size_t j = 0; j < rhos_.size(); ++j) rhos_[j] = rho / (1.0 + rho * problem.rows[j].soft);
}

// Computes x and r of new forces. Returns whether these are the best so far.
bool ActiveSet::look(const UnitProblem& problem, const std::vector<double>& y, Effort& effort, SolveCount& count) {
    follow(problem, y, x_, r_);
    effort.spend(2.0 * problem.look_work());
    count.multiply_adds += 2.0 * problem.look_work();
    return best_.look(problem, y, x_, r_);
}

double ActiveSet::solve(const Elimination& order, const UnitProblem& problem, double tolerance, int changes,
                        std::vector<double>& y, Effort& effort, SolveCount& count) {
    follow(problem, y, x_, r_);
    best_.start(problem, y, x_, r_);
    const int before = count.iterations;
    const double most = order.general_work() + problem.assembly_work();
    int without_gain = 0;
    const bool any_known = std::any_of(y.begin(), y.end(), [](double force) { return force != 0.0; });
    touching_ = any_known ? 0.0 : touching_share * best_.residual();
    // One extra iteration beyond the tolerance: the factor exists, and rounding-level forces keep a stack that is
    // not solved again for a minute from creeping.
    for (bool enough = false; !enough && count.iterations - before < changes &&
                              without_gain < most_changes_without_gain && effort.affords(most);) {
        enough = best_.residual() <= tolerance;
        const bool stayed = change(order, problem, y, effort, count);
        touching_ = 0.0;
        const bool better = look(problem, y, effort, count);
        without_gain = better ? 0 : without_gain + 1;
        if (!better && (stayed || residual(problem, y, r_) > diverged * best_.residual())) break;
    }
    y = best_.y();
    return best_.residual();
}

double ActiveSet::solve_by_proximal_points(const Elimination& order, const UnitProblem& problem, double tolerance,
                                           int changes, std::vector<double>& y, Effort& effort, SolveCount& count) {
    follow(problem, y, x_, r_);
    best_.start(problem, y, x_, r_);
    const int most = count.iterations + changes;
    const double work = order.general_work() + problem.assembly_work();
    double rho = first_rho;
    bool failed = false;
    around_a_point_ = true;
    while (best_.residual() > tolerance && rho >= least_rho && count.iterations < most && effort.affords(work)) {
        factored_.clear();
        set_rho(problem, rho);
        const int before = count.iterations;
        if (!take_proximal_step(order, problem, most, y, effort, count)) {
            failed = true;
            rho *= rho_loss;
            continue;
        }
        const bool easy = !failed && count.iterations - before <= few_changes;
        failed = false;
        rho = std::min(rho * (easy ? rho_gain : small_rho_gain), greatest_rho);
    }
    around_a_point_ = false;
    factored_.clear();
    y = best_.y();
    return best_.residual();
}

// Moves y to the proximal point of rho_, or nowhere, or somewhere on the way; before `most` factorisations in all.
// Returns whether the point was reached.
bool ActiveSet::take_proximal_step(const Elimination& order, const UnitProblem& problem, int most,
                                   std::vector<double>& y, Effort& effort, SolveCount& count) {
    const double work = order.general_work() + problem.assembly_work();
    centre_ = y;
    closest_ = y;
    double least = infinity;
    follow(problem, y, x_, r_);
    for (int k = 0; k < most_changes_to_a_point && count.iterations < most && effort.affords(work); ++k) {
        change(order, problem, y, effort, count);
        look(problem, y, effort, count);
        double way = 0.0;  // m/s
        for (std::size_t j = 0; j < y.size(); ++j) {
            const double moved = y[j] - centre_[j];
            r_[j] -= moved / rho_;
            way = std::max(way, problem.rows[j].scale * std::abs(moved));
        }
        const double error = residual(problem, y, r_);
        effort.spend(problem.look_work());
        if (error <= reached_share * way / rho_) return true;
        if (!(error <= least)) break;
        least = error;
        if (error <= close_share * way) closest_ = y;
    }
    y = closest_;
    return false;
}

}  // namespace pushfactor::engine::solvers
