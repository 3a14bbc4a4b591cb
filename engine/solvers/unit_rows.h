// The rows of an island in the form that the iterative and direct solvers work on: of unit length, one set of axes
// for reading and writing, rows and bodies by their numbers in the island. An inner matter of the solvers.
//
// With M^(-1/2) = [m^(-1/2), W] (W W^T = I^-1) and s_j = sqrt(A_jj):
//
//   row axis       u_j = M^(-1/2)^T j_c / s_j        unit length, so that A_jj becomes 1
//   force          y_j = lambda_j dt s_j             [sqrt(kg) m/s]
//   right side     t_j = b_j dt / s_j
//   body velocity  x   = sum_j u_j y_j               what the forces of all rows do to a body
//
// and 7.1.1 reads y_j <- clamp(y_j + t_j - u_j . x): no division. u_j . x is A lambda, because
// u_i . u_j = A_ij / (s_i s_j). The columns of b share the axes; each has its own y and x.
//
// Rows that stand together and act on the same two bodies, up to three, are a block: the contact row of a point and
// its friction are one. A block takes the velocities of its bodies once, for all its rows and columns.
#pragma once

#include "engine/islands.h"
#include "engine/solvers/lanes.h"
#include "engine/system_equation.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <vector>

namespace pushfactor::engine::solvers {

template <int columns>
class UnitRows {
  public:
    using BodyVelocity = Eigen::Matrix<double, 6, columns>;
    using Value = typename Lanes<columns>::Value;

    struct Row {
        const Jacobian* unit = nullptr;  // u_j, of the system that was loaded
        int a = 0, b = 0;                // bodies
        std::array<double, columns> y{}, t{};
        double low = 0.0, high = 0.0;  // bounds of y, or factors of the other row's y
        int of_row = -1;
        double scale = 0.0;  // s_j; 0 for a row that cannot move anything
    };

    static constexpr int rows_of_a_block = 3;  // at most
    struct Block {
        int begin = 0, count = 0;  // of rows
        int a = 0, b = 0;          // bodies
        // u_i . u_j of its rows 1 and 0, 2 and 0, 2 and 1; for whoever has called couple().
        std::array<double, 3> couplings{};
    };

    // Takes the rows of `island` and their guesses [N, rows of the system x columns]. A row with A_jj = 0 becomes
    // one of zeros.
    void load(const SystemEquation& system, const Island& island, const Columns& guess) {
        rows.resize(static_cast<std::size_t>(island.rows));
        blocks.clear();
        coupled_ = false;
        int number = 0;
        for (const RowRun& run : island.runs) {
            for (int j = run.begin; j < run.end; ++j, ++number) {
                Row& row = rows[static_cast<std::size_t>(number)];
                row.a = run.a;
                row.b = run.b;
                load_row(system, island, run, guess, j, row);
                add_to_block(number);
            }
        }
        velocity.resize(static_cast<std::size_t>(island.body_count));
        movable = island.movable();
        follow();
    }

    // Writes the answer [N] for the rows of the island that was loaded; both columns of `lambda` when it has one.
    void store(const SystemEquation& system, const Island& island, Columns& lambda) const {
        auto row = rows.begin();
        for (const RowRun& run : island.runs) {
            for (int j = run.begin; j < run.end; ++j, ++row) store_row(system, *row, j, lambda);
        }
    }

    // t_j - u_j . x
    double error(const Row& row, int c) const {
        return row.t[at(c)] - row.unit->a.dot(x_of(row.a).col(c)) - row.unit->b.dot(x_of(row.b).col(c));
    }
    // In all columns, of a row whose bodies have the velocities `x`.
    Value error(const Row& row, const Velocity (&x)[columns]) const {
        const Axis u = axis_of(*row.unit);
        Two sums[columns];
        unrolled<columns>([&](auto c) { sums[c] = products(u, x[c]); });
        return Lanes<columns>::of(row.t) - Lanes<columns>::sum(sums);
    }

