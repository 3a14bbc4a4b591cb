// Sweeps of projected Gauss-Seidel over rows of unit length, paper 7.1.1: what several solvers do.
#pragma once

#include "engine/solvers/solver.h"
#include "engine/solvers/unit_rows.h"

namespace pushfactor::engine::solvers {

// One iteration over all rows in both columns. Returns the largest change of a row's velocity [m/s].
template <int columns>
double sweep(UnitRows<columns>& system) {
    double largest = 0.0;
    for (auto& row : system.rows) {
        for (int c = 0; c < columns; ++c) {
            const double y = row.y[system.at(c)] + system.error(row, c);
            const double change = system.set(row, c, system.clamped(row, c, y));
            largest = std::max(largest, row.scale * std::abs(change));
        }
    }
    return largest;
}

// Sweeps until the residual is at most the lower tolerance or the iterations are used up; all of them when
// tolerances are zero. Returns whether the residual got there.
template <int columns>
bool sweep_until(UnitRows<columns>& rows, const Termination& termination, SolveCount& count) {
    const bool checked = termination.tolerance_high > 0.0;
    for (int k = 0; k < termination.iterations; ++k) {
        ++count.iterations;
        count.multiply_adds += rows.pass_work();
        const double change = sweep(rows);
        // The change bounds nothing, but while it is large the residual need not be looked at.
        if (!checked || change > termination.tolerance_low) continue;
        count.multiply_adds += rows.look_work();
        if (rows.residual() <= termination.tolerance_low) return true;
    }
    return false;
}

// Whether the guess is good enough to be kept (6.2.3).
template <int columns>
bool keeps_guess(const UnitRows<columns>& rows, const Termination& termination, SolveCount& count) {
    if (termination.tolerance_high <= 0.0) return false;
    count.multiply_adds += rows.look_work();
    return rows.residual() <= termination.tolerance_high;
}

}  // namespace pushfactor::engine::solvers
