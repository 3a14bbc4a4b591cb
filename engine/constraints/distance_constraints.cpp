#include "engine/constraints/distance_constraints.h"

#include "engine/constraints/point_jacobian.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace pushfactor::engine {

namespace {

// `error` = |p_ab| - l.
bool is_loose(const Distance& distance, double error) {
    return (distance.acts == Distance::Acts::pulls && error < 0.0) ||
           (distance.acts == Distance::Acts::pushes && error > 0.0);
}

// Of the length of a bar along `n`.
HeldRates rates_of(const Parting& parting, const Vector3& n, double length) {
    const double across = parting.velocity.cross(n).squaredNorm();
    const double turning = across > 0.0 ? across / length : 0.0;
    return {Rates{n.dot(parting.velocity), n.dot(parting.acceleration) + turning}};
}

Bounds distance_bounds(const Distance& distance) {
    const bool pushes = distance.acts != Distance::Acts::pulls;
    const bool pulls = distance.acts != Distance::Acts::pushes;
    return {.c_min = pulls ? -distance.max_force : 0.0, .c_max = pushes ? distance.max_force : 0.0};
}

}  // namespace

DistanceConstraints::DistanceConstraints(std::vector<Distance> distances, const Correction& correction, bool cached)
    : HeldPairs(std::move(distances), correction, cached) {
    for ([[maybe_unused]] const Distance& distance : items_) {
        assert(!is_ball_joint(distance) ||
               (distance.acts == Distance::Acts::both && std::isinf(distance.max_force) && !distance.spring));
    }
}

void DistanceConstraints::append_rows_of(std::size_t index, const BodyPair& bodies, double dt,
                                         RowList& rows) const {
    if (is_ball_joint(items_[index])) {
        append_joint(index, bodies, dt, rows);
    } else {
        append_bar(index, bodies, dt, rows);
    }
}

void DistanceConstraints::append_bar(std::size_t index, const BodyPair& bodies, double dt, RowList& rows) const {
    const Distance& distance = items_[index];
    const Span ends = span_of(distance, bodies);
    const Vector3 &p_a = ends.from, &p_b = ends.to;
    const Vector3 p_ab = p_b - p_a;
    const double length = p_ab.norm();
    // Points at one place may part in any direction: one that turns with the scene.
    const Vector3 n = length > 0.0 ? Vector3(p_ab / length) : Vector3(bodies.body_a.orientation * Vector3::UnitY());
    const double error = length - distance.length;

    ConstraintRow& row = rows.emplace_back();
    PairPoint(bodies, p_a, p_b).place(row, n);
    if (cached_) row.guess = forces_[index][0];
    if (distance.spring) {
        const double mobility = 1.0 / (distance.spring->stiffness * dt + distance.spring->damping);  // m/(N s)
        row.push.lasting = -distance.spring->stiffness * error * mobility;
        row.softness = mobility / dt;
        row.label = {.kind = RowKind::spring, .point = static_cast<int>(index), .gap = error};
        return;
    }
    // A loose rope may tighten within the step, in both columns, like a contact point that closes its gap; a strut
    // likewise.
    row.bounds = distance_bounds(distance);
    row.error = error;
    if (is_loose(distance, error)) {
        row.push.lasting = -error / dt;
        row.correction = &correction_;
    } else {
        push_held({rows.last(1), bodies, distance.length, dt}, correction_,
                  [&] { return rates_of(Parting(bodies, p_a, p_b), n, length); });
    }
    row.label = {.kind = RowKind::distance,
                 .point = static_cast<int>(index),
                 .gap = is_loose(distance, error) ? 0.0 : error};
}

void DistanceConstraints::append_joint(std::size_t index, const BodyPair& bodies, double dt, RowList& rows) const {
    const auto [p_a, p_b] = span_of(items_[index], bodies);
    const std::size_t first = rows.size();
    append_point_rows(bodies, p_a, p_b, correction_, dt, rows);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        ConstraintRow& row = rows[first + axis];
        row.label = {.kind = RowKind::distance, .point = static_cast<int>(index), .gap = (p_b - p_a).norm()};
        if (cached_) row.guess = forces_[index][axis];
    }
}

double DistanceConstraints::stored_energy(std::span<const Body> bodies) const {
    double sum = 0.0;
    for (const Distance& distance : items_) {
        if (!distance.spring) continue;
        const auto [from, to] = span_of(distance, bodies);
        const double error = (to - from).norm() - distance.length;
        sum += 0.5 * distance.spring->stiffness * error * error;
    }
    return sum;
}

bool DistanceConstraints::turns_unseen(int body) const {
    return std::none_of(items_.begin(), items_.end(), [body](const Distance& distance) {
        return (distance.body_a == body && !distance.point_a.isZero(0.0)) ||
               (distance.body_b == body && !distance.point_b.isZero(0.0));
    });
}

}  // namespace pushfactor::engine
