#include "engine/solvers/exact/interior_point.h"

#include <limits>

namespace pushfactor::engine::solvers {

namespace {

// Smaller is better, until rounding errors of the factors show: earlier for unsymmetric ones and for rows without
// bounds. Contacts under heavy load need a small value: the residual is the force error that delta leaves, divided
// by delta.
constexpr double delta_symmetric = 1e-8;
constexpr double delta_general = 1e-7;
constexpr double delta_discs = 1e-11;
// Error of a distance below this share of the force counts as zero: near the end distances are smaller than it.
constexpr double rounding = 1e-15;
// Bounds closer to each other than this share of a typical force leave nothing to solve for; between them every
// step would be cut to an equally small share.
constexpr double thin = 1e-9;
// Least initial distance from a bound, as a share of a typical force.
constexpr double least_distance = 1e-6;
// Share of its radius up to which forces initially fill a disc.
constexpr double most_of_a_disc = 0.5;
// Least target while discs are in error: this share of the error, but at most least_sigma_in_error of the gap.
constexpr double target_per_error = 0.01;
constexpr double least_sigma_in_error = 0.1;
// A predictor step shorter than this is useless.
constexpr double short_predictor = 0.1;
constexpr double sigma_without_predictor = 0.3;
// Share of the distance to the nearest bound per step; larger for steps of nearly full length.
constexpr double most_of_the_way = 0.99;
constexpr double long_step = 0.9;
constexpr double most_of_a_long_way = 0.9995;
// A non-convex problem is jammed after most_short_steps consecutive steps below this share.
constexpr double short_step = 0.05;
constexpr int most_short_steps = 6;
// Stall: this many steps without a smaller residual or a gap below `gain` of its minimum.
constexpr double gain = 0.9;
constexpr int most_steps_without_gain = 10;

}  // namespace

// Largest change of a force that a row asks for by itself, at y or at zero forces.
double InteriorPoint::typical_force(const UnitProblem& problem, const std::vector<double>& y) const {
    double typical = std::numeric_limits<double>::min();
    for (std::size_t j = 0; j < y.size(); ++j) {
        const UnitRow& row = problem.rows[j];
        const double here = clamped(row, y[j] + r_[j], bound_scale(row, y)) - y[j];
        const double from_zero = clamped(row, row.t, 1.0);
        typical = std::max({typical, std::abs(here), row.leader < 0 ? std::abs(from_zero) : std::abs(row.t)});
    }
    return typical;
}

// Starting point: inside the bounds, at a distance that suits the problem, with multipliers of that size.
void InteriorPoint::start(const UnitProblem& problem, const std::vector<double>& y) {
    const double typical = typical_force(problem, y);
    points_.assign(y.size(), {});
    discs_.clear();
    for (std::size_t j = 0; j < y.size(); ++j) {
        const UnitRow& row = problem.rows[j];
        Point& point = points_[j];
        if (row.disc != Disc::none) {
            if (row.disc == Disc::second) start_disc(problem, y, j, typical);
            continue;
        }
        const Point* leader = row.leader < 0 ? nullptr : &points_[static_cast<std::size_t>(row.leader)];
        const double scale = leader ? leader->y : 1.0;
        const double low = row.low * scale, high = row.high * scale;
        point.y = std::max(std::min(y[j], high), low);
        const double width = row.high - row.low;  // of a row that follows: per unit of its leader's force
        if (!(row.scale > 0.0) || !(leader ? width > thin : width > thin * typical)) continue;
        if (leader && !(leader->w > 0.0) && !(high - low > thin * typical)) continue;
        point.w = 1.0;
        if (leader) point.leader = row.leader;
        const double distance = std::min(typical, 0.25 * (high - low));
        const auto begin = [&](Bound& bound, double to_bound) {
            bound.is = true;
            bound.s = std::max(to_bound, least_distance * typical);
            bound.z = typical;
        };
        if (std::isfinite(low)) point.y = std::max(point.y, low + distance);
        if (std::isfinite(high)) point.y = std::min(point.y, high - distance);
        if (std::isfinite(low)) begin(point.low, point.y - low);
        if (std::isfinite(high)) begin(point.high, high - point.y);
    }
}

// Both rows of the disc whose second row is `j`.
void InteriorPoint::start_disc(const UnitProblem& problem, const std::vector<double>& y, std::size_t j,
                               double typical) {
    const UnitRow& row = problem.rows[j];
    const Point* leader = row.leader < 0 ? nullptr : &points_[static_cast<std::size_t>(row.leader)];
    const double radius = row.high * (leader ? leader->y : 1.0);
    Point &first = points_[j - 1], &second = points_[j];
    const double share = share_in_disc(y[j - 1] * y[j - 1] + y[j] * y[j], radius);
    first.y = share * y[j - 1];
    second.y = share * y[j];
    if (!(row.scale > 0.0) || !(leader ? row.high > thin : row.high > thin * typical)) return;
    if (leader && !(leader->w > 0.0) && !(radius > thin * typical)) return;
    const double inside = share_in_disc(first.y * first.y + second.y * second.y, most_of_a_disc * radius);
    first.y *= inside;
    second.y *= inside;
    const bool follows =
        leader && leader->w > 0.0 && act_on_the_same(problem.rows[static_cast<std::size_t>(row.leader)], row);
    discs_.push_back({.second = j, .per_leader = leader ? row.high : 0.0, .follows = follows, .z = typical});
}

void InteriorPoint::look_at(const UnitProblem& problem, DiscPoint& disc) const {
    const UnitRow &first = problem.rows[disc.second - 1], &second = problem.rows[disc.second];
    disc.radius = second.high * bound_scale(second, y_);
    disc.e_1 = y_[disc.second - 1] / disc.radius;
    disc.e_2 = y_[disc.second] / disc.radius;
    const double e = std::sqrt(disc.filled());
    disc.d_1 = e > 0.0 ? disc.e_1 / e : 1.0;
    disc.d_2 = e > 0.0 ? disc.e_2 / e : 0.0;
    disc.along = between(first, disc.d_1, second, disc.d_2);
    disc.across = between(first, -disc.d_2, second, disc.d_1);
}

// Evaluates the current forces, clamped to their bounds; then computes the terms of the Newton step.
void InteriorPoint::look(const UnitProblem& problem) {
    y_.resize(points_.size());
    for (std::size_t j = 0; j < y_.size(); ++j) y_[j] = points_[j].y;
    clamp(problem, y_);
    follow(problem, y_, x_, r_);
    best_.look(problem, y_, x_, r_);

    for (std::size_t j = 0; j < y_.size(); ++j) y_[j] = points_[j].y;
    follow(problem, y_, x_, r_);
    for (std::size_t j = 0; j < y_.size(); ++j) {
        const UnitRow& row = problem.rows[j];
        Point& point = points_[j];
        const double scale = bound_scale(row, y_);
        const auto error = [&](double bound, double distance, double s) {
            const double p = distance - s;
            return std::abs(p) <= rounding * std::max(std::abs(bound), std::abs(point.y)) ? 0.0 : p;
        };
        if (point.low.is) point.low.error = error(row.low * scale, point.y - row.low * scale, point.low.s);
        if (point.high.is) point.high.error = error(row.high * scale, row.high * scale - point.y, point.high.s);
    }
    for (DiscPoint& disc : discs_) look_at(problem, disc);
}

// Mean complementarity after `share` of the step.
double InteriorPoint::mean_gap(double share) const {
    const auto gap = [share](const Bound& bound) {
        return bound.is ? (bound.s + share * bound.ds) * (bound.z + share * bound.dz) : 0.0;
    };
    double sum = 0.0;
    int bounds = 0;
    for (const Point& point : points_) {
        sum += gap(point.low) + gap(point.high);
        bounds += point.low.is + point.high.is;
    }
    for (const DiscPoint& disc : discs_) {
        const double radius = disc.radius + share * disc.d_radius;
        // If R grows t moves linearly; de is for constant R.
        const double own = disc.d_radius > 0.0 ? disc.radius / radius * share : share;
        const double e_1 = disc.e_1 + own * disc.de_1, e_2 = disc.e_2 + own * disc.de_2;
        sum += radius * (1.0 - (e_1 * e_1 + e_2 * e_2)) * (disc.z + share * disc.dz);
        ++bounds;
    }
    return bounds > 0 ? sum / bounds : 0.0;
}

// Mean error of r = z e in the discs, in units of the gap: mean of |r - z e| R. It is nonlinear, so that a full
// step leaves some of it; and if the gap shrinks ahead of it, z e gets stuck.
double InteriorPoint::error_of_discs() const {
    double sum = 0.0;
    for (const DiscPoint& disc : discs_) {
        sum += disc.radius *
               elementary::hypot(r_[disc.second - 1] - disc.z * disc.e_1, r_[disc.second] - disc.z * disc.e_2);
    }
    return discs_.empty() ? 0.0 : sum / static_cast<double>(discs_.size());
}

// Share of the step at which the first distance or multiplier becomes zero, at most 1.
double InteriorPoint::longest_step() const {
    double share = 1.0;
    const auto limit = [&share](double value, double change) {
        if (change < 0.0) share = std::min(share, -value / change);
    };
    for (const Point& point : points_) {
        for (const Bound* bound : {&point.low, &point.high}) {
            if (!bound->is) continue;
            limit(bound->s, bound->ds);
            limit(bound->z, bound->dz);
        }
    }
    for (const DiscPoint& disc : discs_) {
        limit(disc.radius, disc.d_radius);
        limit(disc.z, disc.dz);
        // Up to |e| = 1; in units of R, |e + s de + ...| = 1 + s dR / R if the disc grows.
        const double grows = std::max(0.0, disc.d_radius / disc.radius);
        const double along_1 = disc.de_1 + disc.e_1 * grows, along_2 = disc.de_2 + disc.e_2 * grows;
        const double a = along_1 * along_1 + along_2 * along_2 - grows * grows;
        const double b = disc.e_1 * along_1 + disc.e_2 * along_2 - grows;
        const double under = b * b + a * disc.free();
        const double way = under >= 0.0 ? b + std::sqrt(under) : 0.0;
        if (way > 0.0) share = std::min(share, disc.free() / way);
    }
    return share;
}

void InteriorPoint::factor(const Elimination& order, const UnitProblem& problem) {
    matrix_.begin(order);
    pushed_.start(problem);
    for (std::size_t j = 0; j < points_.size(); ++j) {
        const UnitRow& row = problem.rows[j];
        Point& point = points_[j];
        if (point.w == 0.0) continue;
        const bool in_discs = problem.has_discs && (point.low.is || point.high.is);
        const double delta = in_discs ? delta_discs : problem.bounds_follow ? delta_general : delta_symmetric;
        // This order of summation gives the mirrored problem, with exchanged bounds, the same bits.
        point.w = 1.0 / ((delta + row.soft) + (point.low.ratio() + point.high.ratio()));
        point.c = 0.0;
        if (point.leader < 0) continue;
        if (!act_on_the_same(problem.rows[static_cast<std::size_t>(point.leader)], row)) continue;
        point.c = row.low * point.low.ratio() + row.high * point.high.ratio();
        pushed_.follow(point.leader, point.w * point.c, *row.unit);
    }
    for (DiscPoint& disc : discs_) {
        const double damper = disc.z / disc.radius, free = disc.free();
        disc.w_across = 1.0 / (delta_discs + damper);
        disc.w_along = 1.0 / (delta_discs + damper * (1.0 + disc.filled()) / free);
        disc.c = disc.follows ? disc.per_leader * damper * 2.0 * std::sqrt(disc.filled()) / free : 0.0;
        if (!disc.follows) continue;
        pushed_.follow(problem.rows[disc.second].leader, disc.w_along * disc.c, disc.along);
    }
    for (const DiscPoint& disc : discs_) {
        const UnitRow& row = problem.rows[disc.second];
        matrix_.add(row.a, disc.along.a, row.b, disc.along.b, disc.w_along);
        matrix_.add(row.a, disc.across.a, row.b, disc.across.b, disc.w_across);
    }
    for (std::size_t j = 0; j < points_.size(); ++j) {
        if (points_[j].w != 0.0) pushed_.add(problem, j, points_[j].w, matrix_);
    }
    matrix_.factor();
}

// Newton step towards a complementarity of `target`, with `second_order` times the products of the last step's
// changes (Mehrotra corrector).
void InteriorPoint::aim(const UnitProblem& problem, double target, double second_order) {
    pushes_.resize(points_.size());
    for (std::size_t j = 0; j < points_.size(); ++j) {
        Point& point = points_[j];
        const auto aim_at = [&](Bound& bound) {
            if (!bound.is) return;
            // dz holds the multiplier for a fixed row here, and its change once the step is known.
            bound.dz = (target - second_order * bound.ds * bound.dz - bound.z * bound.error) / bound.s;
        };
        aim_at(point.low);
        aim_at(point.high);
        point.own = point.w * (r_[j] + (point.low.dz - point.high.dz));
        if (point.c != 0.0) point.own += point.w * point.c * points_[static_cast<std::size_t>(point.leader)].own;
        pushes_[j] = point.own;
    }
    for (DiscPoint& disc : discs_) {
        // dz holds the multiplier for fixed forces here, as above.
        const double dh =
            disc.free() * disc.d_radius - 2.0 * disc.radius * (disc.e_1 * disc.de_1 + disc.e_2 * disc.de_2);
        disc.dz = (target - second_order * dh * disc.dz) / (disc.radius * disc.free());
        const double r_1 = r_[disc.second - 1] - disc.e_1 * disc.dz, r_2 = r_[disc.second] - disc.e_2 * disc.dz;
        disc.own_along = disc.w_along * (disc.d_1 * r_1 + disc.d_2 * r_2);
        disc.own_across = disc.w_across * (disc.d_1 * r_2 - disc.d_2 * r_1);
        const UnitRow& row = problem.rows[disc.second];
        if (disc.follows) {
            disc.own_along += disc.w_along * disc.c * points_[static_cast<std::size_t>(row.leader)].own;
        }
        pushes_[disc.second - 1] = disc.d_1 * disc.own_along - disc.d_2 * disc.own_across;
        pushes_[disc.second] = disc.d_2 * disc.own_along + disc.d_1 * disc.own_across;
    }
    d_.assign(problem.bodies, Vector6::Zero());
    push(problem, pushes_, d_);
    matrix_.solve(d_);
    find_steps(problem);
    // One step of iterative refinement: the velocities due to the steps differ from d by rounding errors, because
    // the weights differ by many decades.
    missed_.assign(problem.bodies, Vector6::Zero());
    for (std::size_t j = 0; j < points_.size(); ++j) pushes_[j] = points_[j].dy;
    push(problem, pushes_, missed_);
    for (std::size_t i = 0; i < missed_.size(); ++i) missed_[i] -= d_[i];
    matrix_.solve(missed_);
    for (std::size_t i = 0; i < missed_.size(); ++i) d_[i] += missed_[i];
    find_steps(problem);
    for (std::size_t j = 0; j < points_.size(); ++j) {
        const UnitRow& row = problem.rows[j];
        Point& point = points_[j];
        if (point.w == 0.0) continue;
        const double of_leader = point.leader < 0 ? 0.0 : points_[static_cast<std::size_t>(point.leader)].dy;
        const auto step = [](Bound& bound, double ds) {
            if (!bound.is) return;
            bound.ds = ds + bound.error;
            bound.dz -= bound.z + bound.ratio() * ds;
        };
        step(point.low, point.dy - row.low * of_leader);
        step(point.high, (point.leader < 0 ? 0.0 : row.high * of_leader) - point.dy);
    }
    for (DiscPoint& disc : discs_) {
        const Point &first = points_[disc.second - 1], &second = points_[disc.second];
        const int leader = problem.rows[disc.second].leader;
        disc.d_radius = leader < 0 ? 0.0 : disc.per_leader * points_[static_cast<std::size_t>(leader)].dy;
        disc.de_1 = (first.dy - disc.e_1 * disc.d_radius) / disc.radius;
        disc.de_2 = (second.dy - disc.e_2 * disc.d_radius) / disc.radius;
        disc.dz -= disc.z + disc.z * (disc.d_radius / disc.radius -
                                      2.0 * (disc.e_1 * disc.de_1 + disc.e_2 * disc.de_2) / disc.free());
    }
}

// Steps of the forces that follow from d.
void InteriorPoint::find_steps(const UnitProblem& problem) {
    find_speeds(problem, d_, speeds_);
    for (std::size_t j = 0; j < points_.size(); ++j) {
        Point& point = points_[j];
        if (point.w == 0.0) continue;
        double of_leader = 0.0;
        if (point.c != 0.0) {
            const Point& leader = points_[static_cast<std::size_t>(point.leader)];
            of_leader = point.c * (leader.dy - leader.own);
        }
        point.dy = point.own + point.w * (of_leader - speeds_[j]);
    }
    for (const DiscPoint& disc : discs_) {
        const UnitRow& row = problem.rows[disc.second];
        double of_leader = 0.0;
        if (disc.follows) {
            const Point& leader = points_[static_cast<std::size_t>(row.leader)];
            of_leader = disc.c * (leader.dy - leader.own);
        }
        const double first = speeds_[disc.second - 1], second = speeds_[disc.second];
        const double step_along =
            disc.own_along + disc.w_along * (of_leader - (disc.d_1 * first + disc.d_2 * second));
        const double step_across = disc.own_across - disc.w_across * (disc.d_1 * second - disc.d_2 * first);
        points_[disc.second - 1].dy = disc.d_1 * step_along - disc.d_2 * step_across;
        points_[disc.second].dy = disc.d_2 * step_along + disc.d_1 * step_across;
    }
}

void InteriorPoint::go(double share) {
    for (Point& point : points_) {
        point.y += share * point.dy;
        for (Bound* bound : {&point.low, &point.high}) {
            bound->s += share * bound->ds;
            bound->z += share * bound->dz;
        }
    }
    for (DiscPoint& disc : discs_) {
        const double radius = disc.radius + share * disc.d_radius;
        disc.z += share * disc.dz;
        if (disc.d_radius > 0.0) continue;
        points_[disc.second - 1].y = radius * (disc.e_1 + share * disc.de_1);
        points_[disc.second].y = radius * (disc.e_2 + share * disc.de_2);
    }
}

// Predictor, then corrector with the same factor. Returns the share of the step that was taken.
double InteriorPoint::step(const Elimination& order, const UnitProblem& problem) {
    factor(order, problem);
    aim(problem, 0.0, 0.0);
    const double foreseen = longest_step();
    const double here = mean_gap(0.0);
    const double left = here > 0.0 ? mean_gap(foreseen) / here : 0.0;
    double sigma = left * left * left;
    const bool blind = foreseen < short_predictor;
    if (blind) sigma = std::max(sigma, sigma_without_predictor);
    const double least = std::min(least_sigma_in_error * here, target_per_error * error_of_discs());
    aim(problem, std::max(sigma * here, least), blind ? 0.0 : foreseen);
    const double longest = longest_step();
    const double share =
        longest < 1.0 ? (longest > long_step ? most_of_a_long_way : most_of_the_way) * longest : 1.0;
    go(share);
    return share;
}

double InteriorPoint::solve(const Elimination& order, const UnitProblem& problem, double tolerance, int steps,
                            std::vector<double>& y, Effort& effort, SolveCount& count) {
    follow(problem, y, x_, r_);
    best_.start(problem, y, x_, r_);
    start(problem, y);
    const double most = order.general_work() + problem.assembly_work();
    double least_gap = infinity;
    int without_gain = 0, short_steps = 0;
    for (int k = 0; k <= steps; ++k) {
        const double before = best_.residual();
        look(problem);
        // The natural residual of a point far inside its bounds says little; progress is judged by the gap.
        const double gap = mean_gap(0.0);
        without_gain = best_.residual() < before || gap < gain * least_gap ? 0 : without_gain + 1;
        least_gap = std::min(least_gap, gap);
        const bool jammed = problem.bounds_follow && short_steps >= most_short_steps;
        if (best_.residual() <= tolerance || without_gain > most_steps_without_gain || jammed) break;
        if (k == steps || !effort.affords(most)) break;

        const double share = step(order, problem);
        short_steps = share < short_step ? short_steps + 1 : 0;
        const double work = problem.assembly_work() + matrix_.factor_work() +
                            solve_work(order, static_cast<double>(problem.rows.size()));
        effort.spend_factorisation(work);
        count.multiply_adds += work;
        ++count.iterations;
    }
    y = best_.y();
    return best_.residual();
}

}  // namespace pushfactor::engine::solvers
