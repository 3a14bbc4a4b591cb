#include "demos/reports/error/experiments.h"

#include "demos/options/simulation_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pushfactor::demos::reports::error {

namespace {

using Values = std::vector<std::string>;

constexpr int filled_circle = 7, filled_square = 5, filled_triangle = 9, diamond = 13;
constexpr int solid = 1, dashed = 2, dotted = 3;

// Solvers, by the colours that they have in all plots. Sweeps run all their iterations (tolerance 0); what works to
// a tolerance is swept over that.
std::vector<Method> solvers(bool push_matters) {
    const OptionTexts all{{"tolerance", "0"}};
    const auto with = [](OptionTexts options, const OptionTexts& more) {
        options.insert(options.end(), more.begin(), more.end());
        return options;
    };
    std::vector<Method> methods;
    for (const auto& [solver, colour] :
         {std::pair{"pgs", "blue"}, std::pair{"nncg", "green"}, std::pair{"jacobi", "orange"}}) {
        const std::string name = solver;
        const OptionTexts own = with(all, {{"solver", solver}});
        methods.push_back({name + ", warm", own, "iterations", colour, solid, filled_circle});
        methods.push_back(
            {name + ", cold", with(own, {{"warm-start", "off"}}), "iterations", colour, dashed, filled_square});
    }
    if (push_matters) {
        const OptionTexts persistent = with(all, {{"solver", "pgs"}, {"push", "persistent"}});
        methods.push_back({"pgs, warm, persistent", persistent, "iterations", "vermilion", solid, filled_circle});
        methods.push_back({"pgs, cold, persistent", with(persistent, {{"warm-start", "off"}}), "iterations",
                           "vermilion", dashed, filled_square});
    }
    methods.push_back({"direct", {{"solver", "direct"}}, "tolerance", "violet", solid, diamond});
    methods.push_back({"auto", {{"solver", "auto"}}, "tolerance", "violet", dotted, filled_triangle});
    return methods;
}

Method substeps_of_few() {
    return {"pgs, warm, 4 a substep",
            {{"solver", "pgs"}, {"iterations", "4"}, {"tolerance", "0"}},
            "substeps",
            "blue",
            dotted,
            filled_triangle};
}

// Sweeps of whole steps beside small steps of so many sweeps each.
std::vector<Method> small_steps(bool quick) {
    std::vector<Method> methods{{"whole step, from the last forces",
                                 {{"tolerance", "0"}, {"solver", "pgs"}},
                                 "iterations",
                                 "blue",
                                 solid,
                                 filled_circle},
                                {"whole step, no push",
                                 {{"tolerance", "0"}, {"solver", "pgs"}, {"push", "none"}},
                                 "iterations",
                                 "blue",
                                 dashed,
                                 filled_square}};
    for (const auto& [sweeps, colour] :
         {std::pair{"1", "orange"}, std::pair{"2", "green"}, std::pair{"4", "violet"}}) {
        Method& method =
            methods.emplace_back(Method{fmt::format("small steps of {}", sweeps),
                                        {{"tolerance", "0"}, {"solver", "pgs"}, {"scheme", "small-steps"}},
                                        "small-steps",
                                        colour,
                                        solid,
                                        filled_triangle});
        for (const char* const steps : {"2", "4", "8", "16", "32", "64"}) {
            if (quick && std::string_view(steps).size() > 1) continue;
            method.values.push_back(fmt::format("{}x{}", steps, sweeps));
        }
    }
    return methods;
}

std::vector<Method> integrators() {
    return {
        {"beta 0.2, no kick",
         {{"distance-beta", "0.2"}, {"start-kick", "off"}},
         "dt",
         "vermilion",
         dashed,
         filled_square,
         1},
        {"beta 1, no kick", {{"start-kick", "off"}}, "dt", "vermilion", solid, filled_circle, 1},
        {"beta 1, half kick", {}, "dt", "blue", solid, filled_circle, 2},
        {"single-frame, half kick", {{"distance-push", "single-frame"}}, "dt", "blue", dashed, filled_square, 1},
        {"rattle", {{"scheme", "rattle"}}, "dt", "green", solid, filled_triangle, 2},
        {"rattle4", {{"scheme", "rattle4"}}, "dt", "orange", solid, filled_triangle, 4},
        {"rattle6", {{"scheme", "rattle6"}}, "dt", "violet", solid, filled_triangle, 6},
    };
}

// Of bodies that nothing touches. rattle would be the half kick again.
std::vector<Method> free_motions() {
    const auto composed = [](const char* scheme, const char* colour, double order, int moves) {
        Method method{scheme, {{"scheme", scheme}, {"start-kick", "off"}}, "dt", colour, solid, filled_triangle};
        method.order = order;
        method.moves = moves;
        return method;
    };
    return {
        {"splitting, no kick", {{"start-kick", "off"}}, "dt", "blue", dashed, filled_square, 1},
        {"splitting, half kick", {}, "dt", "blue", solid, filled_circle, 2},
        {"exponential, half kick", {{"rotation", "exponential"}}, "dt", "green", solid, filled_circle, 1},
        {"paper, half kick", {{"rotation", "paper"}}, "dt", "vermilion", dotted, filled_circle, 1},
        {"paper, no kick",
         {{"rotation", "paper"}, {"start-kick", "off"}},
         "dt",
         "vermilion",
         dashed,
         filled_square,
         1},
        composed("rattle4", "orange", 4, 5),
        composed("rattle6", "violet", 6, 7),
    };
}

Values values_of(const std::string& knob, bool quick) {
    if (knob == "iterations") {
        return quick ? Values{"1", "5", "25", "100"}
                     : Values{"1", "2", "5", "10", "25", "50", "100", "250", "1000"};
    }
    if (knob == "tolerance")
        return quick ? Values{"1e-3", "1e-8"} : Values{"1e-2", "1e-4", "1e-6", "1e-8", "1e-10"};
    if (knob == "substeps") return quick ? Values{"1", "4"} : Values{"1", "2", "4", "8", "16", "32"};
    return quick ? Values{"1/60", "1/120", "1/240"}
                 : Values{"1/60", "1/120", "1/240", "1/480", "1/960", "1/1920", "1/3840"};
}

std::vector<Experiment> all_experiments(bool quick) {
    const auto seconds = [quick](const char* full, const char* short_run) {
        return std::pair<std::string, std::string>("seconds", quick ? short_run : full);
    };
    const OptionTexts::value_type convex{"friction-model", "paper"};
    std::vector<Method> standing = solvers(true);
    standing.push_back(substeps_of_few());
    std::vector<Method> parting = solvers(true);
    for (Method& method : parting) method.flies = method.name.ends_with("persistent");

    return {
        {"stack",
         "Stack: where the cubes come to rest",
         {{"preset", "default"}, {"jitter", "0.01"}, {"seed", "1"}, {"slop", "0"}, convex, seconds("10", "3")},
         rest_error,
         "distance from the exact place at rest, RMS [m]",
         "Five cubes, each up to a centimetre off the axis and turned, fall and should come to rest straight below "
         "where they started: the distance of their centres from there in the last second. Solved exactly it is "
         "zero, because every cube's centre of mass is above the one that carries it.",
         standing},
        {"intersecting-stack",
         "Intersecting stack: against the closed form",
         {{"preset", "default"}, {"slop", "0"}, convex, {"seconds", "0.5"}},
         parting_error,
         "distance from the closed form, RMS [m]",
         "Five cubes part for half a second: the distance of their centres from the closed form of the exactly "
         "solved steps, which for the persistent push is another one (they fly up) than for the single-frame push.",
         parting},
        {"funnel",
         "Funnel: constraint forces",
         {{"preset", "default"}, {"count", "20"}, convex, seconds("4", "3")},
         converged_error,
         "relative error of the constraint forces, median",
         "Twenty balls fall into a funnel, with the friction bound of the paper, whose problem is convex and has "
         "one "
         "answer: the constraint forces of a step against those of the same system solved to 1e-10 m/s, the median "
         "over thirty moments.",
         solvers(true)},
        {"pendulum-grid",
         "Pendulum grid: constraint forces",
         {{"preset", "default"}, convex, seconds("3", "2")},
         converged_error,
         "relative error of the constraint forces, median",
         "Spheres and boxes on a grid of pendulums, with the friction bound of the paper: the constraint forces of "
         "a step against those of the same "
         "system "
         "solved to 1e-10 m/s, the median over thirty moments.",
         solvers(false)},
        {"heavy-on-light",
         "Heavy on light: where the cubes stand",
         {{"preset", "default"}, {"mass-ratio", "1000"}, {"slop", "0"}, convex, seconds("10", "3")},
         rest_error,
         "distance from the exact place at rest, RMS [m]",
         "A cube of 1 t on one of 1 kg: the distance of their centres from where they must stand, in the last "
         "second. Solved exactly it is zero.",
         solvers(true)},
        {"brick_wall",
         "Wall: where the bricks stand",
         {{"preset", "default"}, seconds("2", "2")},
         standing_error,
         "distance from where it was built, RMS [m]",
         "A wall of twelve rows of bricks in bond stands where it was built: the distance of the centres from "
         "there in "
         "the last second. Sweeps of a whole step, against n small steps of one, two or four sweeps.",
         small_steps(quick)},
        {"chain",
         "Chain with a heavy end: constraint forces",
         {{"preset", "default"}, {"end-mass", "1000"}, {"substeps", "32"}, seconds("2", "0.5")},
         converged_error,
         "relative error of the constraint forces, median",
         "Twenty bars swing down with 1 t at their end: the constraint forces of a step against those of the same "
         "system solved to 1e-10 m/s, the median over thirty moments.",
         solvers(false)},
        {.scene = "pendulum-wave",
         .title = "Pendulum wave: against the exact motion",
         .common = {{"preset", "default"}, seconds("60", "5")},
         .error = scene_error,
         .error_axis = "error of the angle, RMS [degrees]",
         .caption = "Fifty pendulums against the exact motion of a ball on a bar (two angles): the error of the "
                    "angle over all "
                    "balls and steps. Grey: errors that shrink with a power of the step.",
         .methods = integrators(),
         .clock_seconds = 5.0},
        {.scene = "free_body",
         .title = "Free bodies: against the exact flight and rotation",
         .common = {{"preset", "default"}, {"seconds", "2"}},
         .error = free_error,
         .error_axis = "distance of the corners from the exact motion, RMS [m]",
         .caption =
             "A ball and a tumbling box with three different moments of inertia, thrown: the distance of the "
             "box's corners from the parabola and the closed form of Euler's equations. Half a kick makes the "
             "flight exact; what is left is the rotation. Nothing is solved, so the work is the moves.",
         .methods = free_motions(),
         .solves = false},
        {"sphere_column",
         "Column of spheres: against the weights",
         {{"preset", "default"}, {"push", "none"}, {"warm-start", "off"}, seconds("1", "0.5")},
         column_error,
         "relative error of the constraint forces in the first step",
         "Ten equal spheres one on the other: the constraint forces of the first step against the weights above "
         "each "
         "contact. Grey: the known contraction of Gauss-Seidel, cos^2(pi/2n) a sweep.",
         {{"pgs", {{"tolerance", "0"}, {"solver", "pgs"}}, "iterations", "blue", solid, filled_circle},
          {"nncg", {{"tolerance", "0"}, {"solver", "nncg"}}, "iterations", "green", solid, filled_circle},
          {"jacobi", {{"tolerance", "0"}, {"solver", "jacobi"}}, "iterations", "orange", solid, filled_circle},
          {"direct", {{"solver", "direct"}}, "tolerance", "violet", solid, diamond},
          {"auto", {{"solver", "auto"}}, "tolerance", "violet", dotted, filled_triangle}},
         column_contraction(10)},
    };
}

}  // namespace

