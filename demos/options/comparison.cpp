#include "demos/options/comparison.h"

#include "demos/options/simulation_options.h"
#include "demos/platform/messages.h"
#include "demos/text/errors.h"
#include "demos/text/suggest.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

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

struct Condition {
    std::string_view option;
    bool (*has_effect)(const Settings& settings);
    std::string_view where;  // completes "has no effect ..."
};

constexpr std::array conditions{
    Condition{"beta", [](const Settings& s) { return s.contacts.kind != engine::PushKind::none; },
              "with --push none"},
    Condition{"max-push-speed", [](const Settings& s) { return s.contacts.kind != engine::PushKind::none; },
              "with --push none"},
    Condition{"distance-push", [](const Settings& s) { return !is_rattle(s.scheme); }, "in RATTLE steps"},
    Condition{"distance-beta",
              [](const Settings& s) { return s.distances.kind != engine::PushKind::none && !is_rattle(s.scheme); },
              "with --distance-push none and in RATTLE steps"},
    Condition{"small-steps",
              [](const Settings& s) {
                  return s.scheme == Scheme::small_steps || (s.scheme == Scheme::automatic && s.solver == "auto");
              },
              "without --scheme small-steps, or --scheme auto with --solver auto"},
    Condition{"friction-model", [](const Settings& s) { return s.friction != 0.0; }, "with --friction 0"},
};

}  // namespace

void note_idle(const GivenOptions& given, std::span<const ComparedRun> runs) {
    const auto& comparison = runs.front().choices.frames.compare;
    for (const Condition& condition : conditions) {
        const bool compared = comparison && comparison->option == condition.option;
        const auto* const typed = given.find(compared ? "compare" : condition.option);
        if (!typed || !typed->is_typed()) continue;
        const auto has_effect = [&](const ComparedRun& run) { return condition.has_effect(run.choices.settings); };
        if (std::ranges::any_of(runs, has_effect)) continue;
        note(fmt::format("{} {}: has no effect {}", typed->field, typed->text, condition.where));
    }
}

std::vector<ComparedRun> compared_runs(const std::string& scene, const GivenOptions& given) {
    const Choices common = understand(scene, given);
    const auto& comparison = common.frames.compare;
    if (!comparison) return {{.label = "", .choices = common}};

    const std::vector<std::string> names = comparable(common);
    if (std::find(names.begin(), names.end(), comparison->option) == names.end()) {
        const auto* chosen = given.find("compare");
        throw UsageError(fmt::format("{} {}: cannot compare {}; it {}", chosen->field, chosen->text,
                                     comparison->option, one_of(comparison->option, names)));
    }
    const auto* const single = given.find(comparison->option);
    if (single && single->is_typed()) {
        throw UsageError(fmt::format("{} {}: must be without --compare {}, which sets it in each panel",
                                     single->field, single->text, comparison->option));
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
