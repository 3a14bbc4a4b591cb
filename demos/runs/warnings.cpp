#include "demos/runs/warnings.h"

#include "engine/constraints/contact_constraints.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace pushfactor::demos {

namespace {

// "step 33 (0.55 s)"
std::string text_of(const UnsolvedSteps::Place& place) {
    return fmt::format("step {} ({:.4g} s)", place.step, place.time);
}

// ", between 'a' and 'b'"
std::string bodies_of(const UnsolvedSteps::Place& place, const BuiltScene& scene) {
    if (!place.bodies) return "";
    return fmt::format(", between '{}' and '{}'", body_name(scene, place.bodies->a),
                       body_name(scene, place.bodies->b));
}

// Steps per period below which a sinusoid is no longer one.
constexpr double few_steps = 12.0;

// Of the first body that is shaken too fast for the steps.
std::string shaken_too_fast(const std::string& name, const Simulation& simulation) {
    for (const BodyDescription& body : simulation.scene().bodies) {
        const auto* shaking = body.motion ? std::get_if<ShakingMotion>(&body.motion->kind) : nullptr;
        if (!shaking) continue;
        const double steps =
            simulation.settings().substeps.value_or(1) / (shaking->frequency * simulation.settings().dt.value());
        if (steps >= few_steps) continue;
        return fmt::format(
            "pushfactor: warning: {}: '{}' is shaken at {} Hz, {:.3g} steps per period; try --dt below {:.2g}\n",
            name, body.name, shaking->frequency, steps, 1.0 / (few_steps * shaking->frequency));
    }
    return "";
}

// Limits for warnings: the swing of a chain with too long steps visibly grows at 2 %, and its bars are visibly
// wrong at 10 %. The residual is relative to the largest speed.
constexpr double much_gain = 0.02;
constexpr double much_stretch = 0.1;
constexpr double much_residual = 1e-2;

// Whether what was not solved moves something in a step by more than the overlap that is not corrected either:
// without a slop, everything is seen.
bool is_seen(const UnsolvedSteps& steps, const Simulation& simulation) {
    double smallest = engine::infinity;  // m
    if (const engine::ContactConstraints* const contacts = simulation.scene().contacts) {
        for (const engine::collision::Collider& collider : contacts->colliders()) {
            smallest = std::min(smallest, engine::collision::size_of(collider.shape));
        }
    }
    const Settings& settings = simulation.settings();
    const double allowed = smallest < engine::infinity ? settings.slop * smallest : 0.0;
    return steps.worst_unsolved * settings.dt.value() > allowed;
}

// The option to try: another push if wrong initial lengths turn into lasting speed; else better solves, shorter
// steps, or both.
std::string remedy(const Simulation& simulation, const Measurements& measured) {
    const Settings& settings = simulation.settings();
    const bool persists = settings.distances.kind == engine::PushKind::persistent;
    if (persists && measured.start_stretch() > much_stretch) return "--distance-push curve";
    std::vector<std::string> options;
    if (settings.substeps && (simulation.scene().distances || simulation.scene().joints))
        options.emplace_back("--substeps auto");
    if (measured.unsolved().worst_residual > much_residual * measured.max_speed()) {
        const bool exact = settings.solver == "auto" || settings.solver == "direct";
        options.push_back(exact ? fmt::format("--iterations above {}", settings.iterations) : "--solver auto");
    }
    if (options.empty()) options.push_back("--dt below " + to_text(settings.dt));
    return fmt::format("{}", fmt::join(options, " with "));
}

// "bars were wrong by up to 50 % of their length"
std::vector<std::string> faults_of(const Measurements& measured) {
    std::vector<std::string> faults;
    if (measured.energy_gain() > much_gain * measured.motion_energy()) {
        faults.push_back(
            fmt::format("energy grew by {:.3g} J without a source (the largest kinetic energy is {:.3g} J)",
                        measured.energy_gain(), measured.motion_energy()));
    }
    const bool given = measured.max_stretch() <= 1.01 * measured.start_stretch();
    if (measured.max_stretch() > much_stretch && !given && !measured.unsolved().first_contradicting) {
        faults.push_back(
            fmt::format("bars were wrong by up to {:.3g} % of their length", 100.0 * measured.max_stretch()));
    }
    return faults;
}

}  // namespace

std::string warning_text(const std::string& name, const Simulation& simulation, const Measurements& measured) {
    const UnsolvedSteps& steps = measured.unsolved();
    const BuiltScene& scene = simulation.scene();
    std::string text = shaken_too_fast(name, simulation);
    if (steps.first && is_seen(steps, simulation)) {
        text += fmt::format("pushfactor: warning: {}: {} of {} steps {} not solved to {} m/s, the first is {}",
                            name, steps.count, steps.of, steps.count == 1 ? "is" : "are",
                            scene.world.termination.tolerance_high, text_of(*steps.first));
        if (steps.worst) {
            text += fmt::format("; the worst residual is {:.2g} m/s in {}{}", steps.worst_unsolved,
                                text_of(*steps.worst), bodies_of(*steps.worst, scene));
        }
        text += "\n";
    }
    if (steps.first_contradicting) {
        text +=
            fmt::format("pushfactor: warning: {}: rows contradict each other in {} of {} steps, first in {}{}\n",
                        name, steps.contradicting, steps.of, text_of(*steps.first_contradicting),
                        bodies_of(*steps.first_contradicting, scene));
    }
    if (const auto faults = faults_of(measured); !faults.empty()) {
        text += fmt::format("pushfactor: warning: {}: {}; try {}\n", name, fmt::join(faults, ", and "),
                            remedy(simulation, measured));
    }
    return text;
}

}  // namespace pushfactor::demos
