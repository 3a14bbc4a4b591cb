// Converged forces by the active set method, and the error of forces against them.
#include "demos/reports/error/true_errors.h"
#include "engine/solvers/solver.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pushfactor::demos::reports::error {

namespace {

using engine::Columns;
using engine::SystemEquation;
using engine::Vector6;

constexpr double unbounded = std::numeric_limits<double>::infinity();
constexpr double converged_residual = 1e-10;  // m/s, natural map

// x^T A x of one column.
double energy(const SystemEquation& system, const Columns& x, Eigen::Index column) {
    std::vector<Vector6> forces;
    constraint_forces(system, x, column, forces);
    double sum = 0.0;
    for (std::size_t i = 0; i < forces.size(); ++i) {
        sum += forces[i].dot(accelerate(system.inverse_mass[i], forces[i]));
    }
    return sum;
}

// A, column by column.
engine::MatrixX dense_matrix(const SystemEquation& system) {
    const Eigen::Index count = system.row_count();
    engine::MatrixX A(count, count);
    Columns unit = Columns::Zero(count, 1);
    std::vector<Vector6> forces;
    for (Eigen::Index i = 0; i < count; ++i) {
        unit(i, 0) = 1.0;
        constraint_forces(system, unit, 0, forces);
        unit(i, 0) = 0.0;
        for (Eigen::Index j = 0; j < count; ++j) {
            A(j, i) = acceleration_along(system, static_cast<std::size_t>(j), forces);
        }
    }
    return A;
}

// The bounds of row `j` with all other forces fixed: for a disc, the chord through it.
engine::Interval range_of(const SystemEquation& system, const Columns& lambda, Eigen::Index j,
                          Eigen::Index column) {
    const engine::ConstraintRow& row = system.rows[static_cast<std::size_t>(j)];
    const engine::Interval bounds = bounds_of(row, lambda, column);
    if (row.bounds.disc == engine::Disc::none) return bounds;
    const double other = lambda(row.bounds.disc == engine::Disc::first ? j + 1 : j - 1, column);
    const double half = std::sqrt(std::max(0.0, bounds.high * bounds.high - other * other));
    return {-half, half};
}

// Adds a share of `change`, at most `most`, to the free rows of a column, up to the first that reaches a bound.
// Returns the share; infinity, and no change, if `most` is infinite and no row reaches a bound.
double move(const SystemEquation& system, const std::vector<Eigen::Index>& free, const engine::VectorX& change,
            double most, Columns& lambda, Eigen::Index column) {
    const auto way = [&](std::size_t k) {
        const double speed = change[static_cast<Eigen::Index>(k)];
        const auto [low, high] = range_of(system, lambda, free[k], column);
        const double bound = speed > 0.0 ? high : low;
        return std::pair{bound, speed == 0.0 ? unbounded : (bound - lambda(free[k], column)) / speed};
    };
    double share = most;
    for (std::size_t k = 0; k < free.size(); ++k) share = std::min(share, way(k).second);
    if (share == unbounded) return share;
    for (std::size_t k = 0; k < free.size(); ++k) {
        const auto [bound, reached] = way(k);
        double& value = lambda(free[k], column);
        // Exactly on the bound, without rounding.
        value = reached <= share ? bound : value + share * change[static_cast<Eigen::Index>(k)];
    }
    for (const Eigen::Index j : free) clamp_force(system.rows, j, column, lambda);
    return share;
}

// Active set method: solves A lambda = b for the rows between their bounds; a row that reaches a bound on the way
// stays there, and the rest is solved again without it. A is rank-deficient where boxes touch, so the minimum-norm
// change is taken; forces along an error that remains grow until a row reaches a bound.
void finish_free_rows(const SystemEquation& system, const engine::MatrixX& A, Columns& lambda,
                      Eigen::Index column) {
    for (Eigen::Index turn = 0; turn < 2 * lambda.rows(); ++turn) {
        std::vector<Eigen::Index> free;
        for (Eigen::Index j = 0; j < lambda.rows(); ++j) {
            const auto [low, high] = range_of(system, lambda, j, column);
            if (lambda(j, column) > low && lambda(j, column) < high && system.diagonal[j] > 0.0) free.push_back(j);
        }
        if (free.empty()) return;
        const engine::VectorX all = system.b.col(column) - A * lambda.col(column);
        const engine::VectorX error = all(free);
        const engine::MatrixX A_free = A(free, free);
        const engine::VectorX change = A_free.completeOrthogonalDecomposition().solve(error);
        if (move(system, free, change, 1.0, lambda, column) < 1.0) continue;
        const engine::VectorX unmet = error - A_free * change;
        if (system.dt * unmet.cwiseAbs().maxCoeff() < 0.1 * converged_residual) return;
        if (move(system, free, unmet, unbounded, lambda, column) == unbounded) return;
    }
}

}  // namespace

std::optional<double> force_error(const SystemEquation& system, const Columns& lambda, const Columns& converged) {
    const Columns difference = lambda - converged;
    std::optional<double> worst;
    for (Eigen::Index column = 0; column < lambda.cols(); ++column) {
        const double whole = energy(system, converged, column);
        if (!(whole > 0.0)) continue;
        worst = std::max(worst.value_or(0.0), std::sqrt(energy(system, difference, column) / whole));
    }
    return worst;
}

std::optional<Columns> converged_forces(const SystemEquation& system, const Columns& guess) {
    Columns answer = guess;
    // Without tolerances: a guess that was kept would be its own reference and have no error.
    const auto converges = [&](const char* solver, int iterations) {
        engine::solvers::make_solver(solver)->solve(system, {.iterations = iterations}, answer);
        return answer.allFinite() && natural_residual(system, answer) <= converged_residual;
    };
    if (converges("direct", 100)) return answer;

    // Sweeps find the active set long before they converge on the remaining linear system: some modes, such as bars
    // that hold each other through contacts, need more than a hundred thousand sweeps.
    answer = guess;
    if (converges("pgs", 500)) return answer;
    const engine::MatrixX A = dense_matrix(system);
    for (int round = 0; round < 40; ++round) {
        for (Eigen::Index column = 0; column < answer.cols(); ++column) {
            finish_free_rows(system, A, answer, column);
        }
        if (natural_residual(system, answer) <= converged_residual || converges("pgs", 25)) return answer;
    }
    return std::nullopt;
}

}  // namespace pushfactor::demos::reports::error
