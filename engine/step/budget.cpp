#include "engine/step/budget.h"

#include <algorithm>
#include <cmath>

namespace pushfactor::engine {

namespace {

// Limit of an island's account and income per step, in sweeps over its rows. Exact solves that are appropriate take
// some 20 to 50; in a moving heap they take hundreds.
constexpr double most_in_sweeps = 120.0, most_where_it_stands = 2000.0, most_where_it_begins = 3000.0;
constexpr double income_in_sweeps = 60.0;
// Small islands have more, in multiply-adds per body, up to `small_island` bodies: a stack of 15 that lands may
// take two million once.
constexpr double most_per_body = 3e5;
constexpr double income_per_body = 3e4;
constexpr double small_island = 200.0;
// A failure costs the account's limit, doubled for every failure just before it, up to this many.
constexpr double most_failures = 5.0;
// Factor for failures of moving islands: a falling heap will have no exact solution in the next steps either.
constexpr double longer_where_it_moves = 4.0;

// Multiply-adds of a sweep.
double sweep_of(const Island& island) {
    return 24.0 * island.columns * island.rows;
}
double at_least(const Island& island, double per_body) {
    return per_body * std::min(1.0 * island.movable(), small_island);
}
double most_of(const Island& island, Budget::Outlook outlook) {
    const double sweeps = outlook == Budget::Outlook::moving     ? most_in_sweeps
                          : outlook == Budget::Outlook::standing ? most_where_it_stands
                                                                 : most_where_it_begins;
    return std::max(sweeps * sweep_of(island), at_least(island, most_per_body));
}
double income_of(const Island& island) {
    return std::max(income_in_sweeps * sweep_of(island), at_least(island, income_per_body));
}

void pay_in(const Island& island, Budget::Debt& debt) {
    if (debt.work > 0.0) debt.work = std::max(0.0, debt.work - income_of(island));
}

}  // namespace

void Budget::begin(std::size_t bodies, std::span<const int> awake) {
    debts_.resize(bodies);
    spent_.resize(bodies);
    before_.clear();
    for (const int body : awake) {
        spent_[static_cast<std::size_t>(body)] = {};
        if (awake.size() < bodies) before_.push_back(debts_[static_cast<std::size_t>(body)]);
    }
}

void Budget::take_back(std::span<const int> awake) {
    for (std::size_t i = 0; i < before_.size(); ++i) debts_[static_cast<std::size_t>(awake[i])] = before_[i];
}

Budget::Debt Budget::debt_of(const Island& island) const {
    Debt sum;
    for (const int body : island.bodies) {
        const Debt& own = debts_[static_cast<std::size_t>(body)];
        sum.work += own.work;
        sum.failures += own.failures;
    }
    return sum;
}

// Within a step islands only merge: the body that has spent most counts.
const Budget::Spent& Budget::most_spent(const Island& island) const {
    const Spent* most = &spent_[static_cast<std::size_t>(island.bodies.front())];
    for (const int body : island.bodies) {
        const Spent& own = spent_[static_cast<std::size_t>(body)];
        if (own.iterations > most->iterations) most = &own;
    }
    return *most;
}

solvers::Termination Budget::limits(const Island& island, const solvers::Termination& usual, Take take,
                                    Outlook outlook) const {
    solvers::Termination own = usual;
    const Spent& so_far = most_spent(island);
    const int left = usual.iterations - so_far.iterations;
    own.iterations = take == Take::exact_only ? 0 : std::max(1, take == Take::half ? (left + 1) / 2 : left);
    own.spent = so_far.exact_work;
    const Debt debt = debt_of(island);
    const double in_account = most_of(island, outlook) - debt.work;
    own.lasts = outlook != Outlook::moving;
    // After a failure only a full account is enough.
    own.credit = debt.failures > 0.0 && debt.work > 0.0 ? 0.0 : std::max(0.0, 0.5 * in_account);
    return own;
}

void Budget::spent(const Island& island, const solvers::SolveCount& count, Outlook outlook) {
    if (count.iterations == 0) return;
    const auto bodies = static_cast<double>(island.movable());
    Spent so_far = most_spent(island);
    Debt debt = debt_of(island);
    if (!so_far.paid_in) pay_in(island, debt);
    debt.work += count.exact_work;
    if (count.gave_up && count.exact_work > 0.0) {
        const double failures = std::min(most_failures, debt.failures / bodies);
        const double longer = outlook == Outlook::moving ? longer_where_it_moves : 1.0;
        debt.work += longer * std::exp2(failures) * most_of(island, outlook);
        debt.failures = bodies * std::min(most_failures, failures + 1.0);
    } else if (count.exact) {
        pay_in(island, debt);  // it has paid off
        debt.failures = 0.0;
    }
    so_far.iterations += count.iterations - count.exact_iterations;  // exact iterations are limited by work
    so_far.exact_work += count.exact_work;
    so_far.paid_in = true;
    for (const int body : island.bodies) {
        debts_[static_cast<std::size_t>(body)] = {debt.work / bodies, debt.failures / bodies};
        spent_[static_cast<std::size_t>(body)] = so_far;
    }
}

}  // namespace pushfactor::engine
