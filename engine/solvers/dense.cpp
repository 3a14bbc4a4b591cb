// Paper section 7.2; 7.1.1 is the update of one row. Symbols: A [1/kg], b [m/s^2], lambda, c_min, c_max [N].
//
// With rows and bodies ordered by island, A of the whole system is block diagonal, and outside of the blocks 7.2
// would only multiply zeros: so A here is one block, J M^-1 J^T of the rows and bodies of one island.
//
// Deviations: warm start (6.2.3) instead of zero; a row with A_jj = 0 keeps lambda 0 where the paper divides by it;
// a bound may follow another row's lambda; the two rows of a disc move together, with their common step size
// (system_equation.h). 7.2 reads A[i,j] as column i, row j, 7.1.1 as row, column: the same number, since A is
// symmetric.
#include "engine/solvers/dense.h"

#include <algorithm>

namespace pushfactor::engine::solvers {

namespace {

// Rows of the system, by their number in the island.
std::vector<int> rows_of(const Island& island) {
    std::vector<int> rows;
    for (const RowRun& run : island.runs) {
        for (int j = run.begin; j < run.end; ++j) rows.push_back(j);
    }
    return rows;
}

// J as one c x 6n matrix (6.1.2).
MatrixX stacked_jacobian(const SystemEquation& system, const Island& island) {
    MatrixX jacobian = MatrixX::Zero(island.rows, 6 * Eigen::Index{island.body_count});
    Eigen::Index number = 0;
    for (const RowRun& run : island.runs) {
        for (int j = run.begin; j < run.end; ++j, ++number) {
            const Jacobian& axis = system.rows[static_cast<std::size_t>(j)].jacobian;
            jacobian.block<1, 6>(number, 6 * Eigen::Index{run.a}) += axis.a.transpose();
            jacobian.block<1, 6>(number, 6 * Eigen::Index{run.b}) += axis.b.transpose();
        }
    }
    return jacobian;
}

// M^-1 as one 6n x 6n matrix (6.1.2 in section 6.1.3). The blocks of static bodies are zero.
MatrixX stacked_inverse_mass(const SystemEquation& system, const Island& island) {
    const Eigen::Index size = 6 * Eigen::Index{island.body_count};
    MatrixX inverse_mass = MatrixX::Zero(size, size);
    Eigen::Index at = 0;
    for (const int body : island.bodies) {
        const InverseMass& block = system.inverse_mass[static_cast<std::size_t>(body)];
        inverse_mass.block<3, 3>(at, at) = block.linear * Matrix3::Identity();
        inverse_mass.block<3, 3>(at + 3, at + 3) = block.angular;
        at += 6;
    }
    return inverse_mass;
}

void sweep_dense(const SystemEquation& system, const std::vector<int>& rows, const MatrixX& A, Columns& lambda,
                 Eigen::Index column) {
    double wanted_by_first = 0.0;  // N, of a disc whose second row is next
    for (Eigen::Index i = 0; i < A.rows(); ++i) {
        const int row = rows[static_cast<std::size_t>(i)];
        const Disc disc = system.rows[static_cast<std::size_t>(row)].bounds.disc;
        if (A(i, i) <= 0.0) {
            lambda(row, column) = 0.0;
            continue;
        }
        double value = system.b(row, column);
        for (Eigen::Index k = 0; k < A.cols(); ++k) {
            if (k != i) value -= A(i, k) * lambda(rows[static_cast<std::size_t>(k)], column);
        }
        if (disc == Disc::none) {
            lambda(row, column) = value / A(i, i);
        } else {
            const double step = system.diagonal[row];
            value = lambda(row, column) + (value - A(i, i) * lambda(row, column)) / step;
            if (disc == Disc::first) {
                wanted_by_first = value;
                continue;
            }
            lambda(row - 1, column) = wanted_by_first;
            lambda(row, column) = value;
        }
        clamp_force(system.rows, row, column, lambda);
    }
}

class Dense : public Solver {
  public:
    std::unique_ptr<Solver> another() const override { return std::make_unique<Dense>(); }

    SolveCount solve(const SystemEquation& system, const Island& island, const Termination& termination,
                     Columns& lambda) override {
        const bool checked = termination.tolerance_high > 0.0;
        SolveCount count;

        const MatrixX J = stacked_jacobian(system, island);
        // Lazy: Eigen's other product orders its sums by the size of the processor's caches.
        MatrixX A = MatrixX(J.lazyProduct(stacked_inverse_mass(system, island))).lazyProduct(J.transpose());
        // J M^-1 J^T as two dense products, then a full row of A for each update of lambda.
        const auto size = static_cast<double>(J.rows());
        const auto width = static_cast<double>(J.cols());
        count.multiply_adds = size * width * (width + size);
        const std::vector<int> rows = rows_of(island);
        for (Eigen::Index i = 0; i < A.rows(); ++i) {
            if (A(i, i) > 0.0)
                A(i, i) += system.rows[static_cast<std::size_t>(rows[static_cast<std::size_t>(i)])].softness;
        }
        while (count.iterations < termination.iterations) {
            ++count.iterations;
            count.multiply_adds += size * size * island.columns;
            for (Eigen::Index column = 0; column < island.columns; ++column) {
                sweep_dense(system, rows, A, lambda, column);
            }
            if (checked && island_residual(system, island, lambda) <= termination.tolerance_low) break;
        }
        if (island.columns < lambda.cols()) {
            for (const int row : rows) lambda(row, lambda.cols() - 1) = lambda(row, 0);
        }
        return count;
    }
};

}  // namespace

std::unique_ptr<Solver> make_dense() {
    return std::make_unique<Dense>();
}

}  // namespace pushfactor::engine::solvers
