#include "demos/options/comparison.h"

#include "demos/base/platform/messages.h"
#include "demos/base/text/errors.h"
#include "demos/base/text/suggest.h"
#include "demos/options/simulation_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

namespace pushfactor::demos {

namespace {

// Options that may differ between panels; not "seconds", because they must show the same times, and not "threads",
// because results do not depend on it.
std::vector<std::string> comparable(const Choices& choices) {
    std::vector<std::string> names = simulation_option_names();
    std::erase_if(names, [](const std::string& name) { return name == "seconds" || name == "threads"; });
    for (const auto& [name, value] : choices.parameters) names.push_back(name);
    return names;
}

bool has_joints(const Choices& c) {
    return !c.description.distances.empty() || !c.description.joints.empty();
}

bool has_rows(const Choices& c) {
    return c.description.contacts || has_joints(c);
}

bool is_whole(const Choices& c) {
    return !is_rattle(c.settings.scheme);
}

// Whether a coefficient of contacts is above zero anywhere: that of all bodies where it is given.
bool any_surface(const Choices& c, const std::optional<double>& of_all, double BodyDescription::*of_body,
                 std::optional<double> MaterialPairDescription::*of_pair) {
    if (of_all) return *of_all > 0.0;
    const auto above = [](const auto& what) { return [what](const auto& of) { return of.*what > 0.0; }; };
    return std::ranges::any_of(c.description.bodies, above(of_body)) ||
           std::ranges::any_of(c.description.materials, above(of_pair));
}

bool is_zero(const Choices& c, const std::string& parameter) {
    return std::ranges::find(c.parameters, std::pair{parameter, std::string("0")}) != c.parameters.end();
}

struct Condition {
    std::vector<std::string> options;
    bool (*has_effect)(const Choices& choices);
    std::string_view where;  // completes "has no effect ..."
};

// The first one that does not hold is noted.
const std::array conditions{
    Condition{{"solver", "iterations", "tolerance", "warm-start", "small-steps"},
              has_rows,
              "without contacts, bars and joints"},
    Condition{{"push", "beta", "max-push-speed", "slop", "margin", "row-order", "manifold-points", "friction",
               "friction-model", "restitution", "restitution-model"},
              [](const Choices& c) { return c.description.contacts; },
              "without contacts"},
    Condition{{"distance-push", "distance-beta"}, has_joints, "without bars and joints"},
    Condition{{"distance-push", "distance-beta", "rest"}, is_whole, "in RATTLE steps"},
    Condition{{"beta", "max-push-speed"},
              [](const Choices& c) { return c.settings.contacts.kind != engine::PushKind::none; },
              "with --push none"},
    Condition{{"distance-beta"},
              [](const Choices& c) { return c.settings.distances.kind != engine::PushKind::none; },
              "with --distance-push none"},
    Condition{{"small-steps"},
              [](const Choices& c) { return takes_small_steps(c.settings); },
              "without --scheme small-steps, or --scheme auto with --solver auto and a --tolerance above 0"},
    Condition{{"scheme", "small-steps"},
              [](const Choices& c) {
                  return c.settings.scheme != Scheme::small_steps || has_joints(c) ||
                         c.settings.contacts.kind != engine::PushKind::persistent;
              },
              "with --push persistent, whose momentum small steps cannot give"},
    Condition{{"friction-model"},
              [](const Choices& c) {
                  return any_surface(c, c.settings.friction, &BodyDescription::friction,
                                     &MaterialPairDescription::friction);
              },
              "where all friction is 0"},
    Condition{{"restitution-model"},
              [](const Choices& c) {
                  return any_surface(c, c.settings.restitution, &BodyDescription::restitution,
                                     &MaterialPairDescription::restitution);
              },
              "where all restitution is 0"},
    Condition{{"seed"}, [](const Choices& c) { return !is_zero(c, "jitter"); }, "with --jitter 0"},
    Condition{{"poke-at"}, [](const Choices& c) { return !is_zero(c, "poke"); }, "with --poke 0"},
};

}  // namespace

void note_idle(const GivenOptions& given, std::span<const ComparedRun> runs) {
    const auto& comparison = runs.front().choices.frames.compare;
    std::set<std::string> noted;
    for (const Condition& condition : conditions) {
        for (const std::string& option : condition.options) {
            const auto* const typed = given.find(comparison && comparison->option == option ? "compare" : option);
            const auto has_effect = [&](const ComparedRun& run) { return condition.has_effect(run.choices); };
            if (!typed || !typed->is_typed() || std::ranges::any_of(runs, has_effect)) continue;
            if (!noted.insert(option).second) continue;
            note(fmt::format("{} {}: has no effect {}", typed->field, typed->text, condition.where));
        }
    }
}

std::vector<ComparedRun> compared_runs(const std::string& scene, const GivenOptions& given) {
    const Choices common = understand(scene, given);
    const auto& comparison = common.frames.compare;
    if (!comparison) return {{.label = "", .choices = common}};

    const std::vector<std::string> names = comparable(common);
    if (std::ranges::find(names, comparison->option) == names.end()) {
        const auto* chosen = given.find("compare");
        throw UsageError("{} {}: cannot compare {}; it {}", chosen->field, chosen->text, comparison->option,
                         one_of(comparison->option, names));
    }
    const auto* const single = given.find(comparison->option);
    if (single && single->is_typed()) {
        throw UsageError("{} {}: must be without --compare {}, which sets it in each panel", single->field,
                         single->text, comparison->option);
    }
    std::vector<ComparedRun> panels;
    for (const std::string& value : comparison->values) {
        GivenOptions own;
        own.add(comparison->option, value, fmt::format("--compare {}", comparison->option));
        own.add_all(given);
        panels.push_back({.label = comparison->option + " " + value, .choices = understand(scene, own)});
    }
    return panels;
}

}  // namespace pushfactor::demos
