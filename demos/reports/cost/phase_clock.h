// CPU time of the stages of steps, without what reading the clock takes.
#pragma once

#include "engine/world.h"

#include <array>
#include <string_view>

namespace pushfactor::demos::reports::cost {

// Stages of a step of the run: the rules that divide it, then engine::Phase.
inline constexpr std::array<std::string_view, 7> phase_names{"rules", "forces",   "rows",     "system",
                                                             "solve", "remember", "integrate"};
using PhaseTimes = std::array<double, phase_names.size()>;  // us

// What lies between two readings of the clock, one right after the other [us]; the median of many.
double clock_cost();

class PhaseClock : public engine::PhaseObserver {
  public:
    explicit PhaseClock(double cost) : cost_(cost) {}

    void begin();  // right before the rules are asked
    void rules_ended() { end(0); }
    void phase_ended(engine::Phase stage) override { end(1 + static_cast<std::size_t>(stage)); }

    const PhaseTimes& times() const { return times_; }  // the sum of all steps

  private:
    void end(std::size_t stage);

    double cost_;
    double last_ = 0.0;
    PhaseTimes times_{};
};

}  // namespace pushfactor::demos::reports::cost
