// The list of maps and their axes, and maps that people ask for.
#include "demos/base/text/numbers.h"
#include "demos/base/text/rational.h"
#include "demos/base/text/suggest.h"
#include "demos/options/simulation_options.h"
#include "demos/reports/atlas/atlas.h"
#include "demos/runs/summary.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace pushfactor::demos::reports::atlas {

namespace {

using Values = std::vector<std::string>;

constexpr double gravity = 10.0;  // m/s^2, of all scenes here

const AtlasMeasure off_axis{"max_off_axis_m", "farthest sideways from the start [m]"};
const AtlasMeasure upward{"max_upward_speed_m_per_s", "largest upward velocity [m/s]"};
const AtlasMeasure length_error{"max_length_error_m", "largest length error of a bar [m]"};

const AtlasAxis mass_ratios{"mass-ratio",
                            "mass ratio R, upper cube over lower",
                            {"1", "2", "5", "10", "20", "50", "100", "200", "500", "1000", "2000", "5000"}};
const AtlasAxis heights{"count", "cubes in the tower", {"2", "3", "4", "5", "7", "10", "14", "20", "28", "40"}};
const AtlasAxis overlaps{"gap",
                         "overlap of neighbours at the start [m]",
                         {"-0.01", "-0.02", "-0.04", "-0.08", "-0.15", "-0.3", "-0.6", "-1.2", "-2.2"},
                         -1.0};
const AtlasAxis end_masses{"end-mass",
                           "mass of the last ball [kg]",
                           {"1", "3", "10", "30", "100", "300", "1000", "3000", "10000", "30000"}};
const AtlasAxis betas{"beta",
                      "beta: share of the overlap that a step corrects",
                      {"0.1", "0.2", "0.3", "0.4", "0.5", "0.6", "0.7", "0.8", "0.9", "1"},
                      1.0,
                      false};

// Of the first steps of this list.
AtlasAxis time_step(std::size_t count) {
    Values steps{"1/960", "1/480", "1/240", "1/120", "1/60", "1/30", "1/15", "1/8", "1/4", "1/2"};
    steps.resize(count);
    return {"dt", "time step [s]", steps};
}

// Sweeps in which an error falls to 1/e: for a heavy cube on a light one a sweep leaves R / (R + 1) of it.
double sweeps_of_mass_ratio(double ratio) {
    return 1.0 / std::log1p(1.0 / ratio);
}

// The same for a column of n equal bodies, where a sweep leaves cos^2(pi / 2n).
double sweeps_of_height(double count) {
    return -0.5 / std::log(std::cos(0.5 * std::numbers::pi / count));
}

// The five contacts of the stack each add beta overlap / dt. From this beta on the topmost cube still rises at
// sqrt(g L), the limit of "fly", two seconds into the three of the run.
double beta_that_throws(double overlap) {
    constexpr double dt = 1.0 / 60.0, side = 2.4, contacts = 5.0, seconds = 2.0;
    return (gravity * seconds + std::sqrt(gravity * side)) * dt / (contacts * overlap);
}

// The links vibrate sideways with up to ω = 2 sqrt(T / (m l)), which a step resolves while ω dt < 2. T is the
// tension of the topmost bar when the straight chain passes its lowest point.
double step_that_tension_allows(double end_mass) {
    constexpr double links = 20.0, mass = 1.0, length = 1.0, angle = std::numbers::pi / 4.0;
    constexpr double sum = links * (links - 1.0) / 2.0;                            // 1 + 2 + ... + (links - 1)
    constexpr double squares = links * (links - 1.0) * (2.0 * links - 1.0) / 6.0;  // of their squares
    const double moment = (end_mass * links + mass * sum) * length;
    const double inertia = (end_mass * links * links + mass * squares) * length * length;
    const double turning = 2.0 * gravity * (1.0 - std::cos(angle)) * moment / inertia;  // 1/s^2, squared rate
    const double tension = (end_mass + mass * (links - 1.0)) * gravity + turning * moment;
    return std::sqrt(mass * length / tension);
}

constexpr std::size_t most_values = 10000;  // of an axis
constexpr const char* forms = "must be OPTION=FROM:TO:STEP, OPTION=log:FROM:TO:COUNT or OPTION=A,B,C";

// An option of the command line, as messages name it.
struct Typed {
    std::string field, text;
};

[[noreturn]] void refuse(const Typed& typed, const std::string& why) {
    throw UsageError("{} {}: {}", typed.field, typed.text, why);
}

std::pair<std::string, std::string> name_and_value(const Typed& typed, const std::string& allowed) {
    const auto& text = typed.text;
    const auto equals = text.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == text.size()) refuse(typed, allowed);
    return {text.substr(0, equals), text.substr(equals + 1)};
}

