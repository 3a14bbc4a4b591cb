#include "engine/solvers/interior_point.h"

#include <limits>

namespace pushfactor::engine::solvers {

namespace {

using Row = UnitProblem::Row;

constexpr double unbounded_weight = 1e7;
constexpr double largest_weight = 1e12;
// What is kept of the way to the nearest bound.
constexpr double share_of_the_way = 0.995;
constexpr int most_steps = 80;
constexpr int most_without_gain = 40;

}  // namespace

// Inside the bounds, at a distance that suits the problem, with multipliers of that size.
void InteriorPoint::start(const UnitProblem& problem, const std::vector<double>& y) {
    double typical = std::numeric_limits<double>::min();
    for (std::size_t j = 0; j < y.size(); ++j) {
        typical = std::max({typical, std::abs(problem.rows[j].t), std::abs(r_[j])});
    }
    points_.assign(y.size(), {});
    for (std::size_t j = 0; j < y.size(); ++j) {
        const Row& row = problem.rows[j];
        Point& point = points_[j];
        point.y = y[j];
        if (!(row.scale > 0.0) || !(row.high > row.low)) continue;
        point.w = 1.0;
        point.low = std::isfinite(row.low);
        point.high = std::isfinite(row.high);
        const double room = 0.5 * (row.high - row.low);
        const double distance = std::min(typical, 0.5 * room);
        if (point.low) point.y = std::max(point.y, row.low + distance);
        if (point.high) point.y = std::min(point.y, row.high - distance);
        if (point.low) point.z_low = typical;
        if (point.high) point.z_high = typical;
    }
}

// The mean complementarity after `share` of the step.
double InteriorPoint::gap(const UnitProblem& problem, double share) const {
    double sum = 0.0;
    int bounds = 0;
    for (std::size_t j = 0; j < points_.size(); ++j) {
        const Point& point = points_[j];
        const double y = point.y + share * point.dy;
        // Added up so that the mirrored problem, whose bounds have changed sides, gives the same number.
        const double low = point.low ? (y - problem.rows[j].low) * (point.z_low + share * point.dz_low) : 0.0;
        const double high = point.high ? (problem.rows[j].high - y) * (point.z_high + share * point.dz_high) : 0.0;
        sum += low + high;
        bounds += point.low + point.high;
    }
    return bounds > 0 ? sum / bounds : 0.0;
}

// The share of the step after which the first bound is met, at most 1.
double InteriorPoint::longest_step(const UnitProblem& problem) const {
    double share = 1.0;
    const auto limit = [&share](double value, double change) {
        if (change < 0.0) share = std::min(share, -value / change);
    };
    for (std::size_t j = 0; j < points_.size(); ++j) {
        const Point& point = points_[j];
        if (point.low) {
            limit(point.y - problem.rows[j].low, point.dy);
            limit(point.z_low, point.dz_low);
        }
        if (point.high) {
            limit(problem.rows[j].high - point.y, -point.dy);
            limit(point.z_high, point.dz_high);
        }
    }
    return share;
}

void InteriorPoint::factor(BodyMatrix& matrix, const UnitProblem& problem, SolveCount& count) {
    matrix.set_identity();
    for (std::size_t j = 0; j < points_.size(); ++j) {
        const Row& row = problem.rows[j];
        Point& point = points_[j];
        if (point.w == 0.0) continue;
        double theta = 0.0;
        if (point.low) theta += point.z_low / (point.y - row.low);
        if (point.high) theta += point.z_high / (row.high - point.y);
        point.w = point.low || point.high ? std::min(1.0 / theta, largest_weight) : unbounded_weight;
        matrix.add(row.a, row.unit->a, row.b, row.unit->b, point.w);
    }
    matrix.factor();
    ++count.iterations;
    count.multiply_adds += 108.0 * static_cast<double>(points_.size()) + matrix.factor_work();
}

// The step towards a complementarity of `target`; with `second_order` the products of the last step's changes are
// taken into account.
void InteriorPoint::aim(const BodyMatrix& matrix, const UnitProblem& problem, double target, bool second_order,
                        SolveCount& count) {
    q_.resize(points_.size());
    d_.assign(problem.bodies, Vector6::Zero());
    for (std::size_t j = 0; j < points_.size(); ++j) {
        const Row& row = problem.rows[j];
        Point& point = points_[j];
        const double to_low = point.y - row.low, to_high = row.high - point.y;
        const double low = target - (second_order ? point.dy * point.dz_low : 0.0);
        const double high = target + (second_order ? point.dy * point.dz_high : 0.0);
        // Here the multipliers themselves; their change once dy is known.
        point.dz_low = point.low ? low / to_low : 0.0;
        point.dz_high = point.high ? high / to_high : 0.0;
        q_[j] = r_[j] + (point.dz_low - point.dz_high);
        push(row, point.w * q_[j], d_);
    }
    matrix.solve(d_);
    for (std::size_t j = 0; j < points_.size(); ++j) {
        const Row& row = problem.rows[j];
        Point& point = points_[j];
        point.dy = point.w * (q_[j] - along(row, d_));
        if (point.low) point.dz_low -= point.z_low + point.z_low / (point.y - row.low) * point.dy;
        if (point.high) point.dz_high -= point.z_high - point.z_high / (row.high - point.y) * point.dy;
    }
    count.multiply_adds += 2.0 * problem.look_work() + matrix.solve_work();
}

void InteriorPoint::go(const UnitProblem& problem, double share) {
    for (std::size_t j = 0; j < points_.size(); ++j) {
        Point& point = points_[j];
        point.y = clamped(problem.rows[j], point.y + share * point.dy);
        point.z_low += share * point.dz_low;
        point.z_high += share * point.dz_high;
    }
}

double InteriorPoint::solve(BodyMatrix& matrix, const UnitProblem& problem, double tolerance, int factorisations,
                            std::vector<double>& y, SolveCount& count) {
    follow(problem, y, x_, r_);
    best_.start(problem, y, x_, r_);
    start(problem, y);
    int without_gain = 0;
    for (int k = 0; k < std::min(factorisations, most_steps) && without_gain < most_without_gain; ++k) {
        y_.resize(points_.size());
        for (std::size_t j = 0; j < y_.size(); ++j) y_[j] = points_[j].y;
        follow(problem, y_, x_, r_);
        count.multiply_adds += 2.0 * problem.look_work();
        without_gain = best_.look(problem, y_, x_, r_) ? 0 : without_gain + 1;
        if (best_.residual() <= tolerance) break;

        // Predictor, then corrector with the same factor.
        factor(matrix, problem, count);
        aim(matrix, problem, 0.0, false, count);
        const double here = gap(problem, 0.0);
        const double ahead = gap(problem, longest_step(problem));
        const double sigma = here > 0.0 ? std::pow(ahead / here, 3) : 0.0;
        aim(matrix, problem, sigma * here, true, count);
        const double share = longest_step(problem);
        go(problem, share < 1.0 ? share_of_the_way * share : 1.0);
    }
    y = best_.y();
    return best_.residual();
}

}  // namespace pushfactor::engine::solvers
