// The rows of one part of an island in small steps (small_steps.h) and the sweeps over them: contacts four at a
// time where they share no body (fours.h), all else as blocks of unit rows. The order of blocks that do share one
// is kept, so the bits are those of one block after the other. Internal to the step.
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

    // What it starts from: the runs of the part, and forces in a column of `lambda` [N] as warm start of steps of
    // `h` [s].
    struct Start {
        const SystemEquation& system;
        const Island& island;
        std::span<const RowRun> runs;
        const Columns& lambda;
        Eigen::Index column;
        double h;
    };

    // Puts contacts into fours, and the other rows into `rows`, which has its size. Adds what the forces do to the
    // velocities. `scratch`: by movable body.
    void load(const Start& start, solvers::UnitRows& rows, std::span<int> scratch);

    // One sweep, from the last block to the first if `backwards`; returns the largest change of a row's velocity
    // [m/s].
    double sweep(solvers::UnitRows& rows, bool backwards = false);
    // Of the blocks of bodies that were stirred in sweep `number` or the one before, or of all; bodies of which a
    // row changes by more than `least` [m/s] are stirred. Adds the rows that it sweeps to `updates`.
    double sweep_restless(solvers::UnitRows& rows, bool backwards, double least, int number, bool all,
                          Stirred stirred, double& updates);

    // Natural-map residual of all its rows [m/s].
    double residual(solvers::UnitRows& rows);

    // Calls `visit` for runs of blocks and of fours, in the order of a sweep.
    template <typename Visit>
    void in_turn(const Visit& visit) {
        for (std::size_t begin = 0, end = 0; begin < turns_.size(); begin = end) {
            const int first = turns_[begin];
            while (end < turns_.size() && (turns_[end] < 0) == (first < 0)) ++end;
            if (first < 0) {
                visit(fours().subspan(static_cast<std::size_t>(-1 - first), end - begin));
            } else {
                visit(blocks().subspan(static_cast<std::size_t>(first), end - begin));
            }
        }
    }

    std::span<Block> blocks() { return blocks_; }  // those that are not in fours, ascending
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

    void find_groups(const Start& start, std::span<int> scratch);
    static void put_in_four(const Start& start, const Group& group, int movable, FourContacts& four);
    void load_blocks(const Start& start, solvers::UnitRows& rows) const;
    int turn_at(std::size_t i, bool backwards) const { return turns_[backwards ? turns_.size() - 1 - i : i]; }
    double sweep_turn(solvers::UnitRows& rows, int turn);
    static double sweep_some(solvers::UnitRows& rows, std::span<const Block> some);
    static double sweep_some(solvers::UnitRows& rows, std::span<FourContacts> some);

    std::vector<Block> blocks_;
    std::vector<FourContacts> fours_;
    std::vector<int> turns_;  // in the order of a sweep: k for block k, -1 - k for four k
    std::vector<Group> groups_;
};

}  // namespace pushfactor::engine
