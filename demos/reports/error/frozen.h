// A frozen problem: the system equation of one step as a solver gets it, without the scene. As a JSON file other
// programs can solve it too:
//
//   {
//     "version": 1,
//     "name": "stack of 5, landing",
//     "dt_s": 0.01666,
//     "bodies": [                      one per body, static ones with zeros
//       {
//         "inverse_mass_per_kg": 0.83,
//         "inverse_inertia_per_kg_m2": [9 numbers],       world frame, row by row
//         "inverse_inertia_root": [9 numbers],            W with W W^T = the line above
//         "free_acceleration": [6 numbers]                v1/dt + M^-1 f_ext, m/s^2 and rad/s^2
//       }, ...
//     ],
//     "rows": [                        J, one per constraint row
//       {
//         "body_a": 0, "body_b": 1,    indices into bodies
//         "j_a": [6 numbers], "j_b": [6 numbers],         linear part [1], angular part [m], world frame
//         "c_min_n": 0, "c_max_n": null,                  null: no bound; forces, or with of_row factors
//         "of_row": 3,                 only where the bounds are factors of that row's lambda
//         "disc": "first",             then "second": c_max bounds the length of both rows' lambda
//         "in_momenta": false,         only where lambda of the last column is zero
//         "b_m_per_s2": [one number per column],          right side of A lambda = b, A = J M^-1 J^T
//         "guess_n": [one number per column]              warm start
//       }, ...
//     ]
//   }
//
// Find lambda [N], column by column: A lambda - b is zero between the bounds, >= 0 at c_min and <= 0 at c_max.
//
// And such problems at hard moments of scenes, with the convergence of each solver on them, without the effect of
// its errors on the run.
#pragma once

#include "demos/options/named_run.h"
#include "demos/pages/table.h"
#include "demos/reports/error/work_plot.h"
#include "demos/reports/study.h"
#include "engine/system/system_equation.h"

#include <string>
#include <vector>

namespace pushfactor::engine {
class World;
}

namespace pushfactor::demos::reports::error {

inline constexpr int frozen_version = 1;  // of the format

class FrozenProblem {
  public:
    // The system of the world's last step.
    FrozenProblem(std::string name, const engine::World& world);

    // Such a system. Its `diagonal` and `digests` are computed here, and its rows are `rows`.
    FrozenProblem(std::string name, std::vector<engine::ConstraintRow> rows, engine::SystemEquation system,
                  engine::Columns guess);

    FrozenProblem(FrozenProblem&& other) noexcept = default;  // rows stay where they are

    const std::string& name() const { return name_; }
    const engine::SystemEquation& system() const { return system_; }
    const engine::Columns& guess() const { return guess_; }  // N, rows x columns
    engine::Columns zero() const { return engine::Columns::Zero(guess_.rows(), guess_.cols()); }

    std::string text() const;

  private:
    std::string name_;
    std::vector<engine::ConstraintRow> rows_;
    engine::SystemEquation system_;  // its rows are rows_
    engine::Columns guess_;
};

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

// Runs the scene up to the moment and freezes its system.
FrozenProblem freeze(const FrozenMoment& moment, const StopCheck& check);
FrozenProblem freeze(const std::string& name, const Choices& choices, const StopCheck& check);

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
