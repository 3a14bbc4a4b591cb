// Into how many engine steps a step of the run is divided: always the same number, or as many as the state asks for
// (engine/measures/step_length.h).
#pragma once

#include "demos/runs/scene.h"

#include <functional>
#include <string_view>
#include <vector>

namespace pushfactor::demos {

struct StepRule {
    std::string_view name;
    std::function<double(const engine::World&)> rate;  // 1/s; a step of dt follows the state while rate dt <= 1

    // Whether it may also divide what is left of a step. Not where it looks at forces: they hold the correction of
    // the last part too, which is the greater the shorter the part, and dividing would call for dividing again.
    bool within_step = false;
};

// The rules for the parts that the scene has. They look at parts of its world, which must outlive them.
std::vector<StepRule> step_rules(const BuiltScene& scene);

class StepDivision {
  public:
    // That rules can get: no scene that makes sense asks for more, and a run shall not come to a halt.
    static constexpr int most_parts = 1000;

    // Always `parts`, 1 or more.
    explicit StepDivision(int parts) : level_(parts) {}

    // What the rules ask for, 1 where they ask for nothing. From step to step it at most doubles, because a single
    // large force may be the end of a motion, and falls by no more than a sixteenth: a length error that was small
    // for a long step is corrected all the faster in a short one, so that every change of length costs energy.
    // `level`: that of the step before, for a run that goes on; 0 for one that begins.
    explicit StepDivision(std::vector<StepRule> rules, double level = 0.0)
        : rules_(std::move(rules)), level_(level) {}

    // Parts of the step of dt [s] that comes now.
    int divide(const engine::World& world, double dt);

    // Into how many each of the `parts` of the step of dt that are left is to be divided further: 2 when the state
    // has come to ask for much shorter ones meanwhile, 1 otherwise.
    int refine(const engine::World& world, double dt, int parts);

    double level() const { return level_; }          // parts of the last step at its finest, before rounding up
    std::string_view rule() const { return rule_; }  // that asked for them; empty when none did
    bool is_short() const { return short_; }         // whether it asked for more than most_parts

  private:
    std::vector<StepRule> rules_;
    double level_;
    std::string_view rule_;
    bool short_ = false;
};

}  // namespace pushfactor::demos
