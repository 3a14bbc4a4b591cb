#include "engine/constraints/held_pairs.h"

#include "engine/base/constants.h"
#include "engine/constraints/point_jacobian.h"

#include <cmath>
#include <utility>

namespace pushfactor::engine {

namespace {

// m/s, up to which a push is not worth a second column.
double unseen_speed(const HeldRows& held) {
    using constants::collision::meeting_gap, constants::held::share_of_forces;
    const auto acceleration = [](const Body& body) { return body.inverse_mass * body.force.norm(); };
    return share_of_forces * held.dt *
               std::max(acceleration(held.bodies.body_a), acceleration(held.bodies.body_b)) +
           meeting_gap * held.size / held.dt;
}

}  // namespace

bool push_whole(const HeldRows& held, const Correction& correction) {
    double squared = 0.0;
    for (ConstraintRow& row : held.rows) {
        row.correction = &correction;
        row.push = correct(correction, -row.error, held.dt);
        if (correction.kind == PushKind::curve) std::swap(row.push.correcting, row.push.lasting);
        squared += row.push.lasting * row.push.lasting;
    }
    return correction.kind == PushKind::curve && std::sqrt(squared) > unseen_speed(held);
}

void keep_in_common(const HeldRows& held, const HeldRates& rates) {
    const bool is_moved = held.bodies.body_a.is_moved() || held.bodies.body_b.is_moved();
    std::array<double, 3> reversed{};
    double squared = 0.0, with_curve = 0.0, with_push = 0.0;
    for (std::size_t k = 0; k < held.rows.size(); ++k) {
        const double by_curve = -0.5 * held.dt * rates[k].second;
        reversed[k] = is_moved ? by_curve : -rates[k].first;
        squared += reversed[k] * reversed[k];
        with_curve += reversed[k] * by_curve;
        with_push += reversed[k] * held.rows[k].push.lasting;
    }
    const double share = squared > 0.0 ? std::clamp(std::min(with_curve, with_push) / squared, 0.0, 1.0) : 0.0;
    double left = 0.0;
    for (std::size_t k = 0; k < held.rows.size(); ++k) {
        const double own = held.rows[k].push.lasting - share * reversed[k];
        left += own * own;
    }
    if (std::sqrt(left) <= share * std::sqrt(squared) + unseen_speed(held)) return;
    for (std::size_t k = 0; k < held.rows.size(); ++k) {
        PushFactor& push = held.rows[k].push;
        push = {.correcting = push.lasting - share * reversed[k], .lasting = share * reversed[k]};
    }
}

void append_point_rows(const BodyPair& bodies, const Vector3& on_a, const Vector3& on_b,
                       const Correction& correction, double dt, RowList& rows) {
    const Vector3 p_ab = on_b - on_a;
    const PairPoint points(bodies, on_a, on_b);
    const bool a_moves = !bodies.body_a.is_static(), b_moves = !bodies.body_b.is_static();
    Matrix3 share_of_a = 0.5 * Matrix3::Identity();
    if (a_moves && b_moves) {
        const Matrix3 inertia = world_inertia(bodies.body_a);
        share_of_a = inertia * (inertia + world_inertia(bodies.body_b)).inverse();
    }
    const double size = (on_a - bodies.body_a.position).norm() + (on_b - bodies.body_b.position).norm();
    for (int axis = 0; axis < 3; ++axis) {
        ConstraintRow& row = rows.emplace_back();
        points.place(row, Vector3::Unit(axis));
        const Vector3 couple = p_ab.cross(Vector3::Unit(axis)), of_a = share_of_a * couple;
        if (a_moves) row.jacobian.a.tail<3>() -= of_a;
        if (b_moves) row.jacobian.b.tail<3>() -= couple - of_a;
        row.error = p_ab[axis];
    }
    push_held({rows.last(3), bodies, size, dt}, correction, [&] {
        const Parting parting(bodies, on_a, on_b);
        HeldRates rates;
        for (int axis = 0; axis < 3; ++axis) rates[at(axis)] = {parting.velocity[axis], parting.acceleration[axis]};
        return rates;
    });
}

}  // namespace pushfactor::engine