    // `y` between the row's bounds as they are now.
    double clamped(const Row& row, int c, double y) const {
        const double other = row.of_row < 0 ? 1.0 : rows[static_cast<std::size_t>(row.of_row)].y[at(c)];
        return std::max(std::min(y, row.high * other), row.low * other);
    }
    Value clamped(const Row& row, Value y) const {
        Value low = Lanes<columns>::all(row.low), high = Lanes<columns>::all(row.high);
        if (row.of_row >= 0) {
            const Value other = Lanes<columns>::of(rows[static_cast<std::size_t>(row.of_row)].y);
            low *= other;
            high *= other;
        }
        return larger(smaller(y, high), low);
    }

    // Gives a row the force y, and its bodies the velocities that follow. Returns the change of y.
    double set(Row& row, int c, double y) {
        const double change = y - row.y[at(c)];
        row.y[at(c)] = y;
        x_of(row.a).col(c) += row.unit->a * change;
        x_of(row.b).col(c) += row.unit->b * change;
        return change;
    }

    // x of a block's bodies in column c.
    Velocity at_bodies(const Block& block, std::size_t c) {
        return {reinterpret_cast<Two*>(x_of(block.a).data() + 6 * c),
                reinterpret_cast<Two*>(x_of(block.b).data() + 6 * c)};
    }

    // Calls `visit` with each block and the number of its rows as a constant.
    template <typename Visit>
    void for_each_block(const Visit& visit) {
        for (Block& block : blocks) {
            switch (block.count) {
                case 1:
                    visit(block, std::integral_constant<std::size_t, 1>());
                    break;
                case 2:
                    visit(block, std::integral_constant<std::size_t, 2>());
                    break;
                default:
                    visit(block, std::integral_constant<std::size_t, 3>());
            }
        }
    }

    // Adds to the velocities of a block's bodies what its rows make of the changes of their y.
    template <std::size_t count>
    void push(const Block& block, const Value (&changes)[count]) {
        const Row* row = rows_of(block);
        Axis u[count];
        unrolled<count>([&](auto i) { u[i] = axis_of(*row[i].unit); });
        unrolled<columns>([&](auto c) {
            double y[count];
            unrolled<count>([&](auto i) { y[i] = Lanes<columns>::in(changes[i], c); });
            add(at_bodies(block, c), u, y);
        });
    }

    // The bodies' velocities anew from all forces, which removes what roundings have left behind.
    [[gnu::flatten]] void follow() {
        std::fill(velocity.begin(), velocity.end(), BodyVelocity::Zero());
        for_each_block([&](const Block& block, auto count) {
            Value y[count];
            unrolled<count>([&](auto i) { y[i] = Lanes<columns>::of(rows_of(block)[i].y); });
            push<count>(block, y);
        });
    }

    // Writes the couplings of the blocks, if they are not there yet.
    void couple() {
        if (coupled_) return;
        coupled_ = true;
        for_each_block([&](Block& block, auto count) {
            const Row* row = rows_of(block);
            unrolled<count>([&](auto i) {
                unrolled<i>([&](auto k) {
                    const Two both = products(axis_of(*row[i].unit), axis_of(*row[k].unit));
                    block.couplings[i + k - 1] = both[0] + both[1];
                });
            });
        });
    }

    // Natural-map residual [m/s], the same as natural_residual() up to rounding.
    [[gnu::flatten]] double residual() {
        Value largest{};
        for_each_block([&](const Block& block, auto count) {
            Velocity x[columns];
            unrolled<columns>([&](auto c) { x[c] = at_bodies(block, c); });
            unrolled<count>([&](auto i) {
                const Row& row = rows_of(block)[i];
                const Value y = Lanes<columns>::of(row.y);
                const Value moved = clamped(row, y + error(row, x));
                largest = larger(largest, row.scale * magnitude(moved - y));
            });
        });
        return Lanes<columns>::largest(largest);
    }

    Row* rows_of(const Block& block) { return rows.data() + block.begin; }
    const BodyVelocity& x_of(int body) const { return velocity[static_cast<std::size_t>(body)]; }
    BodyVelocity& x_of(int body) { return velocity[static_cast<std::size_t>(body)]; }
    static constexpr std::size_t at(int column) { return static_cast<std::size_t>(column); }

