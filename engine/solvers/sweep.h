// What the sweeping solvers share: the sweep of paper section 7 and the loop around one of theirs. An inner matter
// of the solvers.
#pragma once

#include "engine/solvers/solver.h"
#include "engine/solvers/unit_rows.h"

namespace pushfactor::engine::solvers {

// 7.1.1 row after row, each from the newest values of the others. Returns the largest change of a row's velocity
// [m/s].
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

// 6.2.3 for an iteration `pass` that reads and writes every row once and returns the largest change of a row's
// velocity [m/s].
template <int columns, typename Pass>
SolveCount iterate(UnitRows<columns>& rows, const SystemEquation& system, const Termination& termination,
                   Columns& lambda, Pass pass) {
    const bool checked = termination.tolerance_high > 0.0;
    rows.load(system, lambda);
    SolveCount count;
    if (checked) {
        count.multiply_adds += rows.look_work();
        if (rows.residual() <= termination.tolerance_high) return count;
    }
    while (count.iterations < termination.iterations) {
        ++count.iterations;
        count.multiply_adds += rows.pass_work();
        const double change = pass(rows);
        // The change bounds nothing, but while it is large the residual need not be looked at.
        if (!checked || change > termination.tolerance_low) continue;
        count.multiply_adds += rows.look_work();
        if (rows.residual() <= termination.tolerance_low) break;
    }
    rows.store(system, lambda);
    return count;
}

}  // namespace pushfactor::engine::solvers
