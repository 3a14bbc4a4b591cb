// What the sweeping solvers share: the sweep of paper section 7 and the loop around one of theirs. An inner matter
// of the solvers.
#pragma once

#include "engine/solvers/solver.h"
#include "engine/solvers/unit_rows.h"

namespace pushfactor::engine::solvers {

// 7.1.1 for the rows of one block: the errors of all of them from the same velocities, and what the rows before it
// have changed taken off by u_i . u_j, which is the same as one row after the other. Returns the largest change of
// a row's velocity [m/s].
template <int columns, int count>
void sweep_block(UnitRows<columns>& system, const typename UnitRows<columns>::Block& block,
                 typename UnitRows<columns>::Value& largest) {
    using Value = typename UnitRows<columns>::Value;
    auto* rows = &system.rows[block.begin];
    TwoBodies x[columns];
    system.read(block, x);
    Value wanted[count], changes[count];
    unrolled<count>([&](auto i) { wanted[i] = Lanes<columns>::of(rows[i].y) + system.error(rows[i], x); });
    unrolled<count>([&](auto i) {
        unrolled<i>([&](auto k) { wanted[i] -= block.couplings[i + k - 1] * changes[k]; });
        const Value y = Lanes<columns>::of(rows[i].y);
        const Value moved = system.clamped(rows[i], wanted[i]);
        Lanes<columns>::write(moved, rows[i].y);
        changes[i] = moved - y;
        largest = larger(largest, rows[i].scale * magnitude(changes[i]));
    });
    unrolled<count>([&](auto i) {
        unrolled<columns>([&](auto c) { x[c].add(*rows[i].unit, Lanes<columns>::in(changes[i], c)); });
    });
    system.write(block, x);
}

// 7.1.1 row after row, each from the newest values of the others. Returns the largest change of a row's velocity
// [m/s].
template <int columns>
double sweep(UnitRows<columns>& system) {
    typename UnitRows<columns>::Value largest{};
    system.couple();
    for (const auto& block : system.blocks) {
        switch (block.end - block.begin) {
            case 1:
                sweep_block<columns, 1>(system, block, largest);
                break;
            case 2:
                sweep_block<columns, 2>(system, block, largest);
                break;
            default:
                sweep_block<columns, 3>(system, block, largest);
        }
    }
    return Lanes<columns>::largest(largest);
}

// Whether the guess is good enough to be kept (6.2.3).
template <int columns>
bool keeps_guess(const UnitRows<columns>& rows, const Termination& termination, SolveCount& count) {
    if (termination.tolerance_high <= 0.0) return false;
    count.multiply_adds += rows.look_work();
    return rows.residual() <= termination.tolerance_high;
}

// Repeats `pass`, which reads and writes every row once and returns the largest change of a row's velocity [m/s],
// until the residual is at most the lower tolerance or the iterations are used up; all of them when tolerances are
// zero. Returns whether the residual got there.
template <int columns, typename Pass>
bool work_down(UnitRows<columns>& rows, const Termination& termination, SolveCount& count, Pass pass) {
    const bool checked = termination.tolerance_high > 0.0;
    for (int k = 0; k < termination.iterations; ++k) {
        ++count.iterations;
        count.multiply_adds += rows.pass_work();
        const double change = pass(rows);
        // The change bounds nothing, but while it is large the residual need not be looked at.
        if (!checked || change > termination.tolerance_low) continue;
        count.multiply_adds += rows.look_work();
        if (rows.residual() <= termination.tolerance_low) return true;
    }
    return false;
}

// A whole solve by such passes.
template <int columns, typename Pass>
SolveCount iterate(UnitRows<columns>& rows, const SystemEquation& system, const Termination& termination,
                   Columns& lambda, Pass pass) {
    SolveCount count;
    rows.load(system, lambda);
    if (keeps_guess(rows, termination, count)) return count;
    work_down(rows, termination, count, pass);
    rows.store(system, lambda);
    return count;
}

}  // namespace pushfactor::engine::solvers