    // Multiply-adds of one pass that reads and writes every row in every column, and of one that only reads.
    double pass_work() const { return 24.0 * columns * static_cast<double>(rows.size()); }
    double look_work() const { return 12.0 * columns * static_cast<double>(rows.size()); }
    // Of adding all rows to a matrix that is to be factorised.
    double factor_rows_work() const { return 108.0 * static_cast<double>(rows.size()); }

    // The largest speed that a row asks for while there are no forces [m/s].
    double fastest() const {
        double largest = 0.0;
        for (const Row& row : rows) {
            if (row.of_row >= 0) continue;
            for (const double t : row.t) {
                largest = std::max(largest, row.scale * std::abs(std::max(std::min(t, row.high), row.low)));
            }
        }
        return largest;
    }

    // Whether some bound is a multiple of another row's force.
    bool bounds_follow() const {
        return std::any_of(rows.begin(), rows.end(), [](const Row& row) { return row.of_row >= 0; });
    }

    std::vector<Row> rows;
    std::vector<Block> blocks;           // of all rows, in their order
    std::vector<BodyVelocity> velocity;  // x, one a body
    int movable = 0;                     // so many bodies can move; the static ones come after them

  private:
    // Row j of the system, which is of `run`; the bodies are there already.
    void load_row(const SystemEquation& system, const Island& island, const RowRun& run, const Columns& guess,
                  int j, Row& row) {
        const ConstraintRow& source = system.rows[static_cast<std::size_t>(j)];
        row.unit = &system.unit_axes[static_cast<std::size_t>(j)];
        row.scale = system.scale[j];
        row.of_row = source.bounds.of_row;
        if (row.of_row >= 0) {
            row.of_row =
                row.of_row >= run.begin ? run.first + row.of_row - run.begin : island.number_of(row.of_row);
        }
        if (!(row.scale > 0.0)) {
            row.y = row.t = {};
            row.low = row.high = 0.0;
            return;
        }
        assert(row.a != row.b);
        const double to_y = system.dt * row.scale;
        const double to_t = system.dt * system.inverse_scale[j];
        const double bound_scale = row.of_row < 0 ? to_y : row.scale / scale_of(row.of_row);
        row.low = source.bounds.c_min * bound_scale;
        row.high = source.bounds.c_max * bound_scale;
        for (int c = 0; c < columns; ++c) {
            row.t[at(c)] = system.b(j, c) * to_t;
            row.y[at(c)] = guess(j, c) * to_y;
        }
    }

    void store_row(const SystemEquation& system, const Row& row, int j, Columns& lambda) const {
        for (int c = 0; c < columns; ++c) {
            lambda(j, c) = row.scale > 0.0 ? row.y[at(c)] / (system.dt * row.scale) : 0.0;
            // The bounds once more: scaling back may pass them by a rounding.
            const auto [low, high] = bounds_of(system.rows[static_cast<std::size_t>(j)], lambda, c);
            lambda(j, c) = std::max(std::min(lambda(j, c), high), low);
        }
        if (columns < lambda.cols()) lambda(j, lambda.cols() - 1) = lambda(j, 0);
    }

    void add_to_block(int j) {
        const Row& row = rows[static_cast<std::size_t>(j)];
        if (!blocks.empty()) {
            Block& last = blocks.back();
            if (last.a == row.a && last.b == row.b && last.count < rows_of_a_block) {
                ++last.count;
                return;
            }
        }
        blocks.push_back({.begin = j, .count = 1, .a = row.a, .b = row.b});
    }

    // The other row's s; 1 where it is 0, because its y is 0 then.
    double scale_of(int row) const {
        const double scale = rows[static_cast<std::size_t>(row)].scale;
        return scale > 0.0 ? scale : 1.0;
    }

    bool coupled_ = false;  // whether the blocks have their couplings
};

}  // namespace pushfactor::engine::solvers
