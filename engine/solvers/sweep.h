// Shared by the sweeping solvers: the sweep of paper section 7 and the iteration loop. Internal to the solvers.
#pragma once

#include "engine/solvers/solver.h"
#include "engine/solvers/unit_rows.h"

namespace pushfactor::engine::solvers {

// 7.1.1 row after row, each from the latest values of the others. Returns the largest change of a row's velocity
// [m/s].
//
// The rows of a block compute their errors from the same velocities and subtract, by u_i . u_k, the changes of the
// rows before them: equivalent to one row after the other. The two rows of a disc compute their forces before
// either moves, and then move together.
//
// With `give_way` a row keeps only a share of its force (Row::keeps): y <- clamp(keeps (y + t - u . x)).
//
// For some blocks; `bodies_of` returns the velocities of a block's bodies.
template <int columns, bool give_way = false, typename BodiesOf>
[[gnu::flatten]] double sweep(UnitRows<columns>& system, std::span<const typename UnitRows<columns>::Block> blocks,
                              const BodiesOf& bodies_of) {
    using Value = typename UnitRows<columns>::Value;
    using Block = typename UnitRows<columns>::Block;
    Value largest{};
    system.for_each_block(blocks, [&](const Block& block, auto count, auto disc) {
        auto* row = system.rows_of(block);
        Velocity x[columns];
        unrolled<columns>([&](auto c) { x[c] = bodies_of(block, c); });
        Value wanted[count], changes[count];
        unrolled<count>([&](auto i) { wanted[i] = Lanes<columns>::of(row[i].y) + system.error(row[i], x); });
        if constexpr (disc == UnitRows<columns>::soft_row) {
            wanted[0] -= row[0].soft * Lanes<columns>::of(row[0].y);
        }
        const auto move = [&](auto i, Value moved) {
            changes[i] = moved - Lanes<columns>::of(row[i].y);
            Lanes<columns>::write(moved, row[i].y);
            largest = larger(largest, row[i].scale * magnitude(changes[i]));
        };
        const auto take_off = [&](auto i, auto k) { wanted[i] -= block.couplings[i + k - 1] * changes[k]; };
        unrolled<count>([&](auto i) {
            if constexpr (disc >= 0 && i == disc + 1) {
                constexpr std::integral_constant<int, i - 1> first;
                unrolled<first>([&](auto k) { take_off(i, k); });
                system.put_in_disc(row[i], wanted[first], wanted[i]);
                move(first, wanted[first]);
                move(i, wanted[i]);
            } else {
                unrolled<i>([&](auto k) { take_off(i, k); });
                if constexpr (give_way) wanted[i] *= row[i].keeps;
                if constexpr (disc < 0 || i != disc) move(i, system.clamped(row[i], wanted[i]));
            }
        });
        system.template push<count>(block, changes, x);
    });
    return Lanes<columns>::largest(largest);
}

template <int columns>
double sweep(UnitRows<columns>& system) {
    using Block = typename UnitRows<columns>::Block;
    system.couple();
    return sweep(system, system.blocks,
                 [&](const Block& block, std::size_t c) { return system.at_bodies(block, c); });
}

// Repeats `pass`, which reads and writes every row once and returns the largest change of a row's velocity [m/s],
// until the residual is at most the lower tolerance or the iterations are used up; with zero tolerances, all of
// them. Returns whether the tolerance was reached.
template <int columns, typename Pass>
bool work_down(UnitRows<columns>& rows, const Termination& termination, SolveCount& count, Pass pass) {
    const bool checked = termination.tolerance_high > 0.0;
    for (int k = 0; k < termination.iterations; ++k) {
        ++count.iterations;
        count.multiply_adds += rows.pass_work();
        const double change = pass(rows);
        // The change is no bound on the residual, but while it is large the residual need not be computed.
        if (!checked || change > termination.tolerance_low) continue;
        count.multiply_adds += rows.look_work();
        if (rows.residual() <= termination.tolerance_low) return true;
    }
    return false;
}

// A whole solve by such passes.
template <int columns, typename Pass>
SolveCount iterate(UnitRows<columns>& rows, const SystemEquation& system, const Island& island,
                   const Termination& termination, Columns& lambda, Pass pass) {
    SolveCount count;
    rows.load(system, island, lambda);
    work_down(rows, termination, count, pass);
    rows.store(system, island, lambda);
    return count;
}

}  // namespace pushfactor::engine::solvers
