#include "engine/constraints/distance_constraints.h"

#include "engine/constraints/carried.h"
#include "engine/constraints/point_jacobian.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

namespace pushfactor::engine {

namespace {

// `error` = |p_ab| - l.
bool is_loose(const Distance& distance, double error) {
    return (distance.acts == Distance::Acts::pulls && error < 0.0) ||
           (distance.acts == Distance::Acts::pushes && error > 0.0);
}

// A loose rope may tighten within the step, in both columns, like a contact point that closes its gap; a strut
// likewise.
PushFactor distance_push(const Distance& distance, double error, const Correction& correction, double dt) {
    if (is_loose(distance, error)) return {.correcting = 0.0, .lasting = -error / dt};
    return correct(correction, -error, dt);
}

Bounds distance_bounds(const Distance& distance) {
    const bool pushes = distance.acts != Distance::Acts::pulls;
    const bool pulls = distance.acts != Distance::Acts::pushes;
    return {.c_min = pulls ? -distance.max_force : 0.0, .c_max = pushes ? distance.max_force : 0.0};
}

BodyPair pair_of(const Distance& distance, std::span<const Body> bodies) {
    return {distance.body_a, distance.body_b, bodies[static_cast<std::size_t>(distance.body_a)],
            bodies[static_cast<std::size_t>(distance.body_b)]};
}

Span span_of(const Distance& distance, const Body& a, const Body& b) {
    return {a.position + a.orientation * distance.point_a, b.position + b.orientation * distance.point_b};
}

}  // namespace

Span span_of(const Distance& distance, std::span<const Body> bodies) {
    return span_of(distance, bodies[static_cast<std::size_t>(distance.body_a)],
                   bodies[static_cast<std::size_t>(distance.body_b)]);
}

DistanceConstraints::DistanceConstraints(std::vector<Distance> distances, const Correction& correction, bool cached)
    : distances_(std::move(distances)),
      correction_(correction),
      cached_(cached),
      forces_(distances_.size()),
      acting_(distances_.size()) {
    std::iota(acting_.begin(), acting_.end(), 0);
    for ([[maybe_unused]] const Distance& distance : distances_) {
        assert(!is_ball_joint(distance) ||
               (distance.acts == Distance::Acts::both && std::isinf(distance.max_force) && !distance.spring));
    }
}

void DistanceConstraints::append_rows(const StepStart& step, RowList& rows) {
    for (const std::size_t i : acting_) append_rows_of(i, pair_of(distances_[i], step.bodies), step.dt, rows);
}

void DistanceConstraints::append_rows_of(std::size_t index, const BodyPair& bodies, double dt,
                                         RowList& rows) const {
    if (is_ball_joint(distances_[index])) {
        append_joint(index, bodies, dt, rows);
    } else {
        append_bar(index, bodies, dt, rows);
    }
}

void DistanceConstraints::append_bar(std::size_t index, const BodyPair& bodies, double dt, RowList& rows) const {
    const Distance& distance = distances_[index];
    const auto [p_a, p_b] = span_of(distance, bodies.body_a, bodies.body_b);
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
    row.push = distance_push(distance, error, correction_, dt);
    row.bounds = distance_bounds(distance);
    row.error = error;
    row.correction = &correction_;
    row.label = {.kind = RowKind::distance,
                 .point = static_cast<int>(index),
                 .gap = is_loose(distance, error) ? 0.0 : error};
}

void DistanceConstraints::append_joint(std::size_t index, const BodyPair& bodies, double dt, RowList& rows) const {
    const auto [p_a, p_b] = span_of(distances_[index], bodies.body_a, bodies.body_b);
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
    for (const Distance& distance : distances_) {
        if (!distance.spring) continue;
        const auto [from, to] = span_of(distance, bodies);
        const double error = (to - from).norm() - distance.length;
        sum += 0.5 * distance.spring->stiffness * error * error;
    }
    return sum;
}

bool DistanceConstraints::turns_unseen(int body) const {
    return std::none_of(distances_.begin(), distances_.end(), [body](const Distance& distance) {
        return (distance.body_a == body && !distance.point_a.isZero(0.0)) ||
               (distance.body_b == body && !distance.point_b.isZero(0.0));
    });
}

void DistanceConstraints::leave_out_others(std::span<const Body> bodies, const Awake& awake,
                                           std::span<const int> /*changed*/) {
    acting_.clear();
    for (std::size_t i = 0; i < distances_.size(); ++i) {
        if (is_any_moving(bodies, awake, distances_[i].body_a, distances_[i].body_b)) acting_.push_back(i);
    }
}

SomeBodies DistanceConstraints::met_by_moved(const StepStart& step) const {
    return held_by_moved(distances_, step.bodies);
}

void DistanceConstraints::set_forces(std::vector<DistanceForce> forces) {
    assert(forces.size() == distances_.size());
    forces_ = std::move(forces);
}

void DistanceConstraints::remember(std::span<const Lambda> answers) {
    for (const std::size_t i : acting_) {
        const std::size_t rows = is_ball_joint(distances_[i]) ? 3 : 1;
        std::copy_n(answers.begin(), rows, forces_[i].begin());
        answers = answers.subspan(rows);
    }
}

}  // namespace pushfactor::engine
