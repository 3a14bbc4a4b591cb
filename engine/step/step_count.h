// Statistics of one step.
#pragma once

#include "engine/constraints/constraint_row.h"

#include <array>
#include <cstddef>
#include <numeric>

namespace pushfactor::engine {

struct StepCount {
    std::array<int, row_kind_count> rows_of_kind{};  // by RowKind
    int columns = 0;                 // 2 if any row has a single-frame correction, 1 otherwise, 0 without rows
    int islands = 0;                 // groups of bodies connected by rows
    int islands_kept = 0;            // whose last forces were accurate enough
    int islands_swept = 0;           // solved by sweeps or other iterations
    int islands_exact = 0;           // solved to rounding
    int islands_in_small_steps = 0;  // whose step was divided into small ones
    int islands_unsolved = 0;        // solved ones with a residual above the upper tolerance
    double unsolved_residual = 0.0;  // m/s, the largest of these
    int islands_contradicting = 0;   // with rows that no forces can satisfy together, as found by an exact method
    int sweeps = 0;                  // iterations of the solver, on the island with the most of them
    double row_updates = 0.0;        // rows times columns times iterations, of all islands
    double multiply_adds = 0.0;      // of the solver
    int impacts = 0;                 // within the step (impacts.h)
    bool impacts_cut_short = false;  // there would have been more than are followed
    int at_rest = 0;                 // bodies, after the step (rest.h)

    int rows() const { return std::accumulate(rows_of_kind.begin(), rows_of_kind.end(), 0); }
    int rows(RowKind kind) const { return rows_of_kind[static_cast<std::size_t>(kind)]; }
};

}  // namespace pushfactor::engine
