// Paper section 7.2; 7.1.1 is the update of one row. Symbols: A [1/kg], b [m/s^2], lambda, c_min, c_max [N].
//
// Deviations: the guess may be a cached answer (6.2.3) instead of zero; a row with A_jj = 0 keeps lambda 0 where
// the text divides by it; a bound may follow another row's lambda. 7.2 reads A[i,j] as column i, row j, 7.1.1
// as row, column: the same number, since A is symmetric.
#include "engine/solvers/dense.h"

#include <algorithm>

namespace pushfactor::engine::solvers {

namespace {

// J as one c x 6n matrix (6.1.2).
MatrixX stacked_jacobian(const SystemEquation& system) {
    const auto bodies = static_cast<Eigen::Index>(system.inverse_mass.size());
    MatrixX jacobian = MatrixX::Zero(system.row_count(), 6 * bodies);
    for (Eigen::Index j = 0; j < system.row_count(); ++j) {
        const ConstraintRow& row = system.rows[static_cast<std::size_t>(j)];
        jacobian.block<1, 6>(j, 6 * Eigen::Index{row.body_a}) += row.jacobian.a.transpose();
        jacobian.block<1, 6>(j, 6 * Eigen::Index{row.body_b}) += row.jacobian.b.transpose();
    }
    return jacobian;
}

// M^-1 as one 6n x 6n matrix (6.1.2 in section 6.1.3).
MatrixX stacked_inverse_mass(const SystemEquation& system) {
    const auto bodies = static_cast<Eigen::Index>(system.inverse_mass.size());
    MatrixX inverse_mass = MatrixX::Zero(6 * bodies, 6 * bodies);
    for (Eigen::Index i = 0; i < bodies; ++i) {
        const InverseMass& block = system.inverse_mass[static_cast<std::size_t>(i)];
        inverse_mass.block<3, 3>(6 * i, 6 * i) = block.linear * Matrix3::Identity();
        inverse_mass.block<3, 3>(6 * i + 3, 6 * i + 3) = block.angular;
    }
    return inverse_mass;
}

void sweep(const SystemEquation& system, const MatrixX& A, Columns& lambda, Eigen::Index column) {
    for (Eigen::Index j = 0; j < A.rows(); ++j) {
        if (A(j, j) <= 0.0) {
            lambda(j, column) = 0.0;
            continue;
        }
        double value = system.b(j, column);
        for (Eigen::Index i = 0; i < A.cols(); ++i) {
            if (i != j) value -= A(j, i) * lambda(i, column);
        }
        value /= A(j, j);
        const auto [low, high] = bounds_of(system.rows[static_cast<std::size_t>(j)], lambda, column);
        lambda(j, column) = std::max(std::min(value, high), low);
    }
}

class Dense : public Solver {
  public:
    SolveCount solve(const SystemEquation& system, const Termination& termination, Columns& lambda) override {
        const bool checked = termination.tolerance_high > 0.0;
        SolveCount count;
        if (checked && natural_residual(system, lambda) <= termination.tolerance_high) return count;

        const MatrixX J = stacked_jacobian(system);
        const MatrixX A = J * stacked_inverse_mass(system) * J.transpose();
        // J M^-1 J^T as two dense products, then a full row of A for each update of lambda.
        const auto rows = static_cast<double>(J.rows());
        const auto columns = static_cast<double>(J.cols());
        count.multiply_adds = rows * columns * (columns + rows);
        while (count.iterations < termination.iterations) {
            ++count.iterations;
            count.multiply_adds += rows * rows * static_cast<double>(system.column_count());
            for (Eigen::Index column = 0; column < system.column_count(); ++column) {
                sweep(system, A, lambda, column);
            }
            if (checked && natural_residual(system, lambda) <= termination.tolerance_low) break;
        }
        return count;
    }
};

}  // namespace

std::unique_ptr<Solver> make_dense() {
    return std::make_unique<Dense>();
}

}  // namespace pushfactor::engine::solvers
