#include "engine/solvers/proximal_newton.h"

#include <algorithm>
#include <cmath>

namespace pushfactor::engine::solvers {

namespace {

using Row = UnitProblem::Row;

constexpr double largest_rho = 1e7;
// Below this residual [m/s] the guess is taken to know most of the clamped rows.
constexpr double warm = 1e-4;
constexpr int most_changes = 4;
constexpr int most_steps = 30;

double clamp(double value, double low, double high) {
    return std::max(std::min(value, high), low);
}

double along(const Row& row, const std::vector<Vector6>& v) {
    return row.axis_a.dot(v[static_cast<std::size_t>(row.a)]) + row.axis_b.dot(v[static_cast<std::size_t>(row.b)]);
}

void push(const Row& row, double y, std::vector<Vector6>& v) {
    v[static_cast<std::size_t>(row.a)].noalias() += row.axis_a * y;
    v[static_cast<std::size_t>(row.b)].noalias() += row.axis_b * y;
}

double dot(const std::vector<Vector6>& a, const std::vector<Vector6>& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i].dot(b[i]);
    return sum;
}

double look_work(const UnitProblem& problem) {
    return 12.0 * static_cast<double>(problem.rows.size());
}

}  // namespace

// x = U^T y and r = t - U x.
void ProximalNewton::follow(const UnitProblem& problem, const std::vector<double>& y) {
    x_.assign(problem.bodies, Vector6::Zero());
    for (std::size_t j = 0; j < y.size(); ++j) push(problem.rows[j], y[j], x_);
    r_.resize(y.size());
    for (std::size_t j = 0; j < y.size(); ++j) r_[j] = problem.rows[j].t - along(problem.rows[j], x_);
}

double ProximalNewton::residual(const UnitProblem& problem, const std::vector<double>& y) {
    follow(problem, y);
    double largest = 0.0;
    for (std::size_t j = 0; j < y.size(); ++j) {
        const Row& row = problem.rows[j];
        largest = std::max(largest, row.scale * std::abs(clamp(y[j] + r_[j], row.low, row.high) - y[j]));
    }
    return largest;
}

// q = 1/2 |U^T y|^2 - t . y [J], which the answer minimises: the energy that the forces give beyond what they are
// asked for, less what roundings make of it. With x as follow() left it.
double ProximalNewton::objective(const UnitProblem& problem, const std::vector<double>& y) const {
    double q = 0.5 * dot(x_, x_);
    for (std::size_t j = 0; j < y.size(); ++j) {
        const double work = problem.rows[j].t * y[j];
        q -= work + 1e-13 * std::abs(work);
    }
    return q;
}

void ProximalNewton::factor(const UnitProblem& problem, double rho, SolveCount& count) {
    if (rho == factored_rho_ && active_ == factored_) return;
    matrix_.set_identity();
    for (std::size_t j = 0; j < active_.size(); ++j) {
        if (!active_[j]) continue;
        const Row& row = problem.rows[j];
        matrix_.add(row.a, row.axis_a, row.b, row.axis_b, rho);
        count.multiply_adds += 108.0;
    }
    matrix_.factor();
    count.multiply_adds += matrix_.factor_work();
    ++count.iterations;
    --left_;
    factored_ = active_;
    factored_rho_ = rho;
}

// One step of the primal-dual active set method: rows that one Jacobi step would leave unclamped are solved
// exactly, the others are set to the bound that it would clamp them to. Judged with rho instead, every small
// residual would look like a change of the active set. Returns whether the active set stayed.
bool ProximalNewton::settle_active_set(const UnitProblem& problem, std::vector<double>& y, SolveCount& count) {
    active_.resize(y.size());
    d_.assign(problem.bodies, Vector6::Zero());
    for (std::size_t j = 0; j < y.size(); ++j) {
        const Row& row = problem.rows[j];
        const double moved = y[j] + r_[j];
        active_[j] = row.scale > 0.0 && moved > row.low && moved < row.high;
        if (active_[j]) {
            push(row, largest_rho * r_[j], d_);
        } else {
            push(row, clamp(moved, row.low, row.high) - y[j], d_);
        }
    }
    const bool stayed = active_ == factored_;
    factor(problem, largest_rho, count);
    matrix_.solve(d_);
    count.multiply_adds += 2.0 * look_work(problem) + matrix_.solve_work();
    for (std::size_t j = 0; j < y.size(); ++j) {
        const Row& row = problem.rows[j];
        const double moved = active_[j] ? y[j] + largest_rho * (r_[j] - along(row, d_)) : y[j] + r_[j];
        y[j] = clamp(moved, row.low, row.high);
    }
    return stayed;
}

