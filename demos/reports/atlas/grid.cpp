// Maps that people ask for.
#include "demos/options/simulation_options.h"
#include "demos/reports/atlas/atlas.h"
#include "demos/runs/summary.h"
#include "demos/text/errors.h"
#include "demos/text/numbers.h"
#include "demos/text/rational.h"
#include "demos/text/suggest.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace pushfactor::demos::reports::atlas {

namespace {

constexpr std::size_t most_values = 10000;  // of an axis
constexpr const char* forms = "must be OPTION=FROM:TO:STEP, OPTION=log:FROM:TO:COUNT or OPTION=A,B,C";

[[noreturn]] void refuse(const std::string& field, const std::string& text, const std::string& why) {
    throw UsageError(fmt::format("{} {}: {}", field, text, why));
}

std::pair<std::string, std::string> name_and_value(const std::string& field, const std::string& text,
                                                   const std::string& allowed) {
    const auto equals = text.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == text.size()) refuse(field, text, allowed);
    return {text.substr(0, equals), text.substr(equals + 1)};
}

// Exact: 0.1, 0.2, 0.3 and not 0.30000000000000004.
std::vector<std::string> equal_steps(const std::string& field, const std::string& text,
                                     const std::vector<std::string_view>& words) {
    const auto from = parse_rational(words[0]), to = parse_rational(words[1]), step = parse_rational(words[2]);
    if (!from || !to || !step) refuse(field, text, forms);
    const double count = std::floor((to->value() - from->value()) / step->value() + 1e-9) + 1.0;
    if (step->value() == 0.0 || !(count >= 2.0) || count > static_cast<double>(most_values)) {
        refuse(field, text, fmt::format("must have 2 to {} values from FROM to TO", most_values));
    }
    std::vector<std::string> values;
    for (std::int64_t i = 0; i < static_cast<std::int64_t>(count); ++i) {
        try {
            values.push_back(to_text(*from + *step * Rational{i, 1}));
        } catch (const std::overflow_error& error) {
            refuse(field, text, error.what());
        }
    }
    return values;
}

// `whole`: rounded to whole numbers, without repetitions.
std::vector<std::string> equal_factors(const std::string& field, const std::string& text,
                                       const std::vector<std::string_view>& words, bool whole) {
    const auto from = parse_number(words[1]), to = parse_number(words[2]);
    const auto count = parse_integer(words[3]);
    if (!from || !to || !count) refuse(field, text, forms);
    if (*from <= 0.0 || *to <= *from || *count < 2 || *count > static_cast<int>(most_values)) {
        refuse(field, text, fmt::format("must be 0 < FROM < TO and COUNT from 2 to {}", most_values));
    }
    std::vector<std::string> values;
    for (int i = 0; i < *count; ++i) {
        const double value = *from * std::pow(*to / *from, static_cast<double>(i) / (*count - 1));
        // Four digits, which a reader can repeat.
        std::string next =
            whole ? fmt::format("{:.0f}", value) : to_text(*parse_number(fmt::format("{:.4g}", value)));
        if (values.empty() || values.back() != next) values.push_back(std::move(next));
    }
    return values;
}

void require_option(const Choices& choices, const std::string& field, const std::string& text,
                    const std::string& name) {
    std::vector<std::string> known = simulation_option_names();
    for (const auto& [parameter, value] : choices.parameters) known.push_back(parameter);
    if (std::ranges::find(known, name) == known.end()) refuse(field, text, name + " " + one_of(name, known));
}

// Of two values for one option, one would be ignored.
void require_unset(const OptionTexts& set, const std::string& field, const std::string& text,
                   const std::string& name) {
    const auto found = std::ranges::find(set, name, [](const auto& option) { return option.first; });
    if (found != set.end()) refuse(field, text, fmt::format("must be without --set {}={}", name, found->second));
}

// Throws UsageError for a value that no run accepts.
void require_accepted(const GridRequest& request, OptionTexts options, const std::string& name,
                      const std::string& value) {
    options.emplace_back(name, value);
    run_of(request.scene, options);
}

bool accepts(const GridRequest& request, const OptionTexts& set, const std::string& name,
             const std::string& value) {
    try {
        require_accepted(request, set, name, value);
        return true;
    } catch (const UsageError&) {
        return false;
    }
}

