// Rows of an island as unit rows (unit_row.h), one column at a time; rows and bodies by their numbers in the
// island. Internal to the solvers.
//
// Up to three consecutive rows that act on the same two bodies form a block: the contact row of a point and its
// friction rows are one. A block loads the velocities of its bodies once, for all its rows. A soft row is a block
// of its own, so that rigid rows do not pay for it.
#pragma once

#include "engine/solvers/lanes.h"
#include "engine/solvers/unit_row.h"
#include "engine/system/islands.h"
#include "engine/system/system_equation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

namespace pushfactor::engine::solvers {

class UnitRows {
  public:
    static constexpr int rows_of_a_block = 3;  // maximum
    static constexpr int soft_row = -2;        // a single one
    struct Block {
        int begin = 0, count = 0;  // rows
        int of_step = 0;           // row of the step that is `begin`; -1 if they are not consecutive there
        int a = 0, b = 0;          // bodies
        int disc = -1;  // index in the block of the first row of a disc, or -1; at most one disc; or soft_row
        // u_i . u_j of its rows 1 and 0, 2 and 0, 2 and 1
        std::array<double, 3> couplings{};
    };

    // Loads the rows of `island`, without the numbers of a column. A row with A_jj = 0 becomes a row of zeros.
    void load(const SystemEquation& system, const Island& island);
    // Takes targets, bounds and warm start [N, rows of the system x columns] of a column.
    void take(const SystemEquation& system, const Island& island, const Columns& guess, Eigen::Index column);
    // Writes the solution [N] of this column for the rows of the loaded island; for both columns of `lambda` if the
    // island has one.
    void store(const SystemEquation& system, const Island& island, Eigen::Index column, Columns& lambda) const;

    // Both in stages that threads may share, by run and by block, after the first: sizes; there may be more rows.
    void begin(const Island& island);
    // Second, for each run: its rows, and their numbers in a column for a step of `dt` [s].
    void load_run(const SystemEquation& system, const Island& island, const RowRun& run);
    void take_run(const SystemEquation& system, const RowRun& run, const Columns& guess, Eigen::Index column,
                  double dt);
    // Third: the blocks of the run, after those of the one before, without their couplings.
    static void add_blocks(const SystemEquation& system, const RowRun& run, std::vector<Block>& to);
    // Fourth: the couplings, and the velocities due to the forces. Either follow(), or, for movable bodies whose
    // velocities are zero, adding the blocks that act on them one after the other.
    void couple(std::span<Block> some);
    void add_velocities(std::span<const Block> some, Vector6& still);

    // Replaces the axis of a row by that of `source`, in a step of `dt` [s]; its force and target stay.
    void replace(const SystemEquation& system, const ConstraintRow& source, std::size_t number, double dt);

    // t_j - u_j . x - soft y_j
    double error(const UnitRow& row) const {
        return row.t - row.unit->a.dot(x_of(row.a)) - row.unit->b.dot(x_of(row.b)) - row.soft * row.y;
    }
    // For a rigid row whose bodies have the velocities `x`.
    static double error(const UnitRow& row, const Velocity& x) {
        return row.t - sum_of(products(axis_of(*row.unit), x));
    }

    // `y` clamped to the current bounds of a row without a disc.
    double clamped(const UnitRow& row, double y) const {
        const double other = force_of_leader(row);
        return std::max(std::min(y, row.high * other), row.low * other);
    }
    // Projects the forces of both rows of a disc onto its current radius; `row` is the second.
    void put_in_disc(const UnitRow& row, double& first, double& second) const {
        const double share = share_in_disc(first * first + second * second, row.high * force_of_leader(row));
        first *= share;
        second *= share;
    }

    // Sets a row's force to `y` clamped to its bounds, and updates its bodies; rows have to be visited in order.
    // The two rows of a disc move together at the second one. Returns the largest change of a row's velocity [m/s].
    double move(UnitRow& row, double y);
    // Sets the force of a row and updates its bodies. Returns the change of y.
    double set(UnitRow& row, double y) {
        const double change = y - row.y;
        row.y = y;
        if (row.a < movable) x_of(row.a) += row.unit->a * change;
        if (row.b < movable) x_of(row.b) += row.unit->b * change;
        return change;
    }

