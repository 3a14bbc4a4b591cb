#include "demos/options/simulation_options.h"

#include "demos/base/text/numbers.h"
#include "demos/base/text/suggest.h"
#include "engine/solvers/solver.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace pushfactor::demos {

namespace {

using engine::PushKind;
using engine::RowOrder;

// Assigns what was parsed to `field`, if it was.
template <typename Field, typename Value>
bool take(Field& field, const std::optional<Value>& parsed) {
    if (parsed) field = *parsed;
    return parsed.has_value();
}

bool set_seconds(Settings& s, std::string_view text) {
    auto seconds = parse_number(text);
    if (const auto fraction = parse_rational(text); fraction && !seconds) seconds = fraction->value();
    if (!seconds || *seconds < 0.0 || *seconds > 1e6) return false;
    s.seconds = *seconds;
    return true;
}

bool set_dt(Settings& s, std::string_view text) {
    const auto dt = parse_rational(text);
    if (!dt || dt->numerator <= 0 || dt->value() > 1.0 || dt->value() < 1e-6) return false;
    s.dt = *dt;
    return true;
}

bool set_tolerance(Settings& s, std::string_view text) {
    const auto slash = text.find('/');
    const auto high = parse_number(text.substr(0, slash), 0.0, 1.0);
    const auto low = slash == std::string_view::npos ? high : parse_number(text.substr(slash + 1), 0.0, 1.0);
    if (!high || !low || *high < *low) return false;
    s.tolerance_high = *high;
    s.tolerance_low = *low;
    return true;
}

bool set_small_steps(Settings& s, std::string_view text) {
    std::optional<engine::SmallSteps::Division> division;
    if (text != "auto") {
        const auto by = text.find('x');
        division.emplace();
        if (by == std::string_view::npos || !take(division->steps, parse_integer(text.substr(0, by), 1, 1000)) ||
            !take(division->sweeps, parse_integer(text.substr(by + 1), 1, 1000))) {
            return false;
        }
    }
    s.small_steps = division;
    return true;
}

bool set_solver(Settings& s, std::string_view text) {
    const std::vector<std::string> known = names_of(engine::solvers::solver_table());
    if (std::ranges::find(known, text) == known.end()) return false;
    s.solver = text;
    return true;
}

bool set_max_push_speed(Settings& s, std::string_view text) {
    const auto speed = parse_number(text, 0.0, 1e9);
    return speed != 0.0 && take(s.contacts.max_speed, speed);
}

std::string solver_names() {
    return fmt::format("{}", fmt::join(names_of(engine::solvers::solver_table()), ", "));
}

// The options below that are a number or a word; `field` is the member that they set, or a function that returns
// it.

// From `low` to `high`; `what` it is.
template <typename Field>
SimulationOption number(const char* name, const char* placeholder, const char* help, double low, double high,
                        Field field, const char* what = "a number") {
    const auto set = [=](Settings& settings, std::string_view text) {
        return take(std::invoke(field, settings), parse_number(text, low, high));
    };
    const auto get = [=](const Settings& settings) {
        const std::optional<double> value = std::invoke(field, settings);
        return value ? to_text(*value) : "";
    };
    return {name, placeholder, help, fmt::format("{} from {} to {}", what, low, high), set, get};
}

// `words`: the texts of the values, in display order.
template <typename Value, typename Field>
SimulationOption word(const char* name, const char* placeholder, const char* help,
                      const std::vector<std::pair<std::string_view, Value>>& words, Field field) {
    using Word = std::pair<std::string_view, Value>;
    std::vector<std::string_view> texts;
    for (const Word& entry : words) texts.push_back(entry.first);
    const auto set = [=](Settings& settings, std::string_view text) {
        const auto found = std::ranges::find(words, text, &Word::first);
        if (found != words.end()) std::invoke(field, settings) = found->second;
        return found != words.end();
    };
    const auto get = [=](const Settings& settings) {
        return std::string(std::ranges::find(words, std::invoke(field, settings), &Word::second)->first);
    };
    return {name, placeholder, help, fmt::format("one of {}", fmt::join(texts, ", ")), set, get};
}

template <typename Field>
SimulationOption either(const char* name, const char* placeholder, const char* help, std::string_view yes,
                        std::string_view no, Field field) {
    SimulationOption option = word<bool>(name, placeholder, help, {{yes, true}, {no, false}}, field);
    option.allowed = fmt::format("{} or {}", yes, no);
    return option;
}

const std::array simulation_table{
    SimulationOption{"seconds", "S", "simulated time in s, cut to whole steps [10]",
                     "a number of seconds from 0 to 1e6, or a fraction like 1001/1000", set_seconds,
                     [](const Settings& s) { return to_text(s.seconds); }},
    SimulationOption{"dt", "S", "time step in s, exact: 1/60 is a fraction [1/60]",
                     "a time from 1e-6 to 1 s, as a fraction like 1/60 or a decimal", set_dt,
                     [](const Settings& s) { return to_text(s.dt); }},
    SimulationOption{"substeps", "N|auto",
                     "engine steps per step; auto: as many as bars and joints need that are under tension or turn "
                     "fast, and bodies that would end deep in each other",
                     "a whole number from 1 to 10000, or auto",
                     [](Settings& s, std::string_view t) {
                         if (t == "auto") s.substeps.reset();
                         return t == "auto" || take(s.substeps, parse_integer(t, 1, 10000));
                     },
                     [](const Settings& s) { return s.substeps ? std::to_string(*s.substeps) : "auto"; }},
    SimulationOption{"solver", "NAME", "solver of the system equation: " + solver_names(),
                     "one of " + solver_names(), set_solver, [](const Settings& s) { return s.solver; }},
    SimulationOption{
        "iterations", "N", "maximum iterations per solve", "a whole number from 1 to 1000000",
        [](Settings& s, std::string_view t) { return take(s.iterations, parse_integer(t, 1, 1000000)); },
        [](const Settings& s) { return std::to_string(s.iterations); }},
    SimulationOption{
        "tolerance", "HIGH[/LOW]",
        "residual in m/s: cached forces are kept up to HIGH, a solve stops at LOW; 0: always all iterations",
        "HIGH or HIGH/LOW in m/s with 0 <= LOW <= HIGH <= 1", set_tolerance,
        [](const Settings& s) { return to_text(s.tolerance_high) + "/" + to_text(s.tolerance_low); }},
    word<Scheme>("scheme", "NAME",
                 "how a step is integrated: whole (3.2); small-steps (many per step for islands without an "
                 "exact solution); auto (small-steps with solver auto); rattle, rattle4, rattle6 (order 2, 4, "
                 "6, for scenes of bars without contacts; --distance-push and --distance-beta have no effect)",
                 {{"auto", Scheme::automatic},
                  {"whole", Scheme::whole},
                  {"small-steps", Scheme::small_steps},
                  {"rattle", Scheme::rattle},
                  {"rattle4", Scheme::rattle4},
                  {"rattle6", Scheme::rattle6}},
                 &Settings::scheme),
    SimulationOption{"small-steps", "NxK",
                     "N small steps with at least K sweeps per solve; auto: 12x1, or more steps for small bodies "
                     "under large forces",
                     "auto or NxK with whole numbers from 1 to 1000", set_small_steps,
                     [](const Settings& s) {
                         return s.small_steps ? fmt::format("{}x{}", s.small_steps->steps, s.small_steps->sweeps)
                                              : "auto";
                     }},
    word<PushKind>(
        "push", "KIND", "how contacts correct penetration: none, persistent, single-frame",
        {{"none", PushKind::none}, {"persistent", PushKind::persistent}, {"single-frame", PushKind::single_frame}},
        [](auto& s) -> auto& { return s.contacts.kind; }),
    number(
        "beta", "X", "share of the penetration that one step corrects", 0, 1,
        [](auto& s) -> auto& { return s.contacts.beta; }),
    SimulationOption{
        "max-push-speed", "V", "maximum speed at which contacts correct penetration, in m/s [no limit]",
        "a speed above 0 and up to 1e9 m/s", set_max_push_speed,
        [](const Settings& s) { return std::isfinite(s.contacts.max_speed) ? to_text(s.contacts.max_speed) : ""; }},
    word<PushKind>(
        "distance-push", "KIND",
        "how bars and joints correct their errors: none, persistent, single-frame, curve (what turning leaves "
        "becomes momentum, everything else is single-frame)",
        {{"none", PushKind::none},
         {"persistent", PushKind::persistent},
         {"single-frame", PushKind::single_frame},
         {"curve", PushKind::curve}},
        [](auto& s) -> auto& { return s.distances.kind; }),
    number(
        "distance-beta", "X", "share of the length error that one step corrects", 0, 1,
        [](auto& s) -> auto& { return s.distances.beta; }),
    either("warm-start", "on|off", "contact caching: start from the forces of the previous step", "on", "off",
           &Settings::warm_start),
    number("slop", "F", "penetration that is not corrected, fraction of the body's size", 0, 0.5, &Settings::slop,
           "a fraction of the body's size"),
    number("margin", "F",
           "gap up to which a point counts as contact, fraction of the body's size; bodies that move by "
           "more in a step get continuous collision detection; 0: neither",
           0, 1, &Settings::margin, "a fraction of the body's size"),
    word<RowOrder>("row-order", "NAME", "order of the rows: bottom-up, reverse, creation, normals-first",
                   {{"bottom-up", RowOrder::bottom_up},
                    {"reverse", RowOrder::reverse},
                    {"creation", RowOrder::creation},
                    {"normals-first", RowOrder::normals_first}},
                   &Settings::row_order),
    either("manifold-points", "4|8", "contact points kept per pair of faces", "4", "8", &Settings::four_points),
    number("friction", "MU", "friction coefficient of all bodies; 0: no friction rows [the scene's own]", 0, 100,
           &Settings::friction),
    word<FrictionModel>(
        "friction-model", "NAME", "bound of friction: paper (weight), coulomb (normal force, square) or cone",
        {{"paper", FrictionModel::paper}, {"coulomb", FrictionModel::coulomb}, {"cone", FrictionModel::cone}},
        &Settings::friction_model),
    number("restitution", "E", "coefficient of restitution of all bodies [the scene's own]", 0, 1,
           &Settings::restitution),
    word<RestitutionModel>(
        "restitution-model", "NAME", "sum (8.2: rebound added to the push) or larger (each impact at its time)",
        {{"sum", RestitutionModel::sum}, {"larger", RestitutionModel::larger}}, &Settings::restitution_model),
    word<StartKick>(
        "start-kick", "on|off|auto",
        "initial momenta shifted back by half a step (second order); auto: without contacts and from rest",
        {{"on", StartKick::on}, {"off", StartKick::off}, {"auto", StartKick::where_it_fits}},
        &Settings::start_kick),
    word<Rotation>(
        "rotation", "NAME", "orientation step: paper (3.2.4), exponential (12.4.1), splitting",
        {{"paper", Rotation::paper}, {"exponential", Rotation::exponential}, {"splitting", Rotation::splitting}},
        &Settings::rotation),
    SimulationOption{"measured", "FILE",
                     "poses that were measured, as --trajectory writes them: their bodies are drawn too, in ivory, "
                     "and the distance from them is in the summary and --errors",
                     "a file that ends in .csv",
                     [](Settings& s, std::string_view t) {
                         if (!t.ends_with(".csv")) return false;
                         s.measured = t;
                         return true;
                     },
                     [](const Settings& s) { return s.measured; }},
    SimulationOption{"threads", "N|all", "threads per step; the results are bit-identical for any number [all]",
                     "all or an integer from 1 to 256",
                     [](Settings& s, std::string_view t) {
                         if (t == "all") s.threads = 0;
                         return t == "all" || take(s.threads, parse_integer(t, 1, 256));
                     },
                     [](const Settings& s) { return s.threads == 0 ? "all" : std::to_string(s.threads); }},
    either("rest", "on|off",
           "sleeping: skip bodies that stand in equilibrium for half a second until something wakes "
           "them; no effect in RATTLE steps",
           "on", "off", &Settings::rest),
};

}  // namespace

std::string scheme_name(const Settings& settings) {
    return std::ranges::find(simulation_table, "scheme", &SimulationOption::name)->get(settings);
}

bool is_of_preset(std::string_view option) {
    for (const char* const of_run : {"seconds", "dt", "friction", "restitution", "threads", "measured"}) {
        if (option == of_run) return false;
    }
    return std::ranges::find(simulation_table, option, &SimulationOption::name) != simulation_table.end();
}

std::span<const SimulationOption> simulation_options() {
    return simulation_table;
}

std::vector<std::pair<std::string, std::string>> texts_of(const Settings& settings) {
    std::vector<std::pair<std::string, std::string>> texts;
    for (const SimulationOption& option : simulation_table) {
        if (std::string text = option.get(settings); !text.empty()) texts.emplace_back(option.name, text);
    }
    return texts;
}

std::vector<std::string> simulation_option_names() {
    std::vector<std::string> names = names_of(simulation_table);
    names.insert(names.begin(), "preset");
    return names;
}

}  // namespace pushfactor::demos
