#include "tests/peers/problems/contact_problem.h"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace pushfactor::tests::problems {

double LocalProblem::asymmetry() const {
    const SparseMatrix difference = matrix - SparseMatrix(matrix.transpose());
    double largest = 0.0, scale = 0.0;
    for (Eigen::Index k = 0; k < difference.nonZeros(); ++k) {
        largest = std::max(largest, std::abs(difference.valuePtr()[k]));
    }
    for (Eigen::Index k = 0; k < matrix.nonZeros(); ++k) scale = std::max(scale, std::abs(matrix.valuePtr()[k]));
    return scale > 0.0 ? largest / scale : 0.0;
}

namespace {

using Factors = Eigen::SimplicialLDLT<SparseMatrix>;

void factorise(const GlobalProblem& problem, Factors& factors) {
    factors.compute(problem.mass);
    if (factors.info() != Eigen::Success) throw std::runtime_error(problem.title + ": M is singular");
}

}  // namespace

engine::VectorX velocities_of(const GlobalProblem& problem, const engine::VectorX& impulses) {
    Factors factors;
    factorise(problem, factors);
    return factors.solve(problem.axes * impulses + problem.force);
}

LocalProblem local_form(const GlobalProblem& problem) {
    Factors factors;
    factorise(problem, factors);
    const SparseMatrix transposed = problem.axes.transpose();
    LocalProblem local{.title = problem.title,
                       .matrix = transposed * SparseMatrix(factors.solve(problem.axes)),
                       .free = problem.given + transposed * factors.solve(problem.force),
                       .mu = problem.mu};
    local.matrix.makeCompressed();
    return local;
}

LocalProblem local_form(const ContactProblem& problem) {
    const auto* const global = std::get_if<GlobalProblem>(&problem);
    return global ? local_form(*global) : std::get<LocalProblem>(problem);
}

}  // namespace pushfactor::tests::problems
