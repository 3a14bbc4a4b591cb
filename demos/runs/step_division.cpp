#include "demos/runs/step_division.h"

#include "engine/measures/step_length.h"

#include <algorithm>
#include <cmath>

namespace pushfactor::demos {

namespace {

// Factor by which a rule may be exceeded before the rest of a step is divided again: all rules have a safety
// margin, and a step of unequal parts is less accurate than one of equal parts.
constexpr double refine_beyond = 1.6;

constexpr double most_rise = 2.0;
constexpr double most_fall = 15.0 / 16.0;

// Rounded up, but rounding errors do not add a part.
int whole(double parts) {
    return static_cast<int>(std::ceil(parts * (1.0 - 1e-9)));
}

}  // namespace

std::vector<StepRule> step_rules(const BuiltScene& scene) {
    using engine::World;
    std::vector<StepRule> rules;
    if (const auto* distances = scene.distances) {
        rules.push_back(
            {"tension", [distances](const World& w) { return tension_rate(*distances, w.bodies); }, false});
        rules.push_back(
            {"turning", [distances](const World& w) { return turning_rate(*distances, w.bodies); }, true});
    }
    if (const auto* joints = scene.joints) {
        rules.push_back({"tension", [joints](const World& w) { return tension_rate(*joints, w.bodies); }, false});
        rules.push_back({"turning", [joints](const World& w) { return turning_rate(*joints, w.bodies); }, true});
    }
    const auto& bodies = scene.world.bodies;
    if (std::any_of(bodies.begin(), bodies.end(), engine::is_slender)) {
        rules.push_back({"spin", [](const World& w) { return engine::spin_rate(w.bodies); }, true});
    }
    if (scene.contacts && !scene.gravity.isZero(0.0)) {
        const double rate = engine::size_rate(scene.contacts->colliders(), bodies, scene.gravity);
        rules.push_back({"size", [rate](const World&) { return rate; }, false});
    }
    return rules;
}

int StepDivision::divide(const engine::World& world, double dt) {
    short_ = false;
    if (rules_.empty()) return std::max(whole(level_), 1);
    double wanted = 1.0;
    std::string_view rule;
    for (const StepRule& asked : rules_) {
        const double parts = asked.rate(world) * dt;
        if (!(parts > wanted)) continue;
        wanted = parts;
        rule = asked.name;
    }
    short_ = wanted > most_parts;
    wanted = std::min(wanted, double{most_parts});
    if (wanted >= most_fall * level_) rule_ = rule;
    level_ = level_ > 0.0 ? std::clamp(wanted, std::max(most_fall * level_, 1.0), most_rise * level_) : wanted;
    const int parts = whole(level_);
    if (parts == 1) rule_ = {};
    return parts;
}

int StepDivision::refine(const engine::World& world, double dt, int parts) {
    for (const StepRule& asked : rules_) {
        if (!asked.within_step || !(asked.rate(world) * dt > refine_beyond * parts)) continue;
        if (2 * parts > most_parts) {
            short_ = true;
            break;
        }
        rule_ = asked.name;
        level_ = 2.0 * parts;
        return 2;
    }
    return 1;
}

}  // namespace pushfactor::demos
