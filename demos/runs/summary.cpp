#include "demos/runs/summary.h"

#include "demos/options/named_run.h"
#include "demos/options/simulation_options.h"
#include "demos/runs/session.h"
#include "demos/text/json.h"
#include "engine/bodies/diagnostics.h"

#include <fmt/format.h>

#include <numeric>

namespace pushfactor::demos {

namespace {

Json number_or_null(const std::optional<double>& value) {
    return value ? Json(*value) : Json(nullptr);
}

Json options_of(const Choices& choices) {
    Json options = Json::object();
    for (const SimulationOption& option : simulation_options()) {
        const std::string text = option.get(choices.settings);
        if (!text.empty()) options[std::string(option.name)] = json_of(text);
    }
    for (const auto& [name, text] : choices.parameters) options[name] = json_of(text);
    return options;
}

Json substeps_of(const SubstepCount& count) {
    Json json;
    json["mean"] = count.mean();
    json["largest"] = count.largest;
    json["steps_divided_by_rule"] = Json::object();
    for (const auto& [rule, steps] : count.steps_by_rule) json["steps_divided_by_rule"][std::string(rule)] = steps;
    json["steps_that_asked_for_more_than_there_may_be"] = count.short_steps;
    return json;
}

Json islands_of(const IslandCount& count) {
    return {{"kept", count.kept},
            {"swept", count.swept},
            {"exact", count.exact},
            {"in_small_steps", count.in_small_steps}};
}

Json impacts_of(const ImpactCount& count) {
    return {{"all", count.all},
            {"largest_in_a_step", count.largest},
            {"steps_with_more_than_are_followed", count.short_steps}};
}

Json at_rest_of(const AtRest& at_rest) {
    return {{"bodies", at_rest.bodies}, {"all_since_s", number_or_null(at_rest.since)}};
}

double mean(const std::vector<double>& values) {
    return values.empty() ? 0.0
                          : std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

Json measured_of(const MeasuredSum& sum) {
    const auto count = static_cast<double>(std::max(sum.count, 1L));
    return {{"compared", sum.count},
            {"distance_m_mean", sum.distance / count},
            {"distance_m_largest", sum.largest_distance},
            {"angle_deg_mean", sum.angle / count},
            {"angle_deg_largest", sum.largest_angle}};
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

std::string summary_text(const Choices& choices, const Simulation& simulation, const Measurements& measured) {
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
    summary["islands"] = islands_of(measured.islands());
    if (scene.world.impacts) summary["impacts"] = impacts_of(measured.impacts());
    if (choices.settings.rest) summary["at_rest"] = at_rest_of(measured.at_rest());
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
    return json_text(summary);
}

}  // namespace pushfactor::demos
