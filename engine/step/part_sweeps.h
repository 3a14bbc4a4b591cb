// The sweeps of small steps (small_steps.h) over the rows of one part of an island: solvers::sweep() for blocks,
// and contacts four at a time where they share no body (fours.h). The order of blocks that do share one is
// kept, so the bits are those of one block after the other. Internal to the step.
#pragma once

#include "engine/solvers/unit_rows.h"
#include "engine/step/fours.h"

#include <span>
#include <vector>

namespace pushfactor::engine {

class PartSweeps {
  public:
    using Block = solvers::UnitRows::Block;
    // By movable body: the sweep of the current solve in which a row of it last changed its velocity by more than
    // what is asked for; `never` before.
    using Stirred = std::span<int>;
    enum : int { never = -2 };

    // The blocks of rows `begin_row` .. `end_row` - 1, without couplings.
    void load(const solvers::UnitRows& rows, int begin_row, int end_row);
    // Puts contacts into fours, without what Aim needs. `scratch`: by movable body.
    void pack(solvers::UnitRows& rows, std::span<int> scratch);
    // Writes y and t of the fours to the rows.
    void unpack(solvers::UnitRows& rows) const;

    // One sweep; returns the largest change of a row's velocity [m/s].
    double sweep(solvers::UnitRows& rows);
    // Of the blocks of bodies that were stirred in sweep `number` or the one before, or of all; bodies of which a
    // row changes by more than `least` [m/s] are stirred. Adds the rows that it sweeps to `updates`.
    double sweep_restless(solvers::UnitRows& rows, double least, int number, bool all, Stirred stirred,
                          double& updates);

    // Natural-map residual of all its rows, after unpack() [m/s].
    double residual(solvers::UnitRows& rows) const;

    std::span<Block> blocks() { return blocks_; }  // after pack() those that are not in fours
    std::span<FourContacts> fours() { return fours_; }

  private:
    // Blocks without common bodies.
    struct Group {
        std::array<Block, FourContacts::count> blocks{};
        std::size_t count = 0;
        bool is_full = false;
    };
    // Groups that are open to the next contact, at most: the last ones, so that what is swept together lies
    // together in memory.
    static constexpr std::size_t open_groups = 16;

    void put_in_four(const solvers::UnitRows& rows, const Group& group);
    double sweep_blocks(solvers::UnitRows& rows, std::span<const Block> some);
    double sweep_fours(solvers::UnitRows& rows, std::span<FourContacts> some);

    std::vector<Block> blocks_, packed_;  // swept one by one; those of the contacts in fours
    std::vector<FourContacts> fours_;
    std::vector<int> turns_;  // in the order of a sweep: k for block k, -1 - k for four k
    std::vector<Group> groups_;
};

}  // namespace pushfactor::engine
