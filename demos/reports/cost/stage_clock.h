// CPU time of the stages of steps, without what reading the clock takes.
#pragma once

#include "engine/world.h"

#include <array>
#include <string_view>

namespace pushfactor::demos::reports::cost {

// Stages of a step of the run: the rules that divide it, then engine::Stage.
inline constexpr std::array<std::string_view, 7> stage_names{"rules", "forces",   "rows",     "system",
                                                             "solve", "remember", "integrate"};
using StageTimes = std::array<double, stage_names.size()>;  // us

// What lies between two readings of the clock, one right after the other [us]; the median of many.
double clock_cost();

class StageClock : public engine::StageObserver {
  public:
    explicit StageClock(double cost) : cost_(cost) {}

    void begin();  // right before the rules are asked
    void rules_ended() { end(0); }
    void stage_ended(engine::Stage stage) override { end(1 + static_cast<std::size_t>(stage)); }

    const StageTimes& times() const { return times_; }  // the sum of all steps

  private:
    void end(std::size_t stage);

    double cost_;
    double last_ = 0.0;
    StageTimes times_{};
};

}  // namespace pushfactor::demos::reports::cost
