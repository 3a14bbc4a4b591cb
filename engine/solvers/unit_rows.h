// Rows of an island scaled to unit length, as the iterative and exact solvers use them: one set of axes for reading
// and writing, rows and bodies by their numbers in the island. Internal to the solvers.
//
// With M^(-1/2) = [m^(-1/2), W] (W W^T = I^-1) and s_j = sqrt(A_jj):
//
//   row axis       u_j = M^(-1/2)^T j_c / s_j        unit length, so that A_jj becomes 1
//   force          y_j = lambda_j dt s_j             [sqrt(kg) m/s]
//   right side     t_j = b_j dt / s_j
//   body velocity  x   = sum_j u_j y_j               effect of the forces of all rows on a body
//
// and 7.1.1 reads y_j <- clamp(y_j + t_j - u_j . x), without a division. u_j . x is A lambda, because u_i . u_j =
// A_ij / (s_i s_j). The columns of b share the axes; each has its own y and x.
//
// Up to three consecutive rows that act on the same two bodies form a block: the contact row of a point and its
// friction rows are one. A block loads the velocities of its bodies once, for all its rows and columns.
//
// A soft row has u of length below 1, and its force also moves itself: its error is t_j - u_j . x - soft y_j with
// soft = 1 - |u|^2. It is a block of its own, so that rigid rows do not pay for it.
//
// Two rows of a disc have one s, so that their y are bounded by a disc too, and u of length 1 or less. They move
// together: y <- P_disc(y + t - U x), with both errors from the same x (system_equation.h).
#pragma once

#include "engine/solvers/lanes.h"
#include "engine/system/islands.h"
#include "engine/system/system_equation.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <span>
#include <vector>

namespace pushfactor::engine::solvers {

template <int columns>
class UnitRows {
  public:
    using BodyVelocity = Eigen::Matrix<double, 6, columns>;
    using Value = typename Lanes<columns>::Value;

    struct Row {
        const Jacobian* unit = nullptr;  // u_j
        int a = 0, b = 0;                // bodies
        std::array<double, columns> y{}, t{};
        std::array<double, columns> low{}, high{};  // bounds of y, or factors of the other row's y
        int of_row = -1;
        Disc disc = Disc::none;
        double scale = 0.0;  // s_j; 0 for a row that cannot move anything
        double soft = 0.0;   // share of its softness in A_jj; then |u| is below 1
        double keeps = 1.0;  // share of its force that it does not give way to, in sweeps of small steps
    };

    static constexpr int rows_of_a_block = 3;  // maximum
    static constexpr int soft_row = -2;        // a single one
    struct Block {
        int begin = 0, count = 0;  // rows
        int a = 0, b = 0;          // bodies
        int disc = -1;  // index in the block of the first row of a disc, or -1; at most one disc; or soft_row
        // u_i . u_j of its rows 1 and 0, 2 and 0, 2 and 1; valid after couple().
        std::array<double, 3> couplings{};
    };

    // Loads the rows of `island` and their warm start [N, rows of the system x columns]. A row with A_jj = 0
    // becomes a row of zeros.
    void load(const SystemEquation& system, const Island& island, const Columns& guess) {
        begin(island);
        for (const RowRun& run : island.runs) load_run(system, island, run, guess, 0, system.dt);
        add_blocks(0, island.rows, blocks);
        follow();
    }

