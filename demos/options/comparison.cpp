#include "demos/options/comparison.h"

#include "demos/options/simulation_options.h"
#include "demos/text/errors.h"
#include "demos/text/suggest.h"

#include <fmt/format.h>

#include <algorithm>

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

}  // namespace

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
