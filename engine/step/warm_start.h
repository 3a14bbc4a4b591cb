// Warm starts, paper section 6.2.3: which of its last forces an island may keep, and the forces the next step
// starts with. Stored per body, because islands split and merge.
//
// Deviations: 6.2.3 starts each step with the last solution. Frozen forces under a stack are an inverted pendulum;
// the rules here let it come to rest.
#pragma once

#include "engine/solvers/solver.h"
#include "engine/system/islands.h"

#include <algorithm>
#include <span>
#include <vector>

namespace pushfactor::engine {

class WarmStart {
  public:
    // State per body that is carried to the next step.
    struct Memory {
        bool exact = false;  // the body's island was solved to rounding
        int kept = 0;        // steps since an island of the body was solved; 0 for a body without rows
    };

    // How a step treated an island.
    enum class Method { kept, swept, exact, in_small_steps };

    // To be called before the first solve of a step; `awake` are the bodies that take part, out of `bodies`.
    void begin(std::size_t bodies, std::span<const int> awake);

    // To be called before a step with other awake bodies: resting ones belong to no island.
    void forget_islands() { records_.clear(); }

    // Residual [m/s] up to which `island` is not solved; `usual` is the world's termination.
    //
    // After an exact solve accept cached forces only far below tolerance: they may hold an impulse that stopped a
    // motion in one step and would start it again in the opposite direction, and the remaining error grows while
    // nothing is solved.
    double tolerance_high(const Island& island, const solvers::Termination& usual) const {
        return was_exact(island) ? after_exact * usual.tolerance_low : usual.tolerance_high;
    }

    // Whether nearly all of its bodies were in islands solved to rounding in the last step.
    bool was_mostly_exact(const Island& island) const {
        const auto exact = std::count_if(island.bodies.begin(), island.bodies.end(), [this](int body) {
            return memory_[static_cast<std::size_t>(body)].exact;
        });
        return static_cast<double>(exact) >= mostly * island.movable();
    }

    // Whether `island` starts the step with at least some kept forces and has not been solved in it yet.
    bool begins_with_kept(const Island& island) const {
        bool kept = false;
        for (const int body : island.bodies) {
            if (records_[static_cast<std::size_t>(body)].in_island) return false;
            kept = kept || memory_[static_cast<std::size_t>(body)].kept > 0;
        }
        return kept;
    }

    // Number of steps for which the forces of a body have been kept.
    int kept_steps(int body) const { return memory_[static_cast<std::size_t>(body)].kept; }

    // Residual [m/s] above which kept forces are wrong because of a new force. The drift of kept forces is noticed
    // when it slightly exceeds the tolerance, in the first step in which it does.
    static double of_new_force(const solvers::Termination& usual) { return new_force * usual.tolerance_high; }

    // Records a solve, and whether its warm start was kept and outdated by a new force. Within a step the same
    // bodies may be solved again, in a larger island.
    void solved(const Island& island, const solvers::SolveCount& count, bool outdated = false);

    Method method_of(const Island& island) const { return record_of(island).method; }

    // Warm start of a row for the next step, from its current warm start and solution: guess + share (answer -
    // guess), or zero.
    //
    // An error e kept for k steps has built up a velocity k e. This solve removed (k + 1) e; the next step needs
    // only e removed, so the warm start takes 1 / (k + 1) of the change. After an exact solve the warm start is
    // checked again anyway, and after a new force the solution counts fully, because e is not the kept error then.
    // Forces of contradicting rows are as large as the method allows and are not used as a warm start.
    struct Next {
        double share = 1.0;
        bool nothing = false;

        bool takes_answer() const { return share == 1.0 && !nothing; }  // for any guess
        Lambda operator()(const Lambda& guess, const Lambda& answer) const {
            if (nothing) return {};
            return {guess.first + share * (answer.first - guess.first),
                    guess.last + share * (answer.last - guess.last)};
        }
    };
    // For a row between these two bodies of the world, at least one of them in an island.
    Next next(int body_a, int body_b) const {
        const auto a = static_cast<std::size_t>(body_a), b = static_cast<std::size_t>(body_b);
        const Record& record = records_[a].in_island ? records_[a] : records_[b];
        if (record.contradicted) return {.share = 0.0, .nothing = true};
        if (record.method != Method::swept || record.outdated) return {};
        int kept = records_[a].in_island ? memory_[a].kept : memory_[b].kept;
        if (records_[b].in_island) kept = std::min(kept, memory_[b].kept);
        return {.share = 1.0 / (1 + kept), .nothing = false};
    }

    // To be called after the last solve of a step. Bodies that take no part keep their state.
    void end(std::span<const int> awake);

    std::span<const Memory> memory() const { return memory_; }  // by body; empty before the first step
    void set_memory(std::span<const Memory> memory) { memory_.assign(memory.begin(), memory.end()); }

  private:
    // Factor on the lower tolerance for the warm start after an exact solve.
    static constexpr double after_exact = 0.1;
    // Residual of a kept warm start when a new force acts, in upper tolerances. Stacks that come to rest reach at
    // most 3.
    static constexpr double new_force = 30.0;

    static constexpr double mostly = 0.95;

    // Of the step, the same for all bodies of an island.
    struct Record {
        bool in_island = false;
        bool contradicted = false;
        bool outdated = false;
        Method method = Method::kept;
    };

    // Whether all of its bodies were in an island solved to rounding in the last step.
    bool was_exact(const Island& island) const {
        return std::all_of(island.bodies.begin(), island.bodies.end(),
                           [this](int body) { return memory_[static_cast<std::size_t>(body)].exact; });
    }

    const Record& record_of(const Island& island) const {
        return records_[static_cast<std::size_t>(island.bodies.front())];
    }

    std::vector<Memory> memory_;
    std::vector<Record> records_;
};

}  // namespace pushfactor::engine