    // The same in four stages, of which threads may share all but the first, by run and by block. First: sizes.
    void begin(const Island& island) {
        rows.resize(static_cast<std::size_t>(island.rows));
        units_.resize(rows.size());
        velocity.resize(static_cast<std::size_t>(island.body_count));
        movable = island.movable();
        has_soft_ = island.has(RowDigest::soft);
        blocks.clear();
        coupled_ = false;
    }
    // Second, for each run: loads its rows for a step of `dt` [s], with the warm start in columns from `first` on.
    void load_run(const SystemEquation& system, const Island& island, const RowRun& run, const Columns& guess,
                  Eigen::Index first, double dt) {
        for (int j = run.begin, number = run.first; j < run.end; ++j, ++number) {
            Row& row = rows[static_cast<std::size_t>(number)];
            row.a = run.a;
            row.b = run.b;
            row.unit = &units_[static_cast<std::size_t>(number)];
            row.scale = std::sqrt(system.diagonal[j]);
            units_[static_cast<std::size_t>(number)] =
                unit_axis(system, system.rows[static_cast<std::size_t>(j)], row.scale);
            load_row(system, island, run, guess, first, dt, j, row);
        }
    }
    // Replaces the axis of a row by that of `source`, in a step of `dt` [s]; its force and target stay.
    void replace(const SystemEquation& system, const ConstraintRow& source, std::size_t number, double dt) {
        Row& row = rows[number];
        const double diagonal = diagonal_of(system, source);
        row.scale = std::sqrt(diagonal);
        units_[number] = unit_axis(system, source, row.scale);
        if (source.softness > 0.0) row.soft = source.softness / diagonal;
        row.low[0] = source.bounds.c_min * dt * row.scale;
        row.high[0] = source.bounds.c_max * dt * row.scale;
    }
    // Third: the blocks of rows `begin_row` .. `end_row` - 1.
    void add_blocks(int begin_row, int end_row, std::vector<Block>& to) const {
        for (int j = begin_row; j < end_row; ++j) add_to_block(j, to);
    }
    // Fourth: the velocities due to the forces. Either follow(), or, for movable bodies whose velocities are zero,
    // adding the blocks that act on them one after the other.
    [[gnu::flatten]] void add_velocities(std::span<const Block> some, BodyVelocity& still) {
        for_each_block(some, [&](const Block& block, auto count, auto) {
            Value y[count];
            unrolled<count>([&](auto i) { y[i] = Lanes<columns>::of(rows_of(block)[i].y); });
            Velocity x[columns];
            unrolled<columns>([&](auto c) { x[c] = at_bodies(block, c, still); });
            push<count>(block, y, x);
        });
    }

    // Writes the solution [N] for the rows of the loaded island; to both columns of `lambda` if it has one.
    void store(const SystemEquation& system, const Island& island, Columns& lambda) const {
        auto row = rows.begin();
        for (const RowRun& run : island.runs) {
            for (int j = run.begin; j < run.end; ++j, ++row) store_row(system, *row, j, lambda);
        }
    }

    // t_j - u_j . x - soft y_j
    double error(const Row& row, int c) const {
        return row.t[at(c)] - row.unit->a.dot(x_of(row.a).col(c)) - row.unit->b.dot(x_of(row.b).col(c)) -
               row.soft * row.y[at(c)];
    }
    // In all columns, for a rigid row whose bodies have the velocities `x`.
    Value error(const Row& row, const Velocity (&x)[columns]) const {
        const Axis u = axis_of(*row.unit);
        Two sums[columns];
        unrolled<columns>([&](auto c) { sums[c] = products(u, x[c]); });
        return Lanes<columns>::of(row.t) - Lanes<columns>::sum(sums);
    }

    // `y` clamped to the current bounds of a row without a disc.
    double clamped(const Row& row, int c, double y) const {
        const double other = leader(row, c);
        return std::max(std::min(y, row.high[at(c)] * other), row.low[at(c)] * other);
    }
    Value clamped(const Row& row, Value y) const {
        Value low = Lanes<columns>::of(row.low), high = Lanes<columns>::of(row.high);
        if (row.of_row >= 0) {
            const Value other = Lanes<columns>::of(rows[static_cast<std::size_t>(row.of_row)].y);
            low *= other;
            high *= other;
        }
        return larger(smaller(y, high), low);
    }

    // Projects the forces of both rows of a disc onto its current radius; `row` is the second.
    void put_in_disc(const Row& row, int c, double& first, double& second) const {
        const double share = share_in_disc(first * first + second * second, row.high[at(c)] * leader(row, c));
        first *= share;
        second *= share;
    }
    void put_in_disc(const Row& row, Value& first, Value& second) const {
        const Value square = first * first + second * second;
        std::array<double, columns> share;
        for (int c = 0; c < columns; ++c) {
            share[at(c)] = share_in_disc(Lanes<columns>::in(square, c), row.high[at(c)] * leader(row, c));
        }
        first *= Lanes<columns>::of(share);
        second *= Lanes<columns>::of(share);
    }

    // Sets a row's force to `y` clamped to its bounds, and updates its bodies; rows have to be visited in order.
    // The two rows of a disc move together at the second one. Returns the largest change of a row's velocity [m/s].
    double move(Row& row, int c, double y) {
        switch (row.disc) {
            case Disc::none:
                return row.scale * std::abs(set(row, c, clamped(row, c, y)));
            case Disc::first:
                wanted_by_first_[at(c)] = y;
                return 0.0;
            case Disc::second:
                break;
        }
        double first = wanted_by_first_[at(c)];
        put_in_disc(row, c, first, y);
        const double change = set(*(&row - 1), c, first);
        return row.scale * std::max(std::abs(change), std::abs(set(row, c, y)));
    }

