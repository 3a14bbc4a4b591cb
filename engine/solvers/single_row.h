// Direct solution for an island of a single row, such as a pendulum, by 7.1.1. Internal to the solvers.
#pragma once

#include "engine/solvers/solver.h"

#include <algorithm>
#include <cmath>

namespace pushfactor::engine::solvers {

// lambda = clamp(b / A_jj). Counted as one sweep.
inline SolveCount solve_single_row(const SystemEquation& system, const Island& island, Columns& lambda) {
    const Eigen::Index j = island.runs.front().begin;
    const ConstraintRow& row = system.rows[static_cast<std::size_t>(j)];
    const double diagonal = system.diagonal[j];
    const Eigen::Index last = lambda.cols() - 1;
    const auto answer = [&](Eigen::Index column) {
        if (!(diagonal > 0.0)) return 0.0;
        const auto [low, high] = bounds_of(row, lambda, column);
        return std::max(std::min(system.b(j, column) / diagonal, high), low);
    };
    const double first = answer(0);
    const double second = island.columns == 2 ? answer(1) : first;
    SolveCount count{.iterations = 1, .multiply_adds = 24.0 * island.columns};
    lambda(j, 0) = first;
    lambda(j, last) = second;
    return count;
}

}  // namespace pushfactor::engine::solvers