std::vector<Experiment> error_experiments(bool quick) {
    std::vector<Experiment> sweeps = all_experiments(quick);
    for (Experiment& sweep : sweeps) {
        std::erase_if(sweep.methods, [](const Method& method) { return !available(method); });
        for (Method& method : sweep.methods) {
            if (method.values.empty()) method.values = values_of(method.knob, quick);
        }
    }
    return sweeps;
}

bool available(const Method& method) {
    Settings scratch;
    return std::all_of(method.differs.begin(), method.differs.end(), [&scratch](const auto& wanted) {
        for (const SimulationOption& option : simulation_options()) {
            if (option.name == wanted.first) return option.set(scratch, wanted.second);
        }
        return false;
    });
}

std::string differences(const Experiment& sweep, const Method& method) {
    std::string text;
    for (const OptionTexts* options : {&sweep.common, &method.differs}) {
        for (const auto& [name, value] : *options) {
            if (name == "preset" || name == "seconds") continue;
            text += (text.empty() ? "" : " ") + name + "=" + value;
        }
    }
    return text;
}

Choices run_at(const Experiment& sweep, const Method& method, const std::string& value) {
    OptionTexts options{{method.knob, value}};
    options.insert(options.end(), method.differs.begin(), method.differs.end());
    options.insert(options.end(), sweep.common.begin(), sweep.common.end());
    return run_of(sweep.scene, options);
}

double column_contraction(int balls) {
    return std::pow(std::cos(std::numbers::pi / (2.0 * balls)), 2);
}

}  // namespace pushfactor::demos::reports::error
