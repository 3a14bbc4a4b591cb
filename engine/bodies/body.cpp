#include "engine/bodies/body.h"

#include "engine/base/invalid_input.h"

#include <array>
#include <charconv>
#include <string>

namespace pushfactor::engine {

namespace {

std::string to_text(double value) {
    std::array<char, 32> digits;
    const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), value);
    return {digits.data(), end};
}

void require_within(const char* field, double value, double low, double high) {
    if (value >= low && value <= high) return;
    throw InvalidInput(field, to_text(value), "from " + to_text(low) + " to " + to_text(high));
}

void require_mass(double mass) {
    require_within("mass_kg", mass, least_mass, greatest_mass);
}

Body movable_body(double mass, const Vector3& inertia, const Vector3& position, const Quaternion& orientation) {
    Body body = static_body(position, orientation);
    body.inverse_mass = 1.0 / mass;
    body.inverse_inertia = inertia.cwiseInverse();
    return body;
}

}  // namespace

Body static_body(const Vector3& position, const Quaternion& orientation) {
    Body body;
    body.position = position;
    body.orientation = orientation;
    return body;
}

Body box_body(double mass, const Vector3& size, const Vector3& position, const Quaternion& orientation) {
    require_mass(mass);
    for (int axis = 0; axis < 3; ++axis) require_within("size_m", size[axis], least_length, greatest_length);

    const Vector3 squared = size.cwiseProduct(size);
    const Vector3 inertia = (mass / 12.0) * (Vector3::Constant(squared.sum()) - squared);
    return movable_body(mass, inertia, position, orientation);
}

Body ball_body(double mass, double radius, const Vector3& position, const Quaternion& orientation) {
    require_mass(mass);
    require_within("radius_m", radius, least_length, greatest_length);
    return movable_body(mass, Vector3::Constant(0.4 * mass * radius * radius), position, orientation);
}

Body solid_body(double mass, const Vector3& moments, const Vector3& position, const Quaternion& orientation) {
    require_mass(mass);
    const double least = least_length * least_length, greatest = greatest_length * greatest_length;
    for (int axis = 0; axis < 3; ++axis) require_within("moment of inertia / mass", moments[axis], least, greatest);
    return movable_body(mass, mass * moments, position, orientation);
}

Vector3 velocity(const Body& body) {
    if (body.is_static()) return body.prescribed.velocity;
    return body.inverse_mass * body.linear_momentum;
}

Vector3 angular_velocity(const Body& body) {
    if (body.is_static()) return body.prescribed.angular_velocity;
    const Vector3 in_body = body.orientation.conjugate() * body.angular_momentum;
    return body.orientation * body.inverse_inertia.cwiseProduct(in_body).eval();
}

Vector3 angular_momentum_of(const Body& body, const Vector3& angular_velocity) {
    const Vector3 own = body.orientation.conjugate() * angular_velocity;
    return body.orientation * own.cwiseQuotient(body.inverse_inertia);
}

Matrix3 world_inverse_inertia(const Body& body) {
    const Matrix3 rotation = body.orientation.toRotationMatrix();
    return rotation * body.inverse_inertia.asDiagonal() * rotation.transpose();
}

Matrix3 world_inertia(const Body& body) {
    const Matrix3 axes = body.orientation.toRotationMatrix();
    return axes * body.inverse_inertia.cwiseInverse().asDiagonal() * axes.transpose();
}

Vector3 velocity_at(const Body& body, const Vector3& point) {
    return velocity(body) + angular_velocity(body).cross(point - body.position);
}

}  // namespace pushfactor::engine
