#include "engine/collision/collider.h"

namespace pushfactor::engine::collision {

Pose pose_of(const Body& body) {
    return {body.position, body.orientation.toRotationMatrix()};
}

double size_of(const Shape& shape) {
    if (const auto* box = std::get_if<Box>(&shape)) return 2.0 * box->half_size.minCoeff();
    if (const auto* sphere = std::get_if<Sphere>(&shape)) return 2.0 * sphere->radius;
    return std::numeric_limits<double>::infinity();
}

}  // namespace pushfactor::engine::collision
