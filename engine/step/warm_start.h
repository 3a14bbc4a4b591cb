// Warm starts, paper section 6.2.3: which of its last forces an island may keep, and with which forces the next
// step begins. Kept body by body, because islands part and meet: an island goes on from what its bodies have.
//
// Deviations: 6.2.3 begins each step with the last answer. Frozen forces under a stack are an inverted pendulum,
// and the rules here are what lets it rest.
#pragma once

#include "engine/solvers/solver.h"
#include "engine/system/islands.h"

#include <algorithm>
#include <span>
#include <vector>

namespace pushfactor::engine {

class WarmStart {
  public:
    // What the last step leaves to the next.
    struct Memory {
        bool exact = false;  // whether the body's island was solved, and to rounding
        int kept = 0;        // steps since an island of the body was solved; 0 for a body without rows
    };

    // What a step did with an island.
    enum class Method { kept, swept, exact, in_small_steps };

    // Before the first solve of a step in which those `awake` of all bodies take part.
    void begin(std::size_t bodies, std::span<const int> awake);

    // Before a step in which others take part than in the last one: those at rest are in no island.
    void forget_islands() { records_.clear(); }

    // The residual [m/s] up to which `island` is not solved, where `usual` is the world's own rule.
    //
    // An exact answer that has stopped a motion holds the force that stopped it; kept for another step it would
    // start the motion again, the other way round. So after an exact solve the guess has to be as good as an
    // answer, and better, because what is left of the error grows while nothing is solved.
    double tolerance_high(const Island& island, const solvers::Termination& usual) const {
        return was_exact(island) ? after_exact * usual.tolerance_low : usual.tolerance_high;
    }

    // Whether nearly all of its bodies were in islands that were solved to rounding in the last step.
    bool was_mostly_exact(const Island& island) const {
        const auto exact = std::count_if(island.bodies.begin(), island.bodies.end(), [this](int body) {
            return memory_[static_cast<std::size_t>(body)].exact;
        });
        return static_cast<double>(exact) >= mostly * island.movable();
    }

    // Whether `island` begins the step with forces that were kept, all or some, and has not been solved in it.
    bool begins_with_kept(const Island& island) const {
        bool kept = false;
        for (const int body : island.bodies) {
            if (records_[static_cast<std::size_t>(body)].in_island) return false;
            kept = kept || memory_[static_cast<std::size_t>(body)].kept > 0;
        }
        return kept;
    }

    // Steps for which the forces of a body have been kept.
    int kept_steps(int body) const { return memory_[static_cast<std::size_t>(body)].kept; }

    // The residual [m/s] beyond which kept forces are wrong because of a new force. What their own error builds up
    // is found out when it is little above the tolerance, in the first step in which it is.
    static double of_new_force(const solvers::Termination& usual) { return new_force * usual.tolerance_high; }

    // Takes note of a solve, and of whether its guess was kept and made wrong by a new force. Within a step the
    // same bodies may be solved again, in a larger island.
    void solved(const Island& island, const solvers::SolveCount& count, bool outdated = false);

    Method method_of(const Island& island) const { return record_of(island).method; }

    // How the next step's force of a row follows from its guess and its answer: guess + share (answer - guess), or
    // zero.
    //
    // A force that was kept for k steps with an error e has built up a velocity of k e. A solve takes off that and
    // e itself, (k + 1) e; the next step needs e alone, so that the guess takes 1 / (k + 1) of the change. After an
    // exact solve the guess is looked at anew, and where a new force made the guess wrong the answer counts whole:
    // there e is not what was kept. Forces of rows that contradict each other are as large as the method
    // lets them: nothing is taken over from those.
    struct Next {
        double share = 1.0;
        bool nothing = false;

        bool takes_answer() const { return share == 1.0 && !nothing; }  // whatever the guess was
        Lambda operator()(const Lambda& guess, const Lambda& answer) const {
            if (nothing) return {};
            return {guess.first + share * (answer.first - guess.first),
                    guess.last + share * (answer.last - guess.last)};
        }
    };
    // Of a row between these two bodies of the world, of which one at least is in an island.
    Next next(int body_a, int body_b) const {
        const auto a = static_cast<std::size_t>(body_a), b = static_cast<std::size_t>(body_b);
        const Record& record = records_[a].in_island ? records_[a] : records_[b];
        if (record.contradicted) return {.share = 0.0, .nothing = true};
        if (record.method != Method::swept || record.outdated) return {};
        int kept = records_[a].in_island ? memory_[a].kept : memory_[b].kept;
        if (records_[b].in_island) kept = std::min(kept, memory_[b].kept);
        return {.share = 1.0 / (1 + kept), .nothing = false};
    }

    // After the last solve of a step. Bodies that take no part in it keep what they have.
    void end(std::span<const int> awake);

    std::span<const Memory> memory() const { return memory_; }  // by body; empty before the first step
    void set_memory(std::span<const Memory> memory) { memory_.assign(memory.begin(), memory.end()); }

  private:
    // How much better than an answer the guess has to be after an exact solve.
    static constexpr double after_exact = 0.1;
    // How many upper tolerances a kept guess misses by where a new force acts. Those of stacks that come to rest
    // miss by at most 3.
    static constexpr double new_force = 30.0;

    static constexpr double mostly = 0.95;

    // Of the step, the same for all bodies of an island.
    struct Record {
        bool in_island = false;
        bool contradicted = false;
        bool outdated = false;
        Method method = Method::kept;
    };

    // Whether all of its bodies were in an island that was solved to rounding in the last step.
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
