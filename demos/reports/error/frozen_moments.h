// Frozen problems at hard moments of scenes, and the convergence of each solver on them, without the effect of its
// errors on the run.
#pragma once

#include "demos/options/named_run.h"
#include "demos/pages/table.h"
#include "demos/reports/error/frozen_problem.h"
#include "demos/reports/error/work_plot.h"
#include "demos/reports/pieces/piece.h"

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

inline const std::vector<std::string> frozen_columns{"problem", "method", "iterations", "residual_m_per_s",
                                                     "work_multiply_adds"};

// Results of every solver, cold and warm, over iterations, as lines of frozen.csv. `dense` is left out above 200
// rows: it gives the same as `pgs` at cubic cost.
Table solve_frozen(const FrozenProblem& problem, bool quick);

// The moments as pieces. A result has the number of "rows" and "columns" of the system, and the "lines" of
// solve_frozen().
std::string key_of(const FrozenMoment& moment, bool quick);
Pieces frozen_pieces(const std::vector<FrozenMoment>& moments, bool quick);

// Lines of the plot of one problem: all but `dense`, whose work would compress the others.
std::vector<WorkLine> lines_of(const std::vector<std::vector<std::string>>& lines);

}  // namespace pushfactor::demos::reports::error
