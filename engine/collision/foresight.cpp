#include "engine/collision/foresight.h"

#include <algorithm>
#include <cmath>

namespace pushfactor::engine::collision {

double path_of(const Collider& collider, double speed, double rate, double dt) {
    return dt * (speed + rate * std::sqrt(squared_turning_radius(collider.shape)));
}

double path_of_moved(const Collider& collider, const Motion& motion, double dt) {
    const double rate = motion.angular_velocity.norm();
    if (!is_finite(collider.shape) && rate > 0.0) return infinity;
    return path_of(collider, motion.velocity.norm(), rate, dt);
}

Way::Way(const Collider& collider, const Body& body, double dt)
    : point_(body.position),
      up_(body.orientation * Vector3::UnitY()),
      centre_(body.position),
      path_(path_of_moved(collider, body.prescribed, dt)),
      is_plane_(!is_finite(collider.shape)) {
    reach_ = half_extents(collider.shape, pose_of(body).rotation) + Vector3::Constant(path_);
}

bool Way::meets(const Shape& shape, const Body& body, double margin) const {
    const Vector3 reach = half_extents(shape, pose_of(body).rotation) + Vector3::Constant(margin);
    if (is_plane_) return up_.dot(body.position - point_) - path_ < up_.cwiseAbs().dot(reach);
    return ((body.position - centre_).cwiseAbs().array() < (reach + reach_).array()).all();
}

bool may_pass_through(const Collider& moved, const Body& body, std::span<const Collider> colliders,
                      std::span<const Body> bodies, double dt) {
    if (!is_finite(moved.shape)) return false;
    const Way way(moved, body, dt);
    const double path = path_of_moved(moved, body.prescribed, dt);
    return std::any_of(colliders.begin(), colliders.end(), [&](const Collider& other) {
        const Body& met = bodies[static_cast<std::size_t>(other.body)];
        // Faster ones than `near` are swept themselves.
        const double near = dangerous * size_of(other.shape);
        return !met.is_static() && path > near && way.meets(other.shape, met, near);
    });
}

void Foresight::look_ahead(std::span<const Collider> colliders, std::span<const Body> bodies, double dt,
                           std::span<const int> which, Threads* threads) {
    constexpr std::size_t colliders_of_a_part = 500;
    colliders_ = colliders;
    bodies_ = bodies;
    dt_ = dt;
    paths_.resize(colliders.size());
    share(threads, which.size(), colliders_of_a_part, [&](std::size_t begin, std::size_t end) {
        for (const int index : which.subspan(begin, end - begin)) {
            paths_[static_cast<std::size_t>(index)] = path_of_step(colliders[static_cast<std::size_t>(index)]);
        }
    });
}

double Foresight::path_of_step(const Collider& collider) const {
    const Body& body = bodies_[static_cast<std::size_t>(collider.body)];
    if (body.is_static()) return path_of_moved(collider, body);
    const double size = size_of(collider.shape);
    // The largest inverse moment bounds the angular velocity.
    const double turning = body.inverse_inertia.maxCoeff();
    const double speed = velocity(body).norm(), rate = body.angular_momentum.norm() * turning;
    if (path_of(collider, speed, rate, dt_) > dangerous * size) return 0.0;
    const double with_force = body.inverse_mass * (body.linear_momentum + dt_ * body.force).norm();
    return std::min(path_of(collider, std::max(speed, with_force), rate + dt_ * body.torque.norm() * turning, dt_),
                    dangerous * size);
}

double Foresight::path_of_moved(const Collider& collider, const Body& body) const {
    if (body.prescribed.is_none()) return 0.0;
    if (may_pass_through(collider, body, colliders_, bodies_, dt_)) return 0.0;
    return collision::path_of_moved(collider, body.prescribed, dt_);
}

double Foresight::closing(int body_a, int body_b, const Vector3& normal, const Vector3& point) const {
    const auto speed_along = [&](int index) {
        const Body& body = bodies_[static_cast<std::size_t>(index)];
        if (body.is_static() && body.prescribed.is_none()) return 0.0;
        const Motion motion = motion_of(body, dt_);
        return normal.dot(motion.velocity + motion.angular_velocity.cross(point - body.position));
    };
    return std::max(0.0, dt_ * (speed_along(body_a) - speed_along(body_b)));
}

double Foresight::most_closing(const Collider& a, const Collider& b, const Vector3& normal) const {
    const auto reach = [&](const Collider& collider, const Vector3& direction) {
        const Body& body = bodies_[static_cast<std::size_t>(collider.body)];
        if (body.is_static() && body.prescribed.is_none()) return 0.0;
        const Motion motion = motion_of(body, dt_);
        const Motion turning{.angular_velocity = motion.angular_velocity};
        return dt_ * direction.dot(motion.velocity) + collision::path_of_moved(collider, turning, dt_);
    };
    return reach(a, normal) + reach(b, -normal);
}

}  // namespace pushfactor::engine::collision
