#include "engine/solvers/active_set.h"

namespace pushfactor::engine::solvers {

namespace {

using Row = UnitProblem::Row;

constexpr double rho = 1e7;
// Changes that improve nothing before the method gives up.
constexpr int most_without_gain = 3;

}  // namespace

void ActiveSet::factor(BodyMatrix& matrix, const UnitProblem& problem, SolveCount& count) {
    if (free_ == factored_) return;
    matrix.set_identity();
    for (std::size_t j = 0; j < free_.size(); ++j) {
        if (!free_[j]) continue;
        const Row& row = problem.rows[j];
        matrix.add(row.a, row.unit->a, row.b, row.unit->b, rho);
        count.multiply_adds += 108.0;
    }
    matrix.factor();
    count.multiply_adds += matrix.factor_work();
    ++count.iterations;
    --left_;
    factored_ = free_;
}

// One change. The free rows are judged by a Jacobi step: judged with rho, every small residual would look like a
// change of the active set. Returns whether the free rows are those of the change before.
bool ActiveSet::change(BodyMatrix& matrix, const UnitProblem& problem, std::vector<double>& y, SolveCount& count) {
    free_.resize(y.size());
    d_.assign(problem.bodies, Vector6::Zero());
    for (std::size_t j = 0; j < y.size(); ++j) {
        const Row& row = problem.rows[j];
        const double moved = y[j] + r_[j];
        free_[j] = row.scale > 0.0 && moved > row.low && moved < row.high;
        push(row, free_[j] ? rho * r_[j] : clamped(row, moved) - y[j], d_);
    }
    const bool stayed = free_ == factored_;
    factor(matrix, problem, count);
    matrix.solve(d_);
    for (std::size_t j = 0; j < y.size(); ++j) {
        const Row& row = problem.rows[j];
        y[j] = clamped(row, free_[j] ? y[j] + rho * (r_[j] - along(row, d_)) : y[j] + r_[j]);
    }
    count.multiply_adds += 2.0 * problem.look_work() + matrix.solve_work();
    return stayed;
}

double ActiveSet::solve(BodyMatrix& matrix, const UnitProblem& problem, double tolerance, int factorisations,
                        std::vector<double>& y, SolveCount& count) {
    left_ = factorisations;
    follow(problem, y, x_, r_);
    best_.start(problem, y, x_, r_);
    int without_gain = 0;
    // One change more than the tolerance asks for: it has its factor already and takes the rest down to rounding,
    // which a stack that is not solved again for a minute would add up to a motion.
    for (bool enough = best_.residual() <= tolerance; !enough && left_ > 0 && without_gain < most_without_gain;) {
        enough = best_.residual() <= tolerance;
        const bool stayed = change(matrix, problem, y, count);
        follow(problem, y, x_, r_);
        count.multiply_adds += 2.0 * problem.look_work();
        const bool better = best_.look(problem, y, x_, r_);
        without_gain = better ? 0 : without_gain + 1;
        if (!better && stayed) break;
    }
    y = best_.y();
    return best_.residual();
}

}  // namespace pushfactor::engine::solvers
