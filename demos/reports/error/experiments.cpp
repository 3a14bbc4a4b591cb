#include "demos/reports/error/error.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <numbers>
#include <sstream>

namespace pushfactor::demos::reports::error {

namespace {

using Values = std::vector<std::string>;
using Methods = std::vector<Method>;

constexpr int filled_circle = 7, filled_square = 5, filled_triangle = 9, diamond = 13;
constexpr int solid = 1, dashed = 2, dotted = 3;

Values words_of(const std::string& text) {
    std::istringstream stream(text);
    return {std::istream_iterator<std::string>(stream), {}};
}

Methods operator+(Methods all, const Methods& more) {
    all.insert(all.end(), more.begin(), more.end());
    return all;
}

// Iterative solvers run all iterations (tolerance 0); exact ones are varied over the tolerance.
const Methods exact_solvers{{"direct", "solver=direct", "tolerance", "violet", solid, diamond},
                            {"auto", "solver=auto", "tolerance", "violet", dotted, filled_triangle}};
const Methods cold_solvers = Methods{{"pgs", "tolerance=0 solver=pgs", "iterations", "blue"},
                                     {"nncg", "tolerance=0 solver=nncg", "iterations", "green"},
                                     {"jacobi", "tolerance=0 solver=jacobi", "iterations", "orange"}} +
                             exact_solvers;

// The iterative ones with and without warm start.
Methods solvers(bool push_matters) {
    Methods methods;
    const auto add = [&methods](const std::string& name, const std::string& more, const std::string& differs,
                                const char* colour) {
        const std::string both = "tolerance=0 " + differs;
        methods.push_back({name + ", warm" + more, both, "iterations", colour});
        methods.push_back(
            {name + ", cold" + more, both + " warm-start=off", "iterations", colour, dashed, filled_square});
    };
    add("pgs", "", "solver=pgs", "blue");
    add("nncg", "", "solver=nncg", "green");
    add("jacobi", "", "solver=jacobi", "orange");
    if (push_matters) add("pgs", ", persistent", "solver=pgs push=persistent", "vermilion");
    return methods + exact_solvers;
}

// Small steps with 1, 2 or 4 sweeps each.
Methods small_steps(bool quick) {
    Methods methods;
    for (const auto& [sweeps, colour] :
         {std::pair{"1", "orange"}, std::pair{"2", "green"}, std::pair{"4", "violet"}}) {
        methods.push_back({fmt::format("small steps of {}", sweeps), "tolerance=0 solver=pgs scheme=small-steps",
                           "small-steps", colour, solid, filled_triangle});
        for (const std::string& steps : words_of(quick ? "2 4 8" : "2 4 8 16 32 64"))
            methods.back().values.push_back(steps + "x" + sweeps);
    }
    return methods;
}

// Sweeps of whole steps and small steps.
Methods of_the_wall(bool quick) {
    return Methods{{"whole step, from the last forces", "tolerance=0 solver=pgs", "iterations", "blue"},
                   {"whole step, no push", "tolerance=0 solver=pgs push=none", "iterations", "blue", dashed,
                    filled_square}} +
           small_steps(quick) + Methods{{"auto", "solver=auto", "tolerance", "vermilion", dotted, filled_triangle}};
}

const Methods integrators{
    {"beta 0.2, no kick", "distance-beta=0.2 start-kick=off", "dt", "vermilion", dashed, filled_square, 1},
    {"beta 1, no kick", "start-kick=off", "dt", "vermilion", solid, filled_circle, 1},
    {"beta 1, half kick", "", "dt", "blue", solid, filled_circle, 2},
    {"single-frame, half kick", "distance-push=single-frame", "dt", "blue", dashed, filled_square, 1},
    {"rattle", "scheme=rattle", "dt", "green", solid, filled_triangle, 2},
    {"rattle4", "scheme=rattle4", "dt", "orange", solid, filled_triangle, 4},
    {"rattle6", "scheme=rattle6", "dt", "violet", solid, filled_triangle, 6}};

// For bodies without contacts. rattle would equal the half kick.
const Methods free_motions{
    {"splitting, no kick", "start-kick=off", "dt", "blue", dashed, filled_square, 1},
    {"splitting, half kick", "", "dt", "blue", solid, filled_circle, 2},
    {"exponential, half kick", "rotation=exponential", "dt", "green", solid, filled_circle, 1},
    {"paper, half kick", "rotation=paper", "dt", "vermilion", dotted, filled_circle, 1},
    {"paper, no kick", "rotation=paper start-kick=off", "dt", "vermilion", dashed, filled_square, 1},
    {"rattle4", "scheme=rattle4 start-kick=off", "dt", "orange", solid, filled_triangle, 4, 5},
    {"rattle6", "scheme=rattle6 start-kick=off", "dt", "violet", solid, filled_triangle, 6, 7}};

Values values_of(const std::string& knob, bool quick) {
    if (knob == "iterations") return words_of(quick ? "1 5 25 100" : "1 2 5 10 25 50 100 250 1000");
    if (knob == "tolerance") return words_of(quick ? "1e-3 1e-8" : "1e-2 1e-4 1e-6 1e-8 1e-10");
    if (knob == "substeps") return words_of(quick ? "1 4" : "1 2 4 8 16 32");
    return words_of(quick ? "1/60 1/120 1/240" : "1/60 1/120 1/240 1/480 1/960 1/1920 1/3840");
}

}  // namespace

OptionTexts options(const std::string& text) {
    OptionTexts all;
    for (const std::string& word : words_of(text)) {
        const auto sign = word.find('=');
        all.emplace_back(word.substr(0, sign), word.substr(sign + 1));
    }
    return all;
}

std::vector<Experiment> error_experiments(bool quick) {
    Methods standing = solvers(true), parting = solvers(true);
    standing.push_back({"pgs, warm, 4 a substep", "solver=pgs iterations=4 tolerance=0", "substeps", "blue", dotted,
                        filled_triangle});
    for (Method& each : parting) each.flies = each.name.ends_with("persistent");

    std::vector<Experiment> all;
    // `full` and `short_run`: seconds of the run and of the quick run.
    const auto add = [&](const char* scene, const char* title, const std::string& common, const char* full,
                         const char* short_run, MakeTrueError error, const char* error_axis, const char* caption,
                         Methods methods) -> Experiment& {
        for (Method& each : methods) {
            if (each.values.empty()) each.values = values_of(each.knob, quick);
        }
        all.push_back({scene, scene, title, common, quick ? short_run : full, std::move(error), error_axis, caption,
                       std::move(methods)});
        if (quick) all.back().timed_runs = 2;
        return all.back();
    };
    const char* const from_rest = "distance from the exact place at rest, RMS [m]";
    const char* const of_forces = "relative error of the constraint forces, median";
    add("stack", "Stack: where the cubes come to rest", "jitter=0.01 seed=1 slop=0 friction-model=paper", "10", "3",
        rest_error, from_rest,
        "Five cubes, each up to a centimetre off the axis and turned, fall and should come to rest straight below "
        "where they started: the distance of their centres from there in the last second. Solved exactly it is "
        "zero, because every cube's centre of mass is above the one that carries it.",
        standing);
    add("intersecting-stack", "Intersecting stack: against the closed form", "slop=0 friction-model=paper", "0.5",
        "0.5", parting_error, "distance from the closed form, RMS [m]",
        "Five cubes part for half a second: the distance of their centres from the closed form of the exactly "
        "solved steps, which for the persistent push (they fly up) differs from that for the single-frame push.",
        parting);
    add("funnel", "Funnel: constraint forces", "count=20 friction-model=paper", "4", "3", converged_error,
        of_forces,
        "Twenty balls fall into a funnel, with the friction bound of the paper, whose problem is convex and has "
        "one answer: the constraint forces of a step against those of the same system solved to 1e-10 m/s, the "
        "median over thirty moments.",
        solvers(true));
    add("pendulum-grid", "Pendulum grid: constraint forces", "friction-model=paper substeps=1", "3", "2",
        converged_error, of_forces,
        "Spheres and boxes on a grid of pendulums, with the friction bound of the paper: the constraint forces of "
        "a step against those of the same system solved to 1e-10 m/s, the median over thirty moments.",
        solvers(false));
    add("heavy-on-light", "Heavy on light: where the cubes stand", "mass-ratio=1000 slop=0 friction-model=paper",
        "10", "3", rest_error, from_rest,
        "A cube of 1 t on one of 1 kg: the distance of their centres from where they must stand, in the last "
        "second. Solved exactly it is zero.",
        solvers(true));
    add("brick_wall", "Wall: where the bricks stand", "", "2", "1", standing_error,
        "distance from where it was built, RMS [m]",
        "A wall of twelve rows of bricks in bond stands where it was built: the distance of the centres from there "
        "in the last second. Sweeps of a whole step, against n small steps of one, two or four sweeps.",
        of_the_wall(quick));
    add("chain", "Chain with a heavy end: constraint forces", "end-mass=1000 substeps=32", "2", "0.5",
        converged_error, of_forces,
        "Twenty bars swing down with 1 t at their end: the constraint forces of a step against those of the same "
        "system solved to 1e-10 m/s, the median over thirty moments.",
        solvers(false));
    add("chain", "Chain with a heavy end: against the exact motion", "end-mass=1000 substeps=1", "2", "0.5",
        chain_error, "distance of the balls from the exact motion, RMS [m]",
        "The same chain under steps of different length, against the exact motion of balls on massless bars: the "
        "distance of their centres over all balls and steps. Between the bars the balls swing sideways some fifty "
        "times a second, which steps have to resolve. Grey: errors that shrink with a power of the step.",
        integrators)
        .name = "chain_motion";
    add("pile_of_cubes", "Pile: overlap of falling cubes", "slop=0", "3", "1", overlap_error,
        "deepest overlap, median of the steps [m]",
        "Forty cubes, turned at random, fall and come to rest: how far the two of a step overlap that do so most, "
        "the median of the steps. Exact contacts do not overlap.",
        solvers(false) + small_steps(quick));
    add("pendulum-wave", "Pendulum wave: against the exact motion", "substeps=1", "60", "2", scene_error,
        "error of the angle, RMS [degrees]",
        "Fifty pendulums against the exact motion of a ball on a bar (two angles): the error of the angle over all "
        "balls and steps. Grey: errors that shrink with a power of the step.",
        integrators)
        .clock_seconds = 5.0;
    add("free_body", "Free bodies: against the exact flight and rotation", "", "2", "2", free_error,
        "distance of the corners from the exact motion, RMS [m]",
        "A ball and a tumbling box with three different moments of inertia, thrown: the distance of the box's "
        "corners from the parabola and the closed form of Euler's equations. Half a kick makes the flight exact; "
        "what is left is the rotation. Nothing is solved, so the work is the moves.",
        free_motions)
        .solves = false;
    add("sphere_column", "Column of spheres: against the weights", "push=none warm-start=off", "1", "0.5",
        column_error, "relative error of the constraint forces in the first step",
        "Ten equal spheres one on the other: the constraint forces of the first step against the weights above "
        "each contact. Grey: the known contraction of Gauss-Seidel, cos^2(pi/2n) per sweep.",
        cold_solvers)
        .contraction = column_contraction(10);
    return all;
}

OptionTexts options_at(const Experiment& sweep, const Method& method, const std::string& value) {
    return options(fmt::format("{}={} {} preset=default {} seconds={}", method.knob, value, method.differs,
                               sweep.common, sweep.seconds));
}

Choices run_at(const Experiment& sweep, const Method& method, const std::string& value) {
    return run_of(sweep.scene, options_at(sweep, method, value));
}

double column_contraction(int balls) {
    return std::pow(std::cos(std::numbers::pi / (2.0 * balls)), 2);
}

}  // namespace pushfactor::demos::reports::error
