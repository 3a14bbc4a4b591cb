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
// With `give_way` a row keeps only a share of its force (UnitRow::keeps): y <- clamp(keeps (y + t - u . x)).
//
// For some blocks; `bodies_of` returns the velocities of a block's bodies.
template <bool give_way = false, typename BodiesOf>
[[gnu::flatten]] double sweep(UnitRows& system, std::span<const UnitRows::Block> blocks,
                              const BodiesOf& bodies_of) {
    double largest = 0.0;
    system.for_each_block(blocks, [&](const UnitRows::Block& block, auto count, auto disc) {
        UnitRow* row = system.rows_of(block);
        const Velocity x = bodies_of(block);
        double wanted[count], changes[count];
        unrolled<count>([&](auto i) { wanted[i] = row[i].y + system.error(row[i], x); });
        if constexpr (disc == UnitRows::soft_row) wanted[0] -= row[0].soft * row[0].y;
        const auto move = [&](auto i, double moved) {
            changes[i] = moved - row[i].y;
            row[i].y = moved;
            largest = std::max(largest, row[i].scale * std::abs(changes[i]));
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
        system.push<count>(block, changes, x);
    });
    return largest;
}

// All blocks.
inline double sweep(UnitRows& rows) {
    return sweep(rows, rows.blocks, [&](const UnitRows::Block& block) { return rows.at_bodies(block); });
}

// Repeats `pass`, which reads and writes every row once and returns the largest change of a row's velocity [m/s],
// until the residual is at most the lower tolerance or the iterations are used up; with zero tolerances, all of
// them.
template <typename Pass>
SolveCount work_down(UnitRows& rows, const Termination& termination, const Pass& pass) {
    const bool checked = termination.tolerance_high > 0.0;
    SolveCount count;
    for (int k = 0; k < termination.iterations; ++k) {
        ++count.iterations;
        count.multiply_adds += rows.pass_work();
        const double change = pass(rows);
        // The change is no bound on the residual, but while it is large the residual need not be computed.
        if (!checked || change > termination.tolerance_low) continue;
        count.multiply_adds += rows.look_work();
        if (rows.residual() <= termination.tolerance_low) break;
    }
    return count;
}

// Solves the columns of an island, one after the other, by `solve(rows)`, which returns its count.
template <typename Solve>
SolveCount by_columns(UnitRows& rows, const SystemEquation& system, const Island& island, Columns& lambda,
                      const Solve& solve) {
    SolveCount all{.exact = true};
    rows.load(system, island);
    for (int column = 0; column < island.columns; ++column) {
        rows.take(system, island, lambda, column);
        all.add(solve(rows));
        rows.store(system, island, column, lambda);
    }
    return all;
}

// A whole solve by passes (work_down).
template <typename Pass>
SolveCount iterate(UnitRows& rows, const SystemEquation& system, const Island& island,
                   const Termination& termination, Columns& lambda, const Pass& pass) {
    return by_columns(rows, system, island, lambda,
                      [&](UnitRows& loaded) { return work_down(loaded, termination, pass); });
}

}  // namespace pushfactor::engine::solvers
