// What solving an island may cost. Two bounds:
//
//   - `iterations` of the world's termination are for all solves of a step together. A solve that looks may follow
//     takes half of what is left of them, the last one takes the rest.
//   - Exact answers have to pay off where a solver asks for that (`auto`): an account in multiply-adds, kept body
//   by
//     body because islands part and meet. Every solve of a step pays in what some sweeps cost, an exact method pays
//     for what it does, and it may take half of what is there. After a failure nothing is there for a while, twice
//     as long each time. Where an island stands the account is larger: a tower that begins without forces takes
//     hundreds of sweeps' worth once, and nothing from then on.
//
// In multiply-adds, which are the same on every machine. Not from the paper.
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
    // What the last step leaves to the next, of one body: its share of what its island has taken from the account
    // and not yet paid back.
    struct Debt {
        double work = 0.0;      // multiply-adds
        double failures = 0.0;  // of exact methods, one after the other; shared among bodies, so not whole
        friend auto operator<=>(const Debt&, const Debt&) = default;
    };

    // Before the first solve of a step in which those `awake` of all bodies take part.
    void begin(std::size_t bodies, std::span<const int> awake);

    // Takes back what these bodies have spent since begin().
    void take_back(std::span<const int> awake);

    // Between solves in a step that do not count together.
    void begin_another() { std::fill(spent_.begin(), spent_.end(), Spent{}); }

    enum class Take { half, rest, exact_only };

    // What an exact answer is good for: an island that moves needs another one in the next step, one that stands
    // may keep it for good, and one that begins to stand, without any forces or from an exact answer of the step
    // before (it lands, a layer after the other), needs the most to get there.
    enum class Outlook { moving, standing, beginning };

    // What a solve of `island` may take, where `usual` is the world's own rule. At least one iteration, or none for
    // exact answers only.
    solvers::Termination limits(const Island& island, const solvers::Termination& usual, Take take,
                                Outlook outlook = Outlook::moving) const;

    // Iterations of the step that are left.
    int iterations_left(const Island& island, const solvers::Termination& usual) const {
        return usual.iterations - most_spent(island).iterations;
    }

    // Takes note of what it took.
    void spent(const Island& island, const solvers::SolveCount& count, Outlook outlook = Outlook::moving);

    std::span<const Debt> debts() const { return debts_; }  // by body; empty before the first step
    void set_debts(std::span<const Debt> debts) { debts_.assign(debts.begin(), debts.end()); }

  private:
    // Of a body's islands in this step.
    struct Spent {
        int iterations = 0;
        double exact_work = 0.0;  // multiply-adds
        bool paid_in = false;
    };

    Debt debt_of(const Island& island) const;  // the sum over its bodies
    const Spent& most_spent(const Island& island) const;

    std::vector<Debt> debts_;
    std::vector<Debt> before_;  // by body awake, in their order
    std::vector<Spent> spent_;
};

}  // namespace pushfactor::engine
