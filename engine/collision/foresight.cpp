#include "engine/collision/foresight.h"

#include <algorithm>
#include <cmath>

namespace pushfactor::engine::collision {

double path_of(const Collider& collider, double speed, double rate, double dt) {
    return dt * (speed + rate * std::sqrt(squared_turning_radius(collider.shape)));
}

void Foresight::look_ahead(std::span<const Collider> colliders, std::span<const Body> bodies, double dt,
                           std::span<const int> which, Threads* threads) {
    constexpr std::size_t colliders_of_a_part = 500;
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
    if (body.is_static()) return 0.0;
    const double size = size_of(collider.shape);
    // The largest inverse moment bounds the rate of turning.
    const double turning = body.inverse_inertia.maxCoeff();
    const double speed = velocity(body).norm(), rate = body.angular_momentum.norm() * turning;
    if (path_of(collider, speed, rate, dt_) > dangerous * size) return 0.0;
    const double with_force = body.inverse_mass * (body.linear_momentum + dt_ * body.force).norm();
    return std::min(path_of(collider, std::max(speed, with_force), rate + dt_ * body.torque.norm() * turning, dt_),
                    dangerous * size);
}

double Foresight::closing(int body_a, int body_b, const Vector3& normal, const Vector3& point) const {
    const auto speed_along = [&](int index) {
        const Body& body = bodies_[static_cast<std::size_t>(index)];
        if (body.is_static()) return 0.0;
        const Motion motion = motion_of(body, dt_);
        return normal.dot(motion.velocity + motion.angular_velocity.cross(point - body.position));
    };
    return std::max(0.0, dt_ * (speed_along(body_a) - speed_along(body_b)));
}

double Foresight::most_closing(const Collider& a, const Collider& b, const Vector3& normal) const {
    const auto reach = [&](const Collider& collider, const Vector3& direction) {
        const Body& body = bodies_[static_cast<std::size_t>(collider.body)];
        if (body.is_static()) return 0.0;
        const Motion motion = motion_of(body, dt_);
        return dt_ * direction.dot(motion.velocity) + path_of(collider, 0.0, motion.angular_velocity.norm(), dt_);
    };
    return reach(a, normal) + reach(b, -normal);
}

}  // namespace pushfactor::engine::collision
