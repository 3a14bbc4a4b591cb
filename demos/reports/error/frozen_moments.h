// Frozen problems at hard moments of scenes, and the convergence of each solver on them, without the effect of its
// errors on the run.
#pragma once

#include "demos/options/choices.h"
#include "demos/options/named_run.h"
#include "demos/pages/table.h"
#include "demos/reports/error/frozen_problem.h"
#include "demos/reports/error/work_plot.h"

#include <functional>
#include <string>
#include <vector>

namespace pushfactor::demos::reports::error {

struct FrozenMoment {
    std::string name;     // "stack of 5, landing"
    std::string scene;    // of the catalogue or of assets/scenes
    OptionTexts options;  // "seconds" is the moment
};

std::vector<FrozenMoment> hard_moments(bool quick);

// Moments of contacts with Coulomb's friction and nothing else, which is what collections of contact problems have.
struct ContactMoment {
    std::string name;  // a file name: "wall_3_at_0.5s"
    Choices choices;   // `settings.seconds` is the moment
};

// Stacks, heaps, walls, houses of cards and arches, ten each: five members at two moments; of each kind one with
// `quick`.
std::vector<ContactMoment> contact_moments(bool quick);

// Runs the scene up to the moment and freezes its system. `check` is called at each step; its exceptions end the
// run.
FrozenProblem freeze(const FrozenMoment& moment, const std::function<void()>& check);
FrozenProblem freeze(const std::string& name, const Choices& choices, const std::function<void()>& check);

struct FrozenPoint {
    std::string problem, method;
    int iterations = 0;
    double residual = 0.0;       // m/s, natural map
    double multiply_adds = 0.0;  // of the solve
};

// Results of every solver, cold and warm, over iterations. `dense` is left out above 200 rows: it gives the same as
// `pgs` at cubic cost.
std::vector<FrozenPoint> solve_frozen(const FrozenProblem& problem, bool quick);

Table table_of(const std::vector<FrozenPoint>& points);  // frozen.csv

// Lines of the plot of one problem: all but `dense`, whose work would compress the others.
std::vector<WorkLine> lines_of(const std::vector<FrozenPoint>& points);

}  // namespace pushfactor::demos::reports::error
