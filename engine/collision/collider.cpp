#include "engine/collision/collider.h"

namespace pushfactor::engine::collision {

Pose pose_of(const Body& body) {
    return {body.position, body.orientation.toRotationMatrix()};
}

bool runs_at(const Collider& collider, double time) {
    const double rounding = 1e-9 * time;  // the world's time is a sum of steps
    return !collider.surface_velocity.isZero(0.0) && time >= collider.surface_from - rounding;
}

double size_of(const Shape& shape) {
    if (const auto* box = std::get_if<Box>(&shape)) return 2.0 * box->half_size.minCoeff();
    if (const auto* sphere = std::get_if<Sphere>(&shape)) return 2.0 * sphere->radius;
    return std::numeric_limits<double>::infinity();
}

}  // namespace pushfactor::engine::collision
