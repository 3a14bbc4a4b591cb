#include "engine/bodies/integrator.h"

#include "engine/base/constants.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pushfactor::engine {

namespace {

constexpr double most_turns = 1000.0;

Vector3 to_body_frame(const Quaternion& orientation, const Vector3& vector) {
    return orientation.conjugate() * vector;
}

// Rotates by the component of the angular momentum along one body axis, as if the other two were zero.
void rotate_about_axis(Quaternion& orientation, const Body& body, const Vector3& angular_momentum, int axis,
                       double dt) {
    const double along = to_body_frame(orientation, angular_momentum)[axis];
    const double half_angle = 0.5 * along * body.inverse_inertia[axis] * dt;
    const auto [sine, cosine] = elementary::sine_cosine(half_angle);
    Quaternion turn(cosine, 0.0, 0.0, 0.0);
    turn.vec()[axis] = sine;
    orientation = orientation * turn;
}

bool nearly_equal(double a, double b) {
    return std::abs(a - b) <= 1e-12 * std::max(std::abs(a), std::abs(b));
}

// The axis about which the body is symmetric (the other two moments are equal), or -1.
int symmetry_axis(const Vector3& inverse_inertia) {
    for (int axis = 0; axis < 3; ++axis) {
        if (nearly_equal(inverse_inertia[(axis + 1) % 3], inverse_inertia[(axis + 2) % 3])) return axis;
    }
    return -1;
}

// Closed form for a symmetric body: it precesses about l at l / I_perp and spins about its own axis at the
// remaining rate of l_axis.
Quaternion rotate_symmetric(const Body& body, const Vector3& angular_momentum, int axis, double dt) {
    const double across = body.inverse_inertia[(axis + 1) % 3];
    const double along = body.inverse_inertia[axis];
    const Quaternion precession = exponential(across * angular_momentum * dt);
    if (along == across) return precession * body.orientation;
    Vector3 spin = Vector3::Zero();
    spin[axis] = (along - across) * to_body_frame(body.orientation, angular_momentum)[axis] * dt;
    return precession * body.orientation * exponential(spin);
}

}  // namespace

// a b = `rotation_vector`; a series near zero avoids the division by a.
Quaternion exponential(const Vector3& rotation_vector) {
    const double angle = rotation_vector.norm();
    const auto [sine, cosine] = elementary::sine_cosine(0.5 * angle);
    const double scale = angle < 1e-6 ? 0.5 - angle * angle / 48.0 : sine / angle;
    Quaternion q;
    q.w() = cosine;
    q.vec() = scale * rotation_vector;
    return q;
}

Quaternion rotate_euler(const Body& body, const Vector3& angular_momentum, double dt) {
    const Vector3 omega = world_inverse_inertia(body) * angular_momentum;
    Quaternion rate(0.0, 0.5 * omega.x(), 0.5 * omega.y(), 0.5 * omega.z());
    const Quaternion change = rate * body.orientation;
    Quaternion next;
    next.coeffs() = body.orientation.coeffs() + change.coeffs() * dt;
    return next.normalized();
}

Quaternion rotate_exponential(const Body& body, const Vector3& angular_momentum, double dt) {
    const Vector3 omega = world_inverse_inertia(body) * angular_momentum;
    return (exponential(omega * dt) * body.orientation).normalized();
}

Quaternion rotate_splitting(const Body& body, const Vector3& angular_momentum, double dt) {
    if (const int axis = symmetry_axis(body.inverse_inertia); axis >= 0) {
        return rotate_symmetric(body, angular_momentum, axis, dt).normalized();
    }
    int smallest = 0;  // smallest inertia, i.e. largest inverse
    body.inverse_inertia.maxCoeff(&smallest);
    const int first = (smallest + 1) % 3;
    const int second = (smallest + 2) % 3;

    Quaternion orientation = body.orientation;
    rotate_about_axis(orientation, body, angular_momentum, first, 0.5 * dt);
    rotate_about_axis(orientation, body, angular_momentum, second, 0.5 * dt);
    rotate_about_axis(orientation, body, angular_momentum, smallest, dt);
    rotate_about_axis(orientation, body, angular_momentum, second, 0.5 * dt);
    rotate_about_axis(orientation, body, angular_momentum, first, 0.5 * dt);
    return orientation.normalized();
}

Quaternion rotate_by_small_turns(const Body& body, const Vector3& angular_momentum, double dt) {
    if (symmetry_axis(body.inverse_inertia) >= 0) return rotate_splitting(body, angular_momentum, dt);
    const double angle = angular_momentum.norm() * body.inverse_inertia.maxCoeff() * std::abs(dt);
    const double turns = std::clamp(std::ceil(angle / constants::integration::largest_turn), 1.0, most_turns);
    Body turned = body;
    for (double turn = 0.0; turn < turns; ++turn) {
        turned.orientation = rotate_splitting(turned, angular_momentum, dt / turns);
    }
    return turned.orientation;
}

}  // namespace pushfactor::engine