    // Sets the force of a row and updates its bodies. Returns the change of y.
    double set(Row& row, int c, double y) {
        const double change = y - row.y[at(c)];
        row.y[at(c)] = y;
        if (row.a < movable) x_of(row.a).col(c) += row.unit->a * change;
        if (row.b < movable) x_of(row.b).col(c) += row.unit->b * change;
        return change;
    }

    // x of a block's bodies in column c.
    Velocity at_bodies(const Block& block, std::size_t c) {
        return {reinterpret_cast<Two*>(x_of(block.a).data() + 6 * c),
                reinterpret_cast<Two*>(x_of(block.b).data() + 6 * c)};
    }

    // The same for threads that work concurrently on other blocks with the same static bodies: `still`, which is
    // zero, replaces these.
    Velocity at_bodies(const Block& block, std::size_t c, BodyVelocity& still) {
        BodyVelocity& a = block.a < movable ? x_of(block.a) : still;
        BodyVelocity& b = block.b < movable ? x_of(block.b) : still;
        return {reinterpret_cast<Two*>(a.data() + 6 * c), reinterpret_cast<Two*>(b.data() + 6 * c)};
    }

    // Calls `visit` for each block, with its number of rows and the index of its disc as compile-time constants.
    template <typename Visit>
    void for_each_block(const Visit& visit) {
        for_each_block(std::span<Block>(blocks), visit);
    }
    template <typename AnyBlock, typename Visit>
    void for_each_block(std::span<AnyBlock> some, const Visit& visit) {
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

    // Adds the changes of a block's forces to the velocities of its bodies.
    template <std::size_t count>
    void push(const Block& block, const Value (&changes)[count]) {
        Velocity x[columns];
        unrolled<columns>([&](auto c) { x[c] = at_bodies(block, c); });
        push<count>(block, changes, x);
    }
    // With the velocities of the bodies given.
    template <std::size_t count>
    void push(const Block& block, const Value (&changes)[count], const Velocity (&x)[columns]) {
        const Row* row = rows_of(block);
        Axis u[count];
        unrolled<count>([&](auto i) { u[i] = axis_of(*row[i].unit); });
        unrolled<columns>([&](auto c) {
            double y[count];
            unrolled<count>([&](auto i) { y[i] = Lanes<columns>::in(changes[i], c); });
            add(x[c], u, y);
        });
    }

    // Recomputes the bodies' velocities from all forces, which removes accumulated rounding errors.
    void follow() {
        std::fill(velocity.begin(), velocity.end(), BodyVelocity::Zero());
        BodyVelocity still = BodyVelocity::Zero();
        add_velocities(blocks, still);
    }

    // Computes the couplings of the blocks unless up to date.
    void couple() {
        if (!coupled_) couple(blocks);
        coupled_ = true;
    }
    void couple(std::span<Block> some) {
        for_each_block(some, [&](Block& block, auto count, auto) {
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
    double residual() { return residual(blocks); }
    // Of the rows of some blocks.
    [[gnu::flatten]] double residual(std::span<const Block> some) {
        Value largest{};
        for_each_block(some, [&](const Block& block, auto count, auto disc) {
            Velocity x[columns];
            unrolled<columns>([&](auto c) { x[c] = at_bodies(block, c); });
            Value moved[count];
            unrolled<count>([&](auto i) {
                const Row& row = rows_of(block)[i];
                moved[i] = Lanes<columns>::of(row.y) + error(row, x);
                if constexpr (disc == soft_row) moved[i] -= row.soft * Lanes<columns>::of(row.y);
                if constexpr (disc >= 0 && i == disc + 1) {
                    largest = larger(largest, missed_in_disc(row, moved[disc], moved[i]));
                } else if constexpr (disc < 0 || i != disc) {
                    moved[i] = clamped(row, moved[i]);
                    largest = larger(largest, row.scale * magnitude(moved[i] - Lanes<columns>::of(row.y)));
                }
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

    // Whether any bound is a multiple of another row's force.
    bool bounds_follow() const {
        return std::any_of(rows.begin(), rows.end(), [](const Row& row) { return row.of_row >= 0; });
    }
    bool has_soft() const { return has_soft_; }
    bool has_discs() const {
        return std::any_of(rows.begin(), rows.end(), [](const Row& row) { return row.disc != Disc::none; });
    }

    std::vector<Row> rows;
    std::vector<Block> blocks;           // of all rows, in order
    std::vector<BodyVelocity> velocity;  // x, one per body
    int movable = 0;                     // number of movable bodies; static ones have higher numbers

  private:
    // Row j of the system, part of `run`; its bodies are already set.
    void load_row(const SystemEquation& system, const Island& island, const RowRun& run, const Columns& guess,
                  Eigen::Index first, double dt, int j, Row& row) {
        const ConstraintRow& source = system.rows[static_cast<std::size_t>(j)];
        row.of_row = source.bounds.of_row;
        row.disc = source.bounds.disc;
        row.soft = 0.0;
        row.keeps = 1.0;
        if (has_soft_ && source.softness > 0.0) row.soft = source.softness / system.diagonal[j];
        if (row.of_row >= 0) {
            row.of_row =
                row.of_row >= run.begin ? run.first + row.of_row - run.begin : island.number_of(row.of_row);
        }
        if (!(row.scale > 0.0)) {
            row.y = row.t = {};
            row.low = row.high = {};
            return;
        }
        assert(row.a != row.b);
        const double to_y = dt * row.scale;
        const double to_t = dt * (1.0 / row.scale);
        const double bound_scale = row.of_row < 0 ? to_y : row.scale / scale_of(row.of_row);
        for (int c = 0; c < columns; ++c) {
            const bool bounded_by_zero = c > 0 && !source.bounds.in_momenta;
            row.low[at(c)] = bounded_by_zero ? 0.0 : source.bounds.c_min * bound_scale;
            row.high[at(c)] = bounded_by_zero ? 0.0 : source.bounds.c_max * bound_scale;
            row.t[at(c)] = system.b(j, c) * to_t;
            row.y[at(c)] = guess(j, first + c) * to_y;
        }
    }

    void store_row(const SystemEquation& system, const Row& row, int j, Columns& lambda) const {
        for (int c = 0; c < columns; ++c) {
            lambda(j, c) = row.scale > 0.0 ? row.y[at(c)] / (system.dt * row.scale) : 0.0;
            // Clamp again: scaling back may exceed the bounds by rounding.
            clamp_force(system.rows, j, c, lambda);
        }
        if (columns == lambda.cols()) return;
        const Eigen::Index last = lambda.cols() - 1;
        lambda(j, last) = lambda(j, 0);
        if (row.disc == Disc::second) lambda(j - 1, last) = lambda(j - 1, 0);
    }

    void add_to_block(int j, std::vector<Block>& to) const {
        const Row& row = rows[static_cast<std::size_t>(j)];
        if (has_soft_ && row.soft > 0.0) {
            to.push_back({.begin = j, .count = 1, .a = row.a, .b = row.b, .disc = soft_row});
            return;
        }
        if (!to.empty() && !(has_soft_ && to.back().disc == soft_row)) {
            Block& last = to.back();
            const int wanted = row.disc == Disc::first ? 2 : 1;
            if (last.a == row.a && last.b == row.b && last.count + wanted <= rows_of_a_block) {
                if (row.disc == Disc::first) last.disc = last.count;
                ++last.count;
                return;
            }
        }
        to.push_back({.begin = j, .count = 1, .a = row.a, .b = row.b, .disc = row.disc == Disc::first ? 0 : -1});
    }

    // The force that the row's bounds are factors of.
    double leader(const Row& row, int c) const {
        return row.of_row < 0 ? 1.0 : rows[static_cast<std::size_t>(row.of_row)].y[at(c)];
    }

    // Residual of both rows of a disc for these unprojected forces; `row` is the second.
    Value missed_in_disc(const Row& row, Value first, Value second) const {
        put_in_disc(row, first, second);
        first -= Lanes<columns>::of((&row - 1)->y);
        second -= Lanes<columns>::of(row.y);
        return row.scale * root(Value(first * first + second * second));
    }

    // s of the other row; 1 if it is 0, because its y is 0 then.
    double scale_of(int row) const {
        const double scale = rows[static_cast<std::size_t>(row)].scale;
        return scale > 0.0 ? scale : 1.0;
    }

    std::vector<Jacobian> units_;                    // by row
    bool has_soft_ = false;                          // some row of the island is soft
    bool coupled_ = false;                           // the couplings of the blocks are up to date
    std::array<double, columns> wanted_by_first_{};  // of the disc whose second row is next; see move()
};

}  // namespace pushfactor::engine::solvers
