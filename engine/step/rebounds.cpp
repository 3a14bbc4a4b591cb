#include "engine/step/rebounds.h"

#include <algorithm>
#include <cmath>

namespace pushfactor::engine {

namespace {

// Share of the work that all rows do, whatever its sign, up to which a gain is rounding.
constexpr double rounding = 1e-9;

double along(const ConstraintRow& row, const Vector6& of_a, const Vector6& of_b) {
    return row.jacobian.a.dot(of_a) + row.jacobian.b.dot(of_b);
}

bool rebounds(const SystemEquation& system, const RowRun& run) {
    const std::span<const ConstraintRow> rows =
        system.rows.subspan(static_cast<std::size_t>(run.begin), static_cast<std::size_t>(run.end - run.begin));
    return std::ranges::any_of(rows, [](const ConstraintRow& row) { return row.rebound > 0.0; });
}

// W(k) = a + b k + c k^2 of one pair.
struct Work {
    double a = 0.0, b = 0.0, c = 0.0;

    double at(double k) const { return a + k * (b + k * c); }
    // The largest k up to `most` where W does not exceed zero, if it does at `most`; 0 if there is none.
    double last_zero(double most) const {
        if (!(at(most) > 0.0)) return most;
        if (!(a < 0.0)) return 0.0;
        // a < 0 < W(most): one zero between; the form that does not cancel.
        const double root = std::sqrt(std::max(0.0, b * b - 4.0 * a * c));
        const double k = b > 0.0 ? -2.0 * a / (b + root) : (root - b) / (2.0 * c);
        return std::clamp(k, 0.0, most);
    }
};

}  // namespace

void ImpactWork::find(const SystemEquation& system, std::span<const Body> bodies, const Island& island,
                      const Columns& lambda, const ConstraintForces& forces) {
    const std::vector<Vector6>& found = island.columns == 2 ? forces.lasting : forces.moving;
    const Eigen::Index last = lambda.cols() - 1;
    rows_.clear();
    int pair = 0;
    for (const RowRun& run : island.runs) {
        if (!rebounds(system, run)) continue;
        const ConstraintRow& some = system.rows[static_cast<std::size_t>(run.begin)];
        const auto a = static_cast<std::size_t>(some.body_a), b = static_cast<std::size_t>(some.body_b);
        const auto by_force = [&](std::size_t body) {
            if (bodies[body].is_static()) return Vector6(Vector6::Zero());
            return accelerate(system.inverse_mass[body], stacked(bodies[body].force, bodies[body].torque));
        };
        const auto by_rows = [&](std::size_t body) {
            if (bodies[body].is_static()) return Vector6(Vector6::Zero());
            return accelerate(system.inverse_mass[body], found[body]);
        };
        const Vector6 force_a = by_force(a), force_b = by_force(b), rows_a = by_rows(a), rows_b = by_rows(b);
        double since = 0.0;  // of the point's normal row
        for (int j = run.begin; j < run.end; ++j) {
            const auto number = static_cast<std::size_t>(j);
            const ConstraintRow& row = system.rows[number];
            if (row.label.kind != RowKind::contact && row.label.kind != RowKind::friction) continue;
            const bool is_normal = row.label.kind == RowKind::contact;
            if (is_normal) since = row.since_impact;
            const double belt = is_normal ? 0.0 : row.push.lasting;
            const double before = system.dt * unconstrained(system, number);
            const double change = system.dt * along(row, rows_a, rows_b);
            rows_.push_back({.pair = pair,
                             .impulse = system.dt * lambda(j, last),
                             .speed = before + 0.5 * change - since * along(row, force_a, force_b) - belt});
        }
        ++pair;
    }
}

bool ImpactWork::gains() const {
    for (std::size_t begin = 0, end = 0; begin < rows_.size(); begin = end) {
        double work = 0.0, all = 0.0;
        for (; end < rows_.size() && rows_[end].pair == rows_[begin].pair; ++end) {
            const double own = rows_[end].impulse * rows_[end].speed;
            work += own;
            all += std::abs(own);
        }
        if (work > rounding * all) return true;
    }
    return false;
}

double ImpactWork::share_without_gain(const ImpactWork& stopped) const {
    double share = 1.0;
    for (std::size_t begin = 0, end = 0; begin < rows_.size(); begin = end) {
        Work work;
        for (; end < rows_.size() && rows_[end].pair == rows_[begin].pair; ++end) {
            const Row &with = rows_[end], &without = stopped.rows_[end];
            const double impulse = with.impulse - without.impulse, speed = with.speed - without.speed;
            work.a += without.impulse * without.speed;
            work.b += without.impulse * speed + impulse * without.speed;
            work.c += impulse * speed;
        }
        share = work.last_zero(share);
    }
    return share;
}

void take_out_rebounds(const Island& island, SystemEquation& system) {
    const Eigen::Index last = system.column_count() - 1;
    for (const RowRun& run : island.runs) {
        for (int j = run.begin; j < run.end; ++j) {
            const ConstraintRow& row = system.rows[static_cast<std::size_t>(j)];
            if (!(row.rebound > 0.0)) continue;
            const double flies = row.since_impact / system.dt + 0.5;  // share of the step after the impact
            const double first = row.push.correcting + row.push.lasting;
            const double stopped = std::max(first - flies * row.rebound, -std::max(0.0, row.label.gap) / system.dt);
            const double free = unconstrained(system, static_cast<std::size_t>(j));
            system.b(j, 0) = stopped / system.dt - free;
            if (last > 0) system.b(j, last) = std::max(0.0, row.push.lasting - row.rebound) / system.dt - free;
        }
    }
}

}  // namespace pushfactor::engine
