// Paper 7.1.1, one row at a time, with the sum over the other rows taken through the bodies.
//
// The scaling is inner matter of this file. With M^(-1/2) = [m^(-1/2), W] (W W^T = I^-1) and s_j = sqrt(A_jj):
//
//   row axis       u_j = M^(-1/2)^T j_c / s_j        unit length, so that A_jj becomes 1
//   force          y_j = lambda_j dt s_j             [sqrt(kg) m/s]
//   right side     t_j = b_j dt / s_j
//   body velocity  x   = sum_j u_j y_j               what the forces of all rows do to a body
//
// and 7.1.1 reads y_j <- clamp(y_j + t_j - u_j . x): no division, one set of axes for reading and writing.
// u_j . y summed is A lambda because u_i . u_j = A_ij / (s_i s_j).
//
// The columns of b share the axes, so that both are swept together; each has its own y and x.
#include "engine/solvers/pgs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace pushfactor::engine::solvers {

namespace {

template <int columns>
class Sweep {
  public:
    void load(const SystemEquation& system, const Columns& guess) {
        velocity_.assign(system.inverse_mass.size(), BodyVelocity::Zero());
        rows_.resize(static_cast<std::size_t>(system.row_count()));
        for (Eigen::Index j = 0; j < system.row_count(); ++j) load_row(system, guess, j);
    }

    void store(const SystemEquation& system, Columns& lambda) const {
        for (Eigen::Index j = 0; j < system.row_count(); ++j) {
            const Row& row = rows_[static_cast<std::size_t>(j)];
            for (int c = 0; c < columns; ++c) {
                lambda(j, c) = row.scale > 0.0 ? row.y[at(c)] / (system.dt * row.scale) : 0.0;
                // The bounds once more: scaling back may pass them by a rounding.
                const auto [low, high] = bounds_of(system.rows[static_cast<std::size_t>(j)], lambda, c);
                lambda(j, c) = std::max(std::min(lambda(j, c), high), low);
            }
        }
    }

    // One iteration. Returns the largest change of a row's velocity [m/s].
    double iterate() {
        double largest = 0.0;
        for (Row& row : rows_) {
            BodyVelocity& a = velocity_[row.a];
            BodyVelocity& b = velocity_[row.b];
            for (int c = 0; c < columns; ++c) {
                const double before = row.y[at(c)];
                const double after = clamped(row, c, before + error(row, c));
                const double change = after - before;
                row.y[at(c)] = after;
                a.col(c) += row.axis_a * change;
                b.col(c) += row.axis_b * change;
                largest = std::max(largest, row.scale * std::abs(change));
            }
        }
        return largest;
    }

    // Natural-map residual [m/s], the same as natural_residual() up to rounding.
    double residual() const {
        double largest = 0.0;
        for (const Row& row : rows_) {
            for (int c = 0; c < columns; ++c) {
                const double moved = clamped(row, c, row.y[at(c)] + error(row, c));
                largest = std::max(largest, row.scale * std::abs(moved - row.y[at(c)]));
            }
        }
        return largest;
    }

  private:
    using BodyVelocity = Eigen::Matrix<double, 6, columns>;

    struct Row {
        Vector6 axis_a, axis_b;  // u_j
        std::size_t a, b;        // bodies
        std::array<double, columns> y, t;
        double low, high;  // bounds of y, or factors of the other row's y
        int of_row;
        double scale;  // s_j; 0 for a row that cannot move anything
    };

    static constexpr std::size_t at(int column) { return static_cast<std::size_t>(column); }

    void load_row(const SystemEquation& system, const Columns& guess, Eigen::Index j) {
        const ConstraintRow& source = system.rows[static_cast<std::size_t>(j)];
        Row& row = rows_[static_cast<std::size_t>(j)];
        row.a = static_cast<std::size_t>(source.body_a);
        row.b = static_cast<std::size_t>(source.body_b);
        row.scale = std::sqrt(system.diagonal[j]);
        if (!(row.scale > 0.0)) {
            row = Row{.axis_a = Vector6::Zero(),
                      .axis_b = Vector6::Zero(),
                      .a = row.a,
                      .b = row.b,
                      .y = {},
                      .t = {},
                      .low = 0.0,
                      .high = 0.0,
                      .of_row = -1,
                      .scale = 0.0};
            return;
        }
        row.axis_a = weighted(system.inverse_mass[row.a], source.jacobian.a) / row.scale;
        row.axis_b = weighted(system.inverse_mass[row.b], source.jacobian.b) / row.scale;

        row.of_row = source.bounds.of_row;
        const double bound_scale = row.of_row < 0 ? system.dt * row.scale : row.scale / scale_of(row.of_row);
        row.low = source.bounds.c_min * bound_scale;
        row.high = source.bounds.c_max * bound_scale;

        for (int c = 0; c < columns; ++c) {
            row.t[at(c)] = system.b(j, c) * (system.dt / row.scale);
            row.y[at(c)] = guess(j, c) * (system.dt * row.scale);
            velocity_[row.a].col(c) += row.axis_a * row.y[at(c)];
            velocity_[row.b].col(c) += row.axis_b * row.y[at(c)];
        }
    }

    // M^(-1/2)^T j, angular part in body axes.
    static Vector6 weighted(const InverseMass& inverse_mass, const Vector6& j) {
        Vector6 result;
        result << std::sqrt(inverse_mass.linear) * j.head<3>(), inverse_mass.angular_root.transpose() * j.tail<3>();
        return result;
    }

    // The other row's s; 1 where it is 0, because its y is 0 then.
    double scale_of(int row) const {
        const double scale = rows_[static_cast<std::size_t>(row)].scale;
        return scale > 0.0 ? scale : 1.0;
    }

    double error(const Row& row, int c) const {
        return row.t[at(c)] - row.axis_a.dot(velocity_[row.a].col(c)) - row.axis_b.dot(velocity_[row.b].col(c));
    }

    double clamped(const Row& row, int c, double y) const {
        const double other = row.of_row < 0 ? 1.0 : rows_[static_cast<std::size_t>(row.of_row)].y[at(c)];
        return std::max(std::min(y, row.high * other), row.low * other);
    }

    std::vector<Row> rows_;
    std::vector<BodyVelocity> velocity_;  // x, one a body
};

template <int columns>
int run(Sweep<columns>& sweep, const SystemEquation& system, const Termination& termination, Columns& lambda) {
    const bool checked = termination.tolerance_high > 0.0;
    sweep.load(system, lambda);
    if (checked && sweep.residual() <= termination.tolerance_high) return 0;

    int iteration = 0;
    while (iteration < termination.iterations) {
        ++iteration;
        const double change = sweep.iterate();
        // The change bounds nothing, but while it is large the residual need not be looked at.
        if (checked && change <= termination.tolerance_low && sweep.residual() <= termination.tolerance_low) {
            break;
        }
    }
    sweep.store(system, lambda);
    return iteration;
}

class Pgs : public Solver {
  public:
    int solve(const SystemEquation& system, const Termination& termination, Columns& lambda) override {
        return system.column_count() == 2 ? run(two_columns_, system, termination, lambda)
                                          : run(one_column_, system, termination, lambda);
    }

  private:
    Sweep<1> one_column_;
    Sweep<2> two_columns_;
};

}  // namespace

std::unique_ptr<Solver> make_pgs() {
    return std::make_unique<Pgs>();
}

}  // namespace pushfactor::engine::solvers
