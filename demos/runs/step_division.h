// Division of a step of the run into engine steps: a fixed number, or as many as the state needs
// (engine/measures/step_length.h) and the result shows. A step whose result needs much more is taken again.
#pragma once

#include "demos/runs/scene.h"

#include <functional>
#include <string_view>
#include <vector>

namespace pushfactor::demos {

struct StepRule {
    std::string_view name;
    std::function<double(const engine::World&)> rate;  // 1/s; a step of dt follows the state while rate dt <= 1

    // Whether the rate depends on forces. For such a rule no step is taken again: its forces include the
    // correction of the last part, which is larger for shorter parts, so that dividing would require dividing
    // again. The force of an impact grows as 1 / dt and the rate with its root, which ends; only where contacts and
    // joints contradict each other does it grow with the number of parts (LIMITS).
    bool by_forces = false;
};

// The rules for the parts of the scene. They refer to parts of its world, which must outlive them.
std::vector<StepRule> step_rules(const BuiltScene& scene);

class StepDivision {
  public:
    // Maximum for rules: no reasonable scene needs more, and it bounds the time per step.
    static constexpr int most_parts = 1000;

    // Always `parts`, 1 or more.
    explicit StepDivision(int parts) : is_fixed_(true), level_(parts) {}

    // As many parts as the rules require, at least 1. From step to step the number falls by no more than a
    // sixteenth: every change of step length leaves an error of second order.
    // `before`: level() of the previous step for a resumed run, else 0.
    explicit StepDivision(std::vector<StepRule> rules, double before = 0.0)
        : rules_(std::move(rules)), level_(before) {}

    // Number of parts of the last step; 1 before the first.
    int parts() const;
    // For the next step of dt [s].
    int divide(const engine::World& world, double dt);

    // After a part of the step of dt. Returns false if this state needs much shorter parts: parts() of them, in
    // which the step has to be taken again.
    bool suffices(const engine::World& world, double dt);
    // The same after all parts, if some pair of bodies has got deeper by this share of its size.
    bool suffices_for(double deepening);

    bool is_fixed() const { return is_fixed_; }
    bool has_rules() const { return !rules_.empty(); }
    double level() const { return level_; }          // parts of the last step at its finest, before rounding up
    std::string_view rule() const { return rule_; }  // that required them; empty if none did
    bool is_short() const { return short_; }         // whether it required more than most_parts

  private:
    bool is_fixed_ = false;
    std::vector<StepRule> rules_;
    double level_ = 0.0;
    std::string_view rule_;
    bool short_ = false;
};

// That of a run of the scene, which may be a resumed one.
StepDivision division_of(const BuiltScene& scene, const Settings& settings);

}  // namespace pushfactor::demos