// Exact: 0.1, 0.2, 0.3 and not 0.30000000000000004.
std::vector<std::string> equal_steps(const Typed& typed, const std::vector<std::string_view>& words) {
    const auto from = parse_rational(words[0]), to = parse_rational(words[1]), step = parse_rational(words[2]);
    if (!from || !to || !step) refuse(typed, forms);
    const double count = std::floor((to->value() - from->value()) / step->value() + 1e-9) + 1.0;
    if (step->value() == 0.0 || !(count >= 2.0) || count > static_cast<double>(most_values)) {
        refuse(typed, fmt::format("must have 2 to {} values from FROM to TO", most_values));
    }
    std::vector<std::string> values;
    for (std::int64_t i = 0; i < static_cast<std::int64_t>(count); ++i) {
        try {
            values.push_back(to_text(*from + *step * Rational{i, 1}));
        } catch (const std::overflow_error& error) {
            refuse(typed, error.what());
        }
    }
    return values;
}

// `whole`: rounded to whole numbers, without repetitions.
std::vector<std::string> equal_factors(const Typed& typed, const std::vector<std::string_view>& words, bool whole) {
    const auto from = parse_number(words[1]), to = parse_number(words[2]);
    const auto count = parse_integer(words[3]);
    if (!from || !to || !count) refuse(typed, forms);
    if (*from <= 0.0 || *to <= *from || *count < 2 || *count > static_cast<int>(most_values)) {
        refuse(typed, fmt::format("must be 0 < FROM < TO and COUNT from 2 to {}", most_values));
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

// An option that the run has, and that is not among `set`: of two values for one option, one would be ignored.
void require_free(const Choices& run, const OptionTexts& set, const Typed& typed, const std::string& name) {
    std::vector<std::string> known = simulation_option_names();
    for (const auto& [parameter, value] : run.parameters) known.push_back(parameter);
    if (std::ranges::find(known, name) == known.end()) refuse(typed, name + " " + one_of(name, known));
    const auto found = std::ranges::find(set, name, [](const auto& option) { return option.first; });
    if (found != set.end()) refuse(typed, fmt::format("must be without --set {}={}", name, found->second));
}

// Throws UsageError for a value that no run accepts.
void require_accepted(const GridRequest& request, OptionTexts options, const std::string& name,
                      const std::string& value) {
    options.emplace_back(name, value);
    run_of(request.scene, options);
}

AtlasAxis axis_of(const GridRequest& request, const OptionTexts& set, const Typed& typed) {
    const auto [name, value] = name_and_value(typed, forms);
    require_free(run_of(request.scene, set), set, typed, name);
    AtlasAxis axis{.option = name, .label = name, .values = {}, .scale = 1.0, .logarithmic = false};
    const std::vector<std::string_view> words = parts_of(value, ':');
    if (words.size() == 4 && words[0] == "log") {
        axis.logarithmic = true;
        axis.values = equal_factors(typed, words, false);
        try {
            if (axis.values.size() > 2) require_accepted(request, set, name, axis.values[1]);
        } catch (const UsageError&) {  // as a count, which must be whole
            axis.values = equal_factors(typed, words, true);
        }
    } else if (words.size() == 3) {
        axis.values = equal_steps(typed, words);
    } else if (words.size() == 1) {
        for (const std::string_view part : parts_of(value)) axis.values.emplace_back(part);
        axis.names = !std::ranges::all_of(axis.values,
                                          [](const std::string& one) { return parse_rational(one).has_value(); });
    } else {
        refuse(typed, forms);
    }
    if (!axis.names) {
        std::ranges::stable_sort(axis.values, {}, [&](const std::string& one) { return axis.shown(one); });
    }
    const auto same = [&](const auto& a, const auto& b) { return axis.shown(a) == axis.shown(b); };
    if (axis.values.size() < 2 || std::ranges::adjacent_find(axis.values, same) != axis.values.end()) {
        refuse(typed, "must have at least two values, and none twice");
    }
    if (words.size() == 1) axis.names = true;  // a list has equal cells, whatever its numbers are
    for (const std::string& one : axis.values) require_accepted(request, set, name, one);
    return axis;
}

OptionTexts options_of(const GridRequest& request) {
    OptionTexts options;
    for (const std::string& text : request.set) {
        const auto [name, value] = name_and_value({"--set", text}, "must be OPTION=VALUE");
        require_free(run_of(request.scene, {}), options, {"--set", text}, name);
        options.emplace_back(name, value);
    }
    return options;
}

// A number of the summary; those that are not known at the start are null there.
void require_measure(const std::string& measure, const GridRequest& request, const OptionTexts& options) {
    const Choices choices = run_of(request.scene, options);
    const Simulation start(choices);
    const Json summary = summary_of(choices, start, Measurements(start));
    std::vector<std::string> numbers;
    for (const auto& [name, value] : summary.items()) {
        if (value.is_number() || value.is_null()) numbers.push_back(name);
    }
    require_known("--measure", measure, numbers);
}

}  // namespace

double AtlasAxis::shown(const std::string& value) const {
    if (names) return static_cast<double>(std::find(values.begin(), values.end(), value) - values.begin());
    return scale * parse_rational(value).value().value();
}

std::vector<AtlasMap> atlas_maps(bool quick) {
    const std::string overlapping = "Five cubes of 2.4 m that overlap each other and the ground, 3 s. ";
    const std::string dropped = "The stack of section 10.1, dropped from its gaps, 10 s, preset ";
    const std::string swinging =
        "A chain of 20 balls of 1 kg on bars of 1 m swings from 45 degrees under the weight of its last ball, "
        "10 s. Moving is the swing itself; torn: bars are off by half of them. ";
    const AtlasTheory resolved{"ω dt = 2", step_that_tension_allows};
    const OptionTexts sweeps{{"seconds", "10"}, {"solver", "pgs"}, {"tolerance", "0"}};
    OptionTexts touching = sweeps;
    touching.emplace_back("gap", "0");
    std::vector<AtlasMap> maps{
        {"mass_ratio_iterations", "Heavy on light: how many iterations a mass ratio takes",
         "A cube of R kg on one of 1 kg, 10 s, projected Gauss-Seidel with warm start. Theory: the sweeps in which "
         "an error falls to 1/e, about R; with warm start the steps share them.",
         "heavy-on-light", sweeps, mass_ratios,
         AtlasAxis{
             "iterations", "iterations per step", {"1", "2", "5", "10", "20", "50", "100", "200", "500", "1000"}},
         off_axis, AtlasTheory{"error to 1/e in one step", sweeps_of_mass_ratio}},
        {"height_iterations", "Towers: how many iterations a height takes",
         "Equal cubes that touch, 10 s, projected Gauss-Seidel with warm start. Theory: the sweeps in which an "
         "error falls to 1/e, which grow with the square of the height; with warm start the steps share them.",
         "stack", touching, heights,
         AtlasAxis{"iterations", "iterations per step", {"1", "2", "5", "10", "20", "50", "100", "200", "400"}},
         off_axis, AtlasTheory{"error to 1/e in one step", sweeps_of_height}},
        {"overlap_beta_persistent", "Overlap under the original push: what is pushed out flies",
         overlapping + "The persistent push leaves the correcting velocity in the momenta. Theory: from this beta "
                       "on the topmost cube still rises after two seconds.",
         "stack", OptionTexts{{"seconds", "3"}, {"push", "persistent"}}, overlaps, betas, upward,
         AtlasTheory{"thrown at 25 m/s", beta_that_throws}},
        {"overlap_beta_single_frame", "Overlap under the single-frame push: it only moves apart",
         overlapping + "The single-frame push of section 8.1 leaves no velocity behind. With a small beta the last "
                       "of the overlap is still on its way out after 3 s; cubes that almost coincide are moved out "
                       "sideways too, and some come down beside the others.",
         "stack", OptionTexts{{"seconds", "3"}, {"push", "single-frame"}}, overlaps, betas, upward},
        {"step_beta_paper", "The stack by the paper's method: long steps and beta 1 bring it down",
         dropped + "paper. 25 cold iterations never bring it wholly to rest; a beta near 1 or a long step throws "
                   "it over.",
         "stack", OptionTexts{{"preset", "paper"}, {"seconds", "10"}}, time_step(10), betas, off_axis},
        {"step_beta_default", "The stack with the default preset: it stands at every step and beta",
         dropped + "default. Single-frame push, contact caching and a direct finish.", "stack",
         OptionTexts{{"preset", "default"}, {"seconds", "10"}}, time_step(10), betas, off_axis},
        {"tension_step_plain", "Bars under tension: the longest step that holds",
         swinging + "Theory: the fastest sideways vibration of the links, ω = 2 sqrt(T / (m l)), resolved by the "
                    "step.",
         "chain", OptionTexts{{"seconds", "10"}, {"angle", "45"}, {"substeps", "1"}}, end_masses, time_step(7),
         length_error, resolved, "moving: swings on"},
        {"tension_step_substeps", "Bars under tension with automatic substeps: the step no longer matters",
         swinging + "Theory: the longest step without substeps.", "chain",
         OptionTexts{{"seconds", "10"}, {"angle", "45"}, {"substeps", "auto"}}, end_masses, time_step(7),
         length_error, resolved, "moving: swings on"},
    };
    for (AtlasMap& map : maps) {
        for (AtlasAxis* axis : {&map.x, &map.y}) {
            Values& all = axis->values;
            if (quick) all = {all.front(), all[all.size() / 2], all.back()};
        }
    }
    return maps;
}

AtlasMap grid_map(const GridRequest& request) {
    const OptionTexts options = options_of(request);
    const std::string measure = request.measure.value_or("max_penetration_m");
    const AtlasAxis x = axis_of(request, options, {"--x", request.x}),
                    y = axis_of(request, options, {"--y", request.y});
    if (x.option == y.option) refuse({"--y", request.y}, "must be another option than that of --x");
    require_measure(measure, request, options);
    const std::string scene = run_of(request.scene, options).description.name;
    return {.name = "grid",
            .title = fmt::format("{}: {} and {}", scene, x.option, y.option),
            .caption = fmt::format("{} runs.", x.values.size() * y.values.size()),
            .scene = request.scene,
            .common = options,
            .x = x,
            .y = y,
            .measure = {.key = measure, .words = measure}};
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
            refuse({"--replays", text}, "must be all, or X:Y with a value of each axis as its table has it");
        }
        chosen.push_back(cell_at(map, std::string(parts[0]), std::string(parts[1])));
    }
    return chosen;
}

}  // namespace pushfactor::demos::reports::atlas
