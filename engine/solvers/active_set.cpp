#include "engine/solvers/active_set.h"

namespace pushfactor::engine::solvers {

namespace {

using Row = UnitProblem::Row;

constexpr double rho = 1e9;
// Changes that improve nothing before the method gives up; one that leads this much farther away is the last.
constexpr int most_without_gain = 3;
constexpr double diverged = 1e3;

bool act_on_the_same(const Row& a, const Row& b) {
    return a.a == b.a && a.b == b.b;
}

}  // namespace

// The free rows are judged by a Jacobi step: judged with rho, every small residual would look like a change of the
// active set. A row whose leader acts on other bodies is set to where its bound is now.
void ActiveSet::find_states(const UnitProblem& problem, const std::vector<double>& y) {
    states_.resize(y.size());
    for (std::size_t j = 0; j < y.size(); ++j) {
        const Row& row = problem.rows[j];
        const double scale = bound_scale(row, y);
        const double moved = y[j] + r_[j];
        states_[j] = State::set;
        if (!(row.scale > 0.0)) continue;
        if (moved > row.low * scale && moved < row.high * scale) {
            states_[j] = State::free;
        } else if (row.leader >= 0 && states_[static_cast<std::size_t>(row.leader)] == State::free &&
                   act_on_the_same(row, problem.rows[static_cast<std::size_t>(row.leader)])) {
            states_[j] = moved <= row.low * scale ? State::follows_low : State::follows_high;
        }
    }
}

double ActiveSet::factor_of(const Row& row, State state) const {
    return state == State::follows_low ? row.low : row.high;
}

void ActiveSet::factor(const Elimination& order, const UnitProblem& problem, Effort& effort, SolveCount& count) {
    if (states_ == factored_) return;
    matrix_.begin(order);
    pushed_.resize(problem.rows.size());
    bool any_follows = false;
    for (std::size_t j = 0; j < states_.size(); ++j) {
        const Row& row = problem.rows[j];
        if (states_[j] == State::free) pushed_[j] = *row.unit;
        if (states_[j] != State::follows_low && states_[j] != State::follows_high) continue;
        Jacobian& pushed = pushed_[static_cast<std::size_t>(row.leader)];
        const double c = factor_of(row, states_[j]);
        pushed.a += c * row.unit->a;
        pushed.b += c * row.unit->b;
        any_follows = true;
    }
    double work = 0.0;
    for (std::size_t j = 0; j < states_.size(); ++j) {
        if (states_[j] != State::free) continue;
        const Row& row = problem.rows[j];
        if (any_follows) {
            matrix_.add_product(row.a, rho * pushed_[j].a, row.unit->a, row.b, rho * pushed_[j].b, row.unit->b);
        } else {
            matrix_.add(row.a, row.unit->a, row.b, row.unit->b, rho);
        }
        work += any_follows ? 180.0 : 108.0;
    }
    work += matrix_.factor_work();
    matrix_.factor();
    effort.spend_factorisation(work);
    count.multiply_adds += work;
    ++count.iterations;
    factored_ = states_;
}

// One change. Returns whether the rows are in the states of the change before.
bool ActiveSet::change(const Elimination& order, const UnitProblem& problem, std::vector<double>& y, Effort& effort,
                       SolveCount& count) {
    find_states(problem, y);
    const bool stayed = states_ == factored_;
    factor(order, problem, effort, count);

    moved_.resize(
        y.size());  // where rows go that are not solved for; before their leader has moved, if they follow
    d_.assign(problem.bodies, Vector6::Zero());
    for (std::size_t j = 0; j < y.size(); ++j) {
        const Row& row = problem.rows[j];
        if (states_[j] == State::free) {
            for (const auto& [body, axis] : {std::pair{row.a, &pushed_[j].a}, std::pair{row.b, &pushed_[j].b}}) {
                d_[static_cast<std::size_t>(body)].noalias() += *axis * (rho * r_[j]);
            }
            continue;
        }
        const bool follows = states_[j] != State::set;
        moved_[j] = follows ? factor_of(row, states_[j]) * bound_scale(row, y)
                            : clamped(row, y[j] + r_[j], bound_scale(row, row.leader < 0 ? y : moved_));
        push(row, moved_[j] - y[j], d_);
    }
    matrix_.solve(d_);
    for (std::size_t j = 0; j < y.size(); ++j) {
        const Row& row = problem.rows[j];
        if (states_[j] == State::free) moved_[j] = y[j] + rho * (r_[j] - along(row, d_));
    }
    for (std::size_t j = 0; j < y.size(); ++j) {
        const Row& row = problem.rows[j];
        const double scale = bound_scale(row, y);  // of the leader where it has moved to
        const bool follows = states_[j] != State::set && states_[j] != State::free;
        y[j] = clamped(row, follows ? factor_of(row, states_[j]) * scale : moved_[j], scale);
    }
    const double work = 2.0 * problem.look_work() + matrix_.solve_work();
    effort.spend(work);
    count.multiply_adds += work;
    return stayed;
}

double ActiveSet::solve(const Elimination& order, const UnitProblem& problem, double tolerance, int changes,
                        std::vector<double>& y, Effort& effort, SolveCount& count) {
    follow(problem, y, x_, r_);
    best_.start(problem, y, x_, r_);
    const int before = count.iterations;
    const double most = order.general_work() + problem.assembly_work();
    int without_gain = 0;
    // One change more than the tolerance asks for: it has its factor already and takes the rest down to rounding,
    // which a stack that is not solved again for a minute would add up to a motion.
    for (bool enough = false; !enough && count.iterations - before < changes && without_gain < most_without_gain &&
                              effort.affords(most);) {
        enough = best_.residual() <= tolerance;
        const bool stayed = change(order, problem, y, effort, count);
        follow(problem, y, x_, r_);
        effort.spend(2.0 * problem.look_work());
        count.multiply_adds += 2.0 * problem.look_work();
        const bool better = best_.look(problem, y, x_, r_);
        without_gain = better ? 0 : without_gain + 1;
        if (!better && (stayed || residual(problem, y, r_) > diverged * best_.residual())) break;
    }
    y = best_.y();
    return best_.residual();
}

}  // namespace pushfactor::engine::solvers
