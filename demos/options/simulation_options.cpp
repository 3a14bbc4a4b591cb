#include "demos/options/simulation_options.h"

#include "demos/text/numbers.h"
#include "engine/solvers/solver.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace pushfactor::demos {

namespace {

using engine::PushKind;
using engine::RowOrder;

// Assigns the parsed number to `field` if it is in [low, high].
template <typename Number>
bool take(Number& field, std::optional<Number> parsed, Number low, Number high) {
    if (!parsed || *parsed < low || *parsed > high) return false;
    field = *parsed;
    return true;
}

template <typename Value, std::size_t n>
using Names = std::array<std::pair<std::string_view, Value>, n>;

constexpr Names<PushKind, 3> push_names{
    {{"none", PushKind::none}, {"persistent", PushKind::persistent}, {"single-frame", PushKind::single_frame}}};
constexpr Names<PushKind, 4> distance_push_names{{{"none", PushKind::none},
                                                  {"persistent", PushKind::persistent},
                                                  {"single-frame", PushKind::single_frame},
                                                  {"curve", PushKind::curve}}};
constexpr Names<RowOrder, 4> order_names{{{"bottom-up", RowOrder::bottom_up},
                                          {"reverse", RowOrder::reverse},
                                          {"creation", RowOrder::creation},
                                          {"normals-first", RowOrder::normals_first}}};
constexpr Names<bool, 2> switch_names{{{"on", true}, {"off", false}}};
constexpr Names<FrictionModel, 3> friction_names{
    {{"paper", FrictionModel::paper}, {"coulomb", FrictionModel::coulomb}, {"cone", FrictionModel::cone}}};
constexpr Names<RestitutionModel, 2> restitution_names{
    {{"sum", RestitutionModel::sum}, {"larger", RestitutionModel::larger}}};
constexpr Names<StartKick, 3> kick_names{
    {{"on", StartKick::on}, {"off", StartKick::off}, {"auto", StartKick::where_it_fits}}};
constexpr Names<Rotation, 3> rotation_names{
    {{"paper", Rotation::paper}, {"exponential", Rotation::exponential}, {"splitting", Rotation::splitting}}};
constexpr Names<Scheme, 6> scheme_names{{{"auto", Scheme::automatic},
                                         {"whole", Scheme::whole},
                                         {"small-steps", Scheme::small_steps},
                                         {"rattle", Scheme::rattle},
                                         {"rattle4", Scheme::rattle4},
                                         {"rattle6", Scheme::rattle6}}};

template <typename Value, std::size_t n>
bool take_name(Value& field, const Names<Value, n>& names, std::string_view text) {
    const auto found =
        std::find_if(names.begin(), names.end(), [&](const auto& entry) { return entry.first == text; });
    if (found == names.end()) return false;
    field = found->second;
    return true;
}

template <typename Value, std::size_t n>
std::string name_of(const Value& value, const Names<Value, n>& names) {
    const auto found =
        std::find_if(names.begin(), names.end(), [&](const auto& entry) { return entry.second == value; });
    return std::string(found->first);
}

bool set_seconds(Settings& s, std::string_view text) {
    auto seconds = parse_number(text);
    if (const auto fraction = parse_rational(text); fraction && !seconds) seconds = fraction->value();
    return take(s.seconds, seconds, 0.0, 1e6);
}

bool set_dt(Settings& s, std::string_view text) {
    const auto dt = parse_rational(text);
    if (!dt || dt->numerator <= 0 || dt->value() > 1.0 || dt->value() < 1e-6) return false;
    s.dt = *dt;
    return true;
}

bool set_tolerance(Settings& s, std::string_view text) {
    const auto slash = text.find('/');
    const auto high = parse_number(text.substr(0, slash));
    const auto low = slash == std::string_view::npos ? high : parse_number(text.substr(slash + 1));
    if (!high || !low || *low < 0.0 || *high < *low || *high > 1.0) return false;
    s.tolerance_high = *high;
    s.tolerance_low = *low;
    return true;
}

bool set_substeps(Settings& s, std::string_view text) {
    int value = 0;
    if (text != "auto" && !take(value, parse_integer(text), 1, 10000)) return false;
    s.substeps = text == "auto" ? std::nullopt : std::optional(value);
    return true;
}

bool set_threads(Settings& s, std::string_view text) {
    int value = 0;
    if (text != "all" && !take(value, parse_integer(text), 1, 256)) return false;
    s.threads = value;
    return true;
}

bool set_small_steps(Settings& s, std::string_view text) {
    std::optional<engine::SmallSteps::Division> division;
    if (text != "auto") {
        const auto by = text.find('x');
        division.emplace();
        if (by == std::string_view::npos || !take(division->steps, parse_integer(text.substr(0, by)), 1, 1000) ||
            !take(division->sweeps, parse_integer(text.substr(by + 1)), 1, 1000)) {
            return false;
        }
    }
    s.small_steps = division;
    return true;
}

std::string small_steps_text(const Settings& s) {
    return s.small_steps ? fmt::format("{}x{}", s.small_steps->steps, s.small_steps->sweeps) : "auto";
}

bool set_solver(Settings& s, std::string_view text) {
    for (const auto& entry : engine::solvers::solver_table()) {
        if (entry.name != text) continue;
        s.solver = text;
        return true;
    }
    return false;
}

bool set_friction(Settings& s, std::string_view text) {
    double value = 0.0;
    if (!take(value, parse_number(text), 0.0, 100.0)) return false;
    s.friction = value;
    return true;
}

bool set_restitution(Settings& s, std::string_view text) {
    double value = 0.0;
    if (!take(value, parse_number(text), 0.0, 1.0)) return false;
    s.restitution = value;
    return true;
}

bool set_max_push_speed(Settings& s, std::string_view text) {
    double value = 0.0;
    if (!take(value, parse_number(text), 0.0, 1e9) || value == 0.0) return false;
    s.contacts.max_speed = value;
    return true;
}

std::string solver_names() {
    std::string names;
    for (const auto& entry : engine::solvers::solver_table()) {
        names += (names.empty() ? "" : ", ") + std::string(entry.name);
    }
    return names;
}

const std::array simulation_table{
    SimulationOption{"seconds", "S", "simulated time in s, cut to whole steps [10]",
                     "a number of seconds from 0 to 1e6, or a fraction like 1001/1000", set_seconds,
                     [](const Settings& s) { return to_text(s.seconds); }},
    SimulationOption{"dt", "S", "time step in s, exact: 1/60 is a fraction [1/60]",
                     "a time from 1e-6 to 1 s, as a fraction like 1/60 or a decimal", set_dt,
                     [](const Settings& s) { return to_text(s.dt); }},
    SimulationOption{
        "substeps", "N|auto",
        "engine steps per step; auto: as many as bars and joints need that are under tension or turn fast",
        "a whole number from 1 to 10000, or auto", set_substeps,
        [](const Settings& s) { return s.substeps ? std::to_string(*s.substeps) : "auto"; }},
    SimulationOption{"solver", "NAME", "solver of the system equation: " + solver_names(),
                     "one of " + solver_names(), set_solver, [](const Settings& s) { return s.solver; }},
    SimulationOption{
        "iterations", "N", "maximum iterations per solve", "a whole number from 1 to 1000000",
        [](Settings& s, std::string_view t) { return take(s.iterations, parse_integer(t), 1, 1000000); },
        [](const Settings& s) { return std::to_string(s.iterations); }},
    SimulationOption{
        "tolerance", "HIGH[/LOW]",
        "residual in m/s: cached forces are kept up to HIGH, a solve stops at LOW; 0: always all iterations",
        "HIGH or HIGH/LOW in m/s with 0 <= LOW <= HIGH <= 1", set_tolerance,
        [](const Settings& s) { return to_text(s.tolerance_high) + "/" + to_text(s.tolerance_low); }},
    SimulationOption{"scheme", "NAME",
                     "how a step is integrated: whole (3.2); small-steps (many per step for islands without an "
                     "exact solution); auto (small-steps with solver auto); rattle, rattle4, rattle6 (order 2, 4, "
                     "6, for scenes of bars without contacts; --distance-push and --distance-beta have no effect)",
                     "one of auto, whole, small-steps, rattle, rattle4, rattle6",
                     [](Settings& s, std::string_view t) { return take_name(s.scheme, scheme_names, t); },
                     scheme_name},
    SimulationOption{
        "small-steps", "NxK",
        "N small steps with at least K sweeps per solve; auto: 16, or 8 where more than 2 % of the bodies move",
        "auto or NxK with whole numbers from 1 to 1000", set_small_steps, small_steps_text},
    SimulationOption{"push", "KIND", "how contacts correct penetration: none, persistent, single-frame",
                     "one of none, persistent, single-frame",
                     [](Settings& s, std::string_view t) { return take_name(s.contacts.kind, push_names, t); },
                     [](const Settings& s) { return name_of(s.contacts.kind, push_names); }},
    SimulationOption{
        "beta", "X", "share of the penetration that one step corrects", "a number from 0 to 1",
        [](Settings& s, std::string_view t) { return take(s.contacts.beta, parse_number(t), 0.0, 1.0); },
        [](const Settings& s) { return to_text(s.contacts.beta); }},
    SimulationOption{
        "max-push-speed", "V", "maximum speed at which contacts correct penetration, in m/s [no limit]",
        "a speed above 0 and up to 1e9 m/s", set_max_push_speed,
        [](const Settings& s) { return std::isfinite(s.contacts.max_speed) ? to_text(s.contacts.max_speed) : ""; }},
    SimulationOption{
        "distance-push", "KIND",
        "how bars and joints correct their errors: none, persistent, single-frame, curve (what turning leaves "
        "becomes momentum, everything else is single-frame)",
        "one of none, persistent, single-frame, curve",
        [](Settings& s, std::string_view t) { return take_name(s.distances.kind, distance_push_names, t); },
        [](const Settings& s) { return name_of(s.distances.kind, distance_push_names); }},
    SimulationOption{
        "distance-beta", "X", "share of the length error that one step corrects", "a number from 0 to 1",
        [](Settings& s, std::string_view t) { return take(s.distances.beta, parse_number(t), 0.0, 1.0); },
        [](const Settings& s) { return to_text(s.distances.beta); }},
    SimulationOption{"warm-start", "on|off", "contact caching: start from the forces of the previous step",
                     "on or off",
                     [](Settings& s, std::string_view t) { return take_name(s.warm_start, switch_names, t); },
                     [](const Settings& s) { return name_of(s.warm_start, switch_names); }},
    SimulationOption{"slop", "F", "penetration that is not corrected, fraction of the body's size",
                     "a fraction of the body's size from 0 to 0.5",
                     [](Settings& s, std::string_view t) { return take(s.slop, parse_number(t), 0.0, 0.5); },
                     [](const Settings& s) { return to_text(s.slop); }},
    SimulationOption{"margin", "F",
                     "gap up to which a point counts as contact, fraction of the body's size; bodies that move by "
                     "more in a step get continuous collision detection; 0: neither",
                     "a fraction of the body's size from 0 to 1",
                     [](Settings& s, std::string_view t) { return take(s.margin, parse_number(t), 0.0, 1.0); },
                     [](const Settings& s) { return to_text(s.margin); }},
    SimulationOption{"row-order", "NAME", "order of the rows: bottom-up, reverse, creation, normals-first",
                     "one of bottom-up, reverse, creation, normals-first",
                     [](Settings& s, std::string_view t) { return take_name(s.row_order, order_names, t); },
                     [](const Settings& s) { return name_of(s.row_order, order_names); }},
    SimulationOption{"manifold-points", "4|8", "contact points kept per pair of faces", "4 or 8",
                     [](Settings& s, std::string_view t) {
                         if (t != "4" && t != "8") return false;
                         s.four_points = t == "4";
                         return true;
                     },
                     [](const Settings& s) { return std::string(s.four_points ? "4" : "8"); }},
    SimulationOption{"friction", "MU", "friction coefficient of all bodies; 0: no friction rows [the scene's own]",
                     "a number from 0 to 100", set_friction,
                     [](const Settings& s) { return s.friction ? to_text(*s.friction) : std::string(); }},
    SimulationOption{"friction-model", "NAME",
                     "bound of friction: paper (weight), coulomb (normal force, square) or cone",
                     "one of paper, coulomb, cone",
                     [](Settings& s, std::string_view t) { return take_name(s.friction_model, friction_names, t); },
                     [](const Settings& s) { return name_of(s.friction_model, friction_names); }},
    SimulationOption{"restitution", "E", "coefficient of restitution of all bodies [the scene's own]",
                     "a number from 0 to 1", set_restitution,
                     [](const Settings& s) { return s.restitution ? to_text(*s.restitution) : std::string(); }},
    SimulationOption{
        "restitution-model", "NAME", "sum (8.2: rebound added to the push) or larger (each impact at its time)",
        "one of sum, larger",
        [](Settings& s, std::string_view t) { return take_name(s.restitution_model, restitution_names, t); },
        [](const Settings& s) { return name_of(s.restitution_model, restitution_names); }},
    SimulationOption{
        "start-kick", "on|off|auto",
        "initial momenta shifted back by half a step (second order); auto: without contacts and from rest",
        "one of on, off, auto",
        [](Settings& s, std::string_view t) { return take_name(s.start_kick, kick_names, t); },
        [](const Settings& s) { return name_of(s.start_kick, kick_names); }},
    SimulationOption{"rotation", "NAME", "orientation step: paper (3.2.4), exponential (12.4.1), splitting",
                     "one of paper, exponential, splitting",
                     [](Settings& s, std::string_view t) { return take_name(s.rotation, rotation_names, t); },
                     [](const Settings& s) { return name_of(s.rotation, rotation_names); }},
    SimulationOption{"measured", "FILE",
                     "poses that were measured, as --trajectory writes them: their bodies are drawn too, in ivory, "
                     "and the distance from them is in the summary and --errors",
                     "a file that ends in .csv",
                     [](Settings& s, std::string_view t) {
                         if (!t.ends_with(".csv")) return false;
                         s.measured = t;
                         return true;
                     },
                     [](const Settings& s) { return s.measured; }, true},
    SimulationOption{"threads", "N|all", "threads per step; the results are bit-identical for any number [all]",
                     "all or an integer from 1 to 256", set_threads,
                     [](const Settings& s) { return s.threads == 0 ? "all" : std::to_string(s.threads); }},
    SimulationOption{"rest", "on|off",
                     "sleeping: skip bodies that stand in equilibrium for half a second until something wakes "
                     "them; no effect in RATTLE steps",
                     "on or off",
                     [](Settings& s, std::string_view t) { return take_name(s.rest, switch_names, t); },
                     [](const Settings& s) { return name_of(s.rest, switch_names); }},
};

}  // namespace

std::string scheme_name(const Settings& settings) {
    return name_of(settings.scheme, scheme_names);
}

bool is_of_preset(std::string_view option) {
    static constexpr std::array<std::string_view, 6> of_run{"seconds",     "dt",      "friction",
                                                            "restitution", "threads", "measured"};
    if (std::find(of_run.begin(), of_run.end(), option) != of_run.end()) return false;
    return std::any_of(simulation_table.begin(), simulation_table.end(),
                       [&](const auto& known) { return known.name == option; });
}

std::span<const SimulationOption> simulation_options() {
    return simulation_table;
}

std::vector<std::string> simulation_option_names() {
    std::vector<std::string> names{"preset"};
    for (const SimulationOption& option : simulation_options()) names.emplace_back(option.name);
    return names;
}

}  // namespace pushfactor::demos