AtlasAxis axis_of(const GridRequest& request, const OptionTexts& set, const std::string& field,
                  const std::string& text) {
    const auto [name, value] = name_and_value(field, text, forms);
    require_option(run_of(request.scene, set), field, text, name);
    require_unset(set, field, text, name);
    AtlasAxis axis{.option = name, .label = name, .values = {}, .scale = 1.0, .logarithmic = false};
    const std::vector<std::string_view> words = parts_of(value, ':');
    if (words.size() == 4 && words[0] == "log") {
        axis.logarithmic = true;
        axis.values = equal_factors(field, text, words, false);
        // Of counts and the like, which must be whole.
        if (axis.values.size() > 2 && !accepts(request, set, name, axis.values[1]))
            axis.values = equal_factors(field, text, words, true);
    } else if (words.size() == 3) {
        axis.values = equal_steps(field, text, words);
    } else if (words.size() == 1) {
        for (const std::string_view part : parts_of(value)) axis.values.emplace_back(part);
        axis.names = !std::ranges::all_of(axis.values,
                                          [](const std::string& one) { return parse_rational(one).has_value(); });
    } else {
        refuse(field, text, forms);
    }
    if (!axis.names) {
        std::ranges::stable_sort(axis.values, {}, [&](const std::string& one) { return axis.shown(one); });
    }
    const auto same = [&](const auto& a, const auto& b) { return axis.shown(a) == axis.shown(b); };
    if (axis.values.size() < 2 || std::ranges::adjacent_find(axis.values, same) != axis.values.end()) {
        refuse(field, text, "must have at least two values, and none twice");
    }
    if (words.size() == 1) axis.names = true;  // a list has equal cells, whatever its numbers are
    for (const std::string& one : axis.values) require_accepted(request, set, name, one);
    return axis;
}

OptionTexts options_of(const GridRequest& request) {
    OptionTexts options;
    for (const std::string& text : request.set) {
        const auto [name, value] = name_and_value("--set", text, "must be OPTION=VALUE");
        require_option(run_of(request.scene, {}), "--set", text, name);
        require_unset(options, "--set", text, name);
        options.emplace_back(name, value);
    }
    return options;
}

// A number of the summary; those that are not known at the start are null there.
void require_measure(const GridRequest& request, const OptionTexts& options) {
    const Choices choices = run_of(request.scene, options);
    const Simulation start(choices);
    const Json summary = parse_json(summary_text(choices, start, Measurements(start)));
    std::vector<std::string> numbers;
    for (const auto& [name, value] : summary.items()) {
        if (value.is_number() || value.is_null()) numbers.push_back(name);
    }
    require_known("--measure", request.measure, numbers);
}

}  // namespace

AtlasMap grid_map(const GridRequest& request) {
    const OptionTexts options = options_of(request);
    AtlasMap map{.name = "grid",
                 .title = {},
                 .caption = {},
                 .scene = request.scene,
                 .common = options,
                 .x = axis_of(request, options, "--x", request.x),
                 .y = axis_of(request, options, "--y", request.y),
                 .measure = {.key = request.measure, .words = request.measure}};
    if (map.x.option == map.y.option) {
        refuse("--y", request.y, "must be another option than that of --x");
    }
    require_measure(request, options);
    map.title =
        fmt::format("{}: {} and {}", run_of(request.scene, options).description.name, map.x.option, map.y.option);
    map.caption = fmt::format("{} runs.", map.x.values.size() * map.y.values.size());
    return map;
}

std::vector<AtlasCell> cells_with_replay(const AtlasMap& map, const GridRequest& request) {
    std::vector<AtlasCell> chosen;
    for (const std::string& text : request.replays) {
        if (text == "all") return cells_of(map);
        const auto parts = parts_of(text, ':');
        const auto has = [](const AtlasAxis& axis, std::string_view value) {
            return std::ranges::find(axis.values, value) != axis.values.end();
        };
        if (parts.size() != 2 || !has(map.x, parts[0]) || !has(map.y, parts[1])) {
            refuse("--replays", text, "must be all, or X:Y with a value of each axis as its table has it");
        }
        chosen.push_back(cell_at(map, std::string(parts[0]), std::string(parts[1])));
    }
    return chosen;
}

}  // namespace pushfactor::demos::reports::atlas
