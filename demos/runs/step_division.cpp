#include "demos/runs/step_division.h"

#include "engine/measures/step_length.h"

#include <algorithm>
#include <cmath>

namespace pushfactor::demos {

namespace {

// Factor by which a rule may be exceeded before a step is taken again: all rules have a safety margin.
constexpr double most_excess = 1.6;

// Bodies that an impact turns far within a step end deep in what they meet: contacts are those of one place. A step
// is taken again in twice as many parts where a pair gets deeper by this share of its size, while there are fewer
// than `most_for_depth`: what is pressed together by more than it can bear gets deeper in any number.
constexpr double most_deepening = 0.02;
constexpr int most_for_depth = 8;

constexpr double most_fall = 15.0 / 16.0;

// Rounded up, but rounding errors do not add a part.
int whole(double parts) {
    return static_cast<int>(std::ceil(parts * (1.0 - 1e-9)));
}

}  // namespace

std::vector<StepRule> step_rules(const BuiltScene& scene) {
    using engine::World;
    std::vector<StepRule> rules;
    const auto add = [&rules](const auto* held) {
        if (!held) return;
        rules.push_back({"tension", [held](const World& w) { return tension_rate(*held, w.bodies); }, true});
        rules.push_back({"turning", [held](const World& w) { return turning_rate(*held, w.bodies); }, false});
    };
    add(scene.distances);
    add(scene.joints);
    return rules;
}

StepDivision division_of(const BuiltScene& scene, const Settings& settings) {
    if (settings.substeps) return StepDivision(*settings.substeps);
    return StepDivision(step_rules(scene), scene.parts_before.value_or(0.0));
}

int StepDivision::parts() const {
    return std::max(whole(level_), 1);
}

int StepDivision::divide(const engine::World& world, double dt) {
    short_ = false;
    if (is_fixed_) return this->parts();
    double wanted = 1.0;
    std::string_view rule;
    for (const StepRule& asked : rules_) {
        const double parts = dt * asked.rate(world);
        if (!(parts > wanted)) continue;
        wanted = parts;
        rule = asked.name;
    }
    short_ = wanted > most_parts;
    wanted = std::min(wanted, double{most_parts});
    if (wanted >= most_fall * level_) rule_ = rule;
    level_ = std::max(wanted, most_fall * level_);
    const int parts = whole(level_);
    if (parts == 1) rule_ = {};
    return parts;
}

bool StepDivision::suffices(const engine::World& world, double dt) {
    bool enough = true;
    for (const StepRule& asked : rules_) {
        if (asked.by_forces) continue;
        const double wanted = dt * asked.rate(world);
        if (!(wanted > most_excess * parts())) continue;
        short_ = short_ || wanted > most_parts;
        if (parts() == most_parts) continue;
        rule_ = asked.name;
        level_ = std::min(wanted, double{most_parts});
        enough = false;
    }
    return enough;
}

bool StepDivision::suffices_for(double deepening) {
    if (is_fixed_ || !(deepening > most_deepening) || parts() >= most_for_depth) return true;
    rule_ = "depth";
    level_ = std::min(2 * parts(), most_for_depth);
    return false;
}

}  // namespace pushfactor::demos