    // x of a block's bodies.
    Velocity at_bodies(const Block& block) {
        return {reinterpret_cast<Two*>(x_of(block.a).data()), reinterpret_cast<Two*>(x_of(block.b).data())};
    }
    // The same for threads that work concurrently on other blocks with the same static bodies: `still`, which is
    // zero, replaces these.
    Velocity at_bodies(const Block& block, Vector6& still) {
        Vector6& a = block.a < movable ? x_of(block.a) : still;
        Vector6& b = block.b < movable ? x_of(block.b) : still;
        return {reinterpret_cast<Two*>(a.data()), reinterpret_cast<Two*>(b.data())};
    }

    // Calls `visit` for each block, with its number of rows and the index of its disc as compile-time constants.
    template <typename AnyBlock, typename Visit>
    static void for_each_block(std::span<AnyBlock> some, const Visit& visit) {
        for (AnyBlock& block : some) {
            const auto with_disc = [&](auto count) {
                if (block.disc < 0) visit(block, count, std::integral_constant<int, -1>());
                if constexpr (count > 1) {
                    if (block.disc == 0) visit(block, count, std::integral_constant<int, 0>());
                }
                if constexpr (count > 2) {
                    if (block.disc == 1) visit(block, count, std::integral_constant<int, 1>());
                }
            };
            switch (block.count) {
                case 1:
                    if (block.disc == soft_row) {
                        visit(block, std::integral_constant<int, 1>(), std::integral_constant<int, soft_row>());
                    } else {
                        with_disc(std::integral_constant<int, 1>());
                    }
                    break;
                case 2:
                    with_disc(std::integral_constant<int, 2>());
                    break;
                default:
                    with_disc(std::integral_constant<int, 3>());
            }
        }
    }

    // Adds the changes of a block's forces to the velocities `x` of its bodies.
    template <std::size_t count>
    void push(const Block& block, const double (&changes)[count], const Velocity& x) {
        const UnitRow* row = rows_of(block);
        Axis u[count];
        unrolled<count>([&](auto i) { u[i] = axis_of(*row[i].unit); });
        add(x, u, changes);
    }

    // Recomputes the bodies' velocities from all forces, which removes accumulated rounding errors.
    void follow();

    // Natural-map residual [m/s], the same as natural_residual() up to rounding; and of the rows of some blocks.
    double residual() { return residual(blocks); }
    double residual(std::span<const Block> some);

    UnitRow* rows_of(const Block& block) { return rows.data() + block.begin; }
    const Vector6& x_of(int body) const { return velocity[static_cast<std::size_t>(body)]; }
    Vector6& x_of(int body) { return velocity[static_cast<std::size_t>(body)]; }

    // Multiply-adds of one pass that reads and writes every row, and of one that only reads.
    double pass_work() const { return 24.0 * static_cast<double>(rows.size()); }
    double look_work() const { return 12.0 * static_cast<double>(rows.size()); }

    bool has_soft() const { return has_soft_; }
    bool has_discs() const {
        return std::any_of(rows.begin(), rows.end(), [](const UnitRow& row) { return row.disc != Disc::none; });
    }
    // Whether any bound is a multiple of another row's force.
    bool bounds_follow() const {
        return std::any_of(rows.begin(), rows.end(), [](const UnitRow& row) { return row.leader >= 0; });
    }

    std::vector<UnitRow> rows;
    std::vector<Block> blocks;      // of all rows, in order
    std::vector<Vector6> velocity;  // x, one per body
    int movable = 0;                // number of movable bodies; static ones have higher numbers

  private:
    // The force that the row's bounds are factors of.
    double force_of_leader(const UnitRow& row) const {
        return row.leader < 0 ? 1.0 : rows[static_cast<std::size_t>(row.leader)].y;
    }

    std::vector<Jacobian> units_;   // by row, and more
    bool has_soft_ = false;         // some row of the island is soft
    double wanted_by_first_ = 0.0;  // of the disc whose second row is next; see move()
};

}  // namespace pushfactor::engine::solvers
