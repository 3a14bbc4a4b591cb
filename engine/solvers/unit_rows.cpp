#include "engine/solvers/unit_rows.h"

#include <cassert>

namespace pushfactor::engine::solvers {

void UnitRows::load(const SystemEquation& system, const Island& island) {
    begin(island);
    rows.resize(static_cast<std::size_t>(island.rows));
    for (const RowRun& run : island.runs) {
        load_run(system, island, run);
        add_blocks(system, run, blocks);
    }
    couple(blocks);
}

void UnitRows::take(const SystemEquation& system, const Island& island, const Columns& guess, Eigen::Index column) {
    for (const RowRun& run : island.runs) take_run(system, run, guess, column, system.dt);
    follow();
}

void UnitRows::begin(const Island& island) {
    const std::size_t least = std::max(rows.size(), static_cast<std::size_t>(island.rows));
    rows.resize(least);  // a vector that grows again fills what it adds
    units_.resize(std::max(units_.size(), least));
    velocity.resize(static_cast<std::size_t>(island.body_count));
    movable = island.movable();
    has_soft_ = island.has(RowDigest::soft);
    blocks.clear();
}

void UnitRows::load_run(const SystemEquation& system, const Island& island, const RowRun& run) {
    assert(run.a != run.b);
    for (int j = run.begin, number = run.first; j < run.end; ++j, ++number) {
        const ConstraintRow& source = system.rows[static_cast<std::size_t>(j)];
        Jacobian& unit = units_[static_cast<std::size_t>(number)];
        UnitRow& row = rows[static_cast<std::size_t>(number)];
        row = {.unit = &unit, .a = run.a, .b = run.b, .disc = source.bounds.disc};
        row.scale = std::sqrt(system.diagonal[j]);
        unit = unit_axis(system, source, row.scale);
        if (has_soft_ && source.softness > 0.0) row.soft = source.softness / system.diagonal[j];
        const int leader = source.bounds.of_row;
        if (leader >= 0) {
            row.leader = leader >= run.begin ? run.first + leader - run.begin : island.number_of(leader);
        }
    }
}

void UnitRows::take_run(const SystemEquation& system, const RowRun& run, const Columns& guess, Eigen::Index column,
                        double dt) {
    for (int j = run.begin, number = run.first; j < run.end; ++j, ++number) {
        UnitRow& row = rows[static_cast<std::size_t>(number)];
        if (!(row.scale > 0.0)) continue;
        const Bounds& bounds = system.rows[static_cast<std::size_t>(j)].bounds;
        double bound_scale = dt * row.scale;
        if (row.leader >= 0) {
            const double scale = rows[static_cast<std::size_t>(row.leader)].scale;
            bound_scale = row.scale / (scale > 0.0 ? scale : 1.0);  // its y is 0 if its scale is
        }
        const bool is_zero = column > 0 && !bounds.in_momenta;
        row.low = is_zero ? 0.0 : bounds.c_min * bound_scale;
        row.high = is_zero ? 0.0 : bounds.c_max * bound_scale;
        row.t = system.b(j, column) * (dt * (1.0 / row.scale));
        row.y = guess(j, column) * (dt * row.scale);
    }
}

void UnitRows::replace(const SystemEquation& system, const ConstraintRow& source, std::size_t number, double dt) {
    UnitRow& row = rows[number];
    const double diagonal = diagonal_of(system, source);
    row.scale = std::sqrt(diagonal);
    units_[number] = unit_axis(system, source, row.scale);
    if (source.softness > 0.0) row.soft = source.softness / diagonal;
    row.low = source.bounds.c_min * dt * row.scale;
    row.high = source.bounds.c_max * dt * row.scale;
}

void UnitRows::store(const SystemEquation& system, const Island& island, Eigen::Index column,
                     Columns& lambda) const {
    const Eigen::Index last = island.columns == 1 ? lambda.cols() - 1 : column;
    auto row = rows.begin();
    for (const RowRun& run : island.runs) {
        for (int j = run.begin; j < run.end; ++j, ++row) {
            lambda(j, column) = row->scale > 0.0 ? row->y / (system.dt * row->scale) : 0.0;
            // Clamp again: scaling back may exceed the bounds by rounding.
            clamp_force(system.rows, j, column, lambda);
            lambda(j, last) = lambda(j, column);
            if (row->disc == Disc::second) lambda(j - 1, last) = lambda(j - 1, column);
        }
    }
}

void UnitRows::add_blocks(const SystemEquation& system, const RowRun& run, std::vector<Block>& to) {
    for (int j = run.begin; j < run.end; ++j) {
        const ConstraintRow& row = system.rows[static_cast<std::size_t>(j)];
        const bool soft = row.softness > 0.0;
        const int wanted = row.bounds.disc == Disc::first ? 2 : 1;
        const bool goes_on = !soft && !to.empty() && to.back().disc != soft_row && to.back().a == run.a &&
                             to.back().b == run.b && to.back().count + wanted <= rows_of_a_block;
        if (!goes_on) {
            to.push_back({.begin = run.first + j - run.begin,
                          .of_step = j,
                          .a = run.a,
                          .b = run.b,
                          .disc = soft ? soft_row : -1});
        } else if (j == run.begin) {
            to.back().of_step = -1;
        }
        if (row.bounds.disc == Disc::first) to.back().disc = to.back().count;
        ++to.back().count;
    }
}

void UnitRows::couple(std::span<Block> some) {
    for_each_block(some, [&](Block& block, auto count, auto) {
        const UnitRow* row = rows_of(block);
        unrolled<count>([&](auto i) {
            unrolled<i>([&](auto k) { block.couplings[i + k - 1] = product(*row[i].unit, *row[k].unit); });
        });
    });
}

[[gnu::flatten]] void UnitRows::add_velocities(std::span<const Block> some, Vector6& still) {
    for_each_block(some, [&](const Block& block, auto count, auto) {
        double y[count];
        unrolled<count>([&](auto i) { y[i] = rows_of(block)[i].y; });
        push<count>(block, y, at_bodies(block, still));
    });
}

void UnitRows::follow() {
    std::fill(velocity.begin(), velocity.end(), Vector6::Zero());
    Vector6 still = Vector6::Zero();
    add_velocities(blocks, still);
}

double UnitRows::move(UnitRow& row, double y) {
    if (row.disc == Disc::none) return row.scale * std::abs(set(row, clamped(row, y)));
    if (row.disc == Disc::first) {
        wanted_by_first_ = y;
        return 0.0;
    }
    double first = wanted_by_first_;
    put_in_disc(row, first, y);
    const double change = set(*(&row - 1), first);
    return row.scale * std::max(std::abs(change), std::abs(set(row, y)));
}

[[gnu::flatten]] double UnitRows::residual(std::span<const Block> some) {
    double largest = 0.0;
    for_each_block(some, [&](const Block& block, auto count, auto disc) {
        const Velocity x = at_bodies(block);
        double moved[count];
        unrolled<count>([&](auto i) {
            const UnitRow& row = rows_of(block)[i];
            moved[i] = row.y + error(row, x);
            if constexpr (disc == soft_row) moved[i] -= row.soft * row.y;
            if constexpr (disc >= 0 && i == disc + 1) {
                put_in_disc(row, moved[disc], moved[i]);
                const double first = moved[disc] - (&row - 1)->y, second = moved[i] - row.y;
                largest = std::max(largest, row.scale * std::sqrt(first * first + second * second));
            } else if constexpr (disc < 0 || i != disc) {
                moved[i] = clamped(row, moved[i]);
                largest = std::max(largest, row.scale * std::abs(moved[i] - row.y));
            }
        });
    });
    return largest;
}

}  // namespace pushfactor::engine::solvers
