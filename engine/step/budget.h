// Budget for solving an island. Two bounds:
//
//   - `iterations` of the world's termination limits all solves of a step together. A solve that may be followed by
//     a re-solve takes half of the rest, the last one takes all of it.
//   - Exact solves have to pay off if a solver asks for that (`auto`): an account in multiply-adds, kept per body
//     because islands split and merge. Every step pays in the cost of some sweeps, an exact method pays for its
//     work and may take half of the account. After a failure the account is empty for a while, twice as long each
//     time. For an island at rest it is larger: a tower that starts without forces takes hundreds of sweeps' worth
//     once, and nothing from then on.
//
// Measured in multiply-adds, which are machine-independent. Not from the paper.
#pragma once

#include "engine/solvers/solver.h"
#include "engine/system/islands.h"

#include <algorithm>
#include <compare>
#include <span>
#include <vector>

namespace pushfactor::engine {

class Budget {
  public:
    // State per body that is carried to the next step: its share of what its island has taken from the account and
    // not yet paid back.
    struct Debt {
        double work = 0.0;      // multiply-adds
        double failures = 0.0;  // consecutive ones of exact methods; shared among bodies, so fractional
        friend auto operator<=>(const Debt&, const Debt&) = default;
    };

    // To be called before the first solve of a step; `awake` are the bodies that take part, out of `bodies`.
    void begin(std::size_t bodies, std::span<const int> awake);

    // Reverts what these bodies have spent since begin().
    void take_back(std::span<const int> awake);

    // To be called between solves of a step that are budgeted separately.
    void begin_another() { std::fill(spent_.begin(), spent_.end(), Spent{}); }

    enum class Take { half, rest, exact_only };

    // How long an exact solution is useful: a moving island needs a new one in the next step, a standing one may
    // keep it for good, and one that begins to stand, without forces or after an exact solve in the previous step
    // (it lands layer by layer), needs the largest budget.
    enum class Outlook { moving, standing, beginning };

    // Limits for a solve of `island`; `usual` is the world's termination. At least one iteration, or none for exact
    // solves only.
    solvers::Termination limits(const Island& island, const solvers::Termination& usual, Take take,
                                Outlook outlook = Outlook::moving) const;

    // Remaining iterations of the step.
    int iterations_left(const Island& island, const solvers::Termination& usual) const {
        return usual.iterations - most_spent(island).iterations;
    }

    // Books the cost of a solve.
    void spent(const Island& island, const solvers::SolveCount& count, Outlook outlook = Outlook::moving);

    std::span<const Debt> debts() const { return debts_; }  // by body; empty before the first step
    void set_debts(std::span<const Debt> debts) { debts_.assign(debts.begin(), debts.end()); }

  private:
    // Of the body's islands in this step.
    struct Spent {
        int iterations = 0;
        double exact_work = 0.0;  // multiply-adds
        bool paid_in = false;
    };

    Debt debt_of(const Island& island) const;  // the sum over its bodies
    const Spent& most_spent(const Island& island) const;

    std::vector<Debt> debts_;
    std::vector<Debt> before_;  // of awake bodies, in order
    std::vector<Spent> spent_;
};

}  // namespace pushfactor::engine
