#include "demos/runs/summary.h"

#include "demos/options/named_run.h"
#include "demos/options/simulation_options.h"
#include "demos/runs/session.h"
#include "engine/bodies/diagnostics.h"
#include "engine/constraints/contact_constraints.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace pushfactor::demos {

namespace {

Json number_or_null(const std::optional<double>& value) {
    return value ? Json(*value) : Json(nullptr);
}

Json options_of(const Choices& choices) {
    Json options = Json::object();
    for (const auto& [name, text] : texts_of(choices.settings)) options[name] = json_of(text);
    for (const auto& [name, text] : choices.parameters) options[name] = json_of(text);
    return options;
}

Json substeps_of(const SubstepCount& count) {
    Json by_rule = Json::object();
    for (const auto& [rule, steps] : count.steps_by_rule) by_rule[std::string(rule)] = steps;
    return {{"mean", count.mean()},
            {"largest", count.largest},
            {"steps_divided_by_rule", by_rule},
            {"steps_that_asked_for_more_than_there_may_be", count.short_steps}};
}

double mean(const std::vector<double>& values) {
    return values.empty() ? 0.0
                          : std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

Json measured_of(const MeasuredSum& sum) {
    const auto count = static_cast<double>(sum.count);
    const auto of_some = [&](double value) { return sum.count > 0 ? Json(value) : Json(nullptr); };
    return {{"compared", sum.count},
            {"distance_m_mean", of_some(sum.distance / count)},
            {"distance_m_largest", of_some(sum.largest_distance)},
            {"angle_deg_mean", of_some(sum.angle / count)},
            {"angle_deg_largest", of_some(sum.largest_angle)}};
}

}  // namespace

bool gives_listed_bits() {
    static const bool gives = [] {
        Simulation simulation(run_of("intersecting-stack", {{"preset", "paper"}, {"seconds", "1"}}));
        play(simulation, before_end);
        return engine::state_hash(simulation.scene().world.bodies) == touchstone;
    }();
    return gives;
}

Json summary_of(const Choices& choices, const Simulation& simulation, const Measurements& measured) {
    const BuiltScene& scene = simulation.scene();
    Json summary;
    summary["scene"] = scene.name;
    summary["preset"] = choices.settings.preset;
    summary["options"] = options_of(choices);
    summary["steps"] = simulation.sample().step;
    summary["simulated_seconds"] = simulation.sample().time;
    summary["bodies"] = scene.world.bodies.size();
    summary["state_hash"] = fmt::format("{:016x}", engine::state_hash(scene.world.bodies));
    summary["bits_as_listed"] = gives_listed_bits();
    summary["outcome"] = name_of(measured.outcome());
    summary["max_penetration_m"] = measured.max_penetration();
    summary["max_length_error_m"] = measured.max_length_error();
    summary["max_speed_m_per_s_last_second"] = measured.max_speed_last_second();
    summary["max_kinetic_energy_j_last_second"] = measured.max_kinetic_energy_last_second();
    summary["max_upward_speed_m_per_s"] = measured.max_upward_speed();
    summary["residual_m_per_s_median"] = measured.median_residual();
    const UnsolvedSteps& unsolved = measured.unsolved();
    summary["residual_m_per_s_worst"] = unsolved.worst_residual;
    summary["unsolved_steps"] = unsolved.count;
    summary["first_unsolved_step"] = unsolved.first ? Json(unsolved.first->step) : Json(nullptr);
    summary["contradicting_steps"] = unsolved.contradicting;
    const auto& [kept, swept, exact, in_small_steps] = measured.islands();
    summary["islands"] = {{"kept", kept}, {"swept", swept}, {"exact", exact}, {"in_small_steps", in_small_steps}};
    if (scene.world.impacts) {
        const auto& [all, largest, short_steps] = measured.impacts();
        summary["impacts"] = {
            {"all", all}, {"largest_in_a_step", largest}, {"steps_with_more_than_are_followed", short_steps}};
    }
    if (choices.settings.rest) {
        const auto& [bodies, since] = measured.at_rest();
        summary["at_rest"] = {{"bodies", bodies}, {"all_since_s", number_or_null(since)}};
    }
    summary["energy_initial_j"] = measured.initial_energy();
    summary["energy_final_j"] = measured.final_energy();
    summary["energy_gain_j"] = measured.energy_gain();
    summary["max_off_axis_m"] = measured.max_off_axis();
    summary["drift_after_10_s_m"] = number_or_null(measured.drift_after_10_s());
    summary["lean_time_s"] = number_or_null(measured.lean_time());
    summary["fall_time_s"] = number_or_null(measured.fall_time());
    if (!measured.cpu_us().empty()) {
        summary["cpu_us_per_step_median"] = median(measured.cpu_us());
        summary["cpu_us_per_step_mean"] = mean(measured.cpu_us());
    }
    if (!choices.settings.substeps) summary["substeps"] = substeps_of(measured.substeps());
    if (measured.measured()) summary["measured"] = measured_of(*measured.measured());
    for (const auto& [name, value] : measured.of_scene()) summary[name] = number_or_null(value);
    if (scene.standing) summary["heights_m"] = measured.heights();
    return summary;
}

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
        if (!exact) options.emplace_back("--solver auto");
        if (exact && !takes_small_steps(settings))
            options.push_back(fmt::format("--iterations above {}", settings.iterations));
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
    if (measured.measured() && measured.measured()->count == 0) {
        text += fmt::format(
            "pushfactor: warning: {}: nothing was compared with the measured poses: no step is within their time\n",
            name);
    }
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