// The zero of the derivative along `step_`, which grows with the step: Newton between two ends that close in.
double ProximalNewton::line_search(const UnitProblem& problem, double rho, const std::vector<double>& y,
                                   SolveCount& count) {
    const double start = dot(d_, step_);
    const double curvature = dot(step_, step_);
    double low = 0.0, high = std::numeric_limits<double>::infinity(), size = 1.0;
    for (int k = 0; k < 40; ++k) {
        double derivative = start + size * curvature;
        double slope = curvature;
        for (std::size_t j = 0; j < y.size(); ++j) {
            const Row& row = problem.rows[j];
            const double wanted = rho * (r_[j] - along_[j] - size * step_along_[j]);
            const double taken = clamp(wanted, row.low - y[j], row.high - y[j]);
            derivative -= step_along_[j] * taken;
            if (taken == wanted) slope += rho * step_along_[j] * step_along_[j];
        }
        count.multiply_adds += 3.0 * static_cast<double>(y.size());
        (derivative > 0.0 ? high : low) = size;
        const double newton = size - derivative / slope;
        if (std::abs(newton - size) <= 1e-12 * size) return size;
        const bool inside = newton > low && newton < high;
        size = inside ? newton : std::isfinite(high) ? 0.5 * (low + high) : 2.0 * size;
    }
    return size;
}

void ProximalNewton::proximal_step(const UnitProblem& problem, double rho, std::vector<double>& y,
                                   SolveCount& count) {
    follow(problem, y);
    d_.assign(problem.bodies, Vector6::Zero());
    along_.assign(y.size(), 0.0);
    active_.resize(y.size());
    std::vector<char> before;
    double size = 0.0;
    for (int k = 0; k < most_steps && left_ > 0; ++k) {
        // The negative gradient, and which rows are not clamped.
        step_.assign(problem.bodies, Vector6::Zero());
        for (std::size_t i = 0; i < d_.size(); ++i) step_[i] = -d_[i];
        for (std::size_t j = 0; j < y.size(); ++j) {
            const Row& row = problem.rows[j];
            const double wanted = rho * (r_[j] - along_[j]);
            const double taken = clamp(wanted, row.low - y[j], row.high - y[j]);
            active_[j] = row.scale > 0.0 && taken == wanted;
            push(row, taken, step_);
        }
        if (active_ == before && size == 1.0) break;  // the last step was exact
        before = active_;
        factor(problem, rho, count);
        matrix_.solve(step_);
        step_along_.resize(y.size());
        for (std::size_t j = 0; j < y.size(); ++j) step_along_[j] = along(problem.rows[j], step_);
        size = line_search(problem, rho, y, count);
        for (std::size_t i = 0; i < d_.size(); ++i) d_[i] += size * step_[i];
        for (std::size_t j = 0; j < y.size(); ++j) along_[j] += size * step_along_[j];
        if (std::abs(size - 1.0) < 1e-9) size = 1.0;
        count.multiply_adds += 2.0 * look_work(problem) + matrix_.solve_work();
    }
    for (std::size_t j = 0; j < y.size(); ++j) {
        const Row& row = problem.rows[j];
        y[j] = clamp(y[j] + rho * (r_[j] - along_[j]), row.low, row.high);
    }
}

double ProximalNewton::solve(const UnitProblem& problem, double tolerance, int factorisations,
                             std::vector<double>& y, SolveCount& count) {
    left_ = factorisations;
    double reached = residual(problem, y);
    // On the way to an answer the residual may be small while the forces do more work than none would.
    const double allowed = std::max(0.0, objective(problem, y));
    std::vector<double> best = y;
    const auto look = [&] {
        count.multiply_adds += 2.0 * look_work(problem);
        const double now = residual(problem, y);
        const bool better = now < reached && objective(problem, y) <= allowed;
        if (better) {
            reached = now;
            best = y;
        }
        return better;
    };

    // A few changes of the active set often are enough, even from a poor guess, and need no line search.
    for (int k = 0; k < most_changes && reached > tolerance && left_ > 0; ++k) {
        const bool stayed = settle_active_set(problem, y, count);
        if (!look() && stayed) break;
    }
    y = best;
    // Continuation: small rho finds its way through many clamped rows with few changes at a time.
    double rho = reached <= warm ? largest_rho : 10.0;
    int without_gain = 0;
    while (reached > tolerance && left_ > 0 && without_gain < 2) {
        proximal_step(problem, rho, y, count);
        const bool better = look();
        if (rho == largest_rho) without_gain = better ? 0 : without_gain + 1;
        rho = std::min(30.0 * rho, largest_rho);
    }
    y = best;
    return reached;
}

}  // namespace pushfactor::engine::solvers
