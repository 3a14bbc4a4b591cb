#include "demos/runs/warnings.h"

#include <fmt/format.h>

namespace pushfactor::demos {

namespace {

// "step 33 (0.55 s)"
std::string text_of(const UnsolvedSteps::Place& place) {
    return fmt::format("step {} ({:.4g} s)", place.step, place.time);
}

// ", between 'a' and 'b'"
std::string bodies_of(const UnsolvedSteps::Place& place, const Scene& scene) {
    if (!place.bodies) return "";
    return fmt::format(", between '{}' and '{}'", body_name(scene, place.bodies->a),
                       body_name(scene, place.bodies->b));
}

}  // namespace

std::string warning_text(const std::string& name, const Simulation& simulation, const Measurements& measured) {
    const UnsolvedSteps& steps = measured.unsolved();
    const Scene& scene = simulation.scene();
    std::string text;
    if (steps.first) {
        text += fmt::format("pushfactor: warning: {}: {} of {} steps {} not solved to {} m/s, the first is {}",
                            name, steps.count, steps.of, steps.count == 1 ? "is" : "are",
                            scene.world.termination.tolerance_high, text_of(*steps.first));
        if (steps.worst) {
            text += fmt::format("; the worst residual is {:.2g} m/s in {}{}", steps.worst_residual,
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
    return text;
}

}  // namespace pushfactor::demos
