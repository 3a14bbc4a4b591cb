#include "demos/runs/stretch.h"

#include <algorithm>
#include <cmath>

namespace pushfactor::demos {

namespace {

using engine::Distance;

double error_of(const Distance& distance, std::span<const engine::Body> bodies) {
    const engine::Span span = span_of(distance, bodies);
    const double error = (span.to - span.from).norm() - distance.length;
    if (distance.acts == Distance::Acts::pulls) return std::max(error, 0.0);
    if (distance.acts == Distance::Acts::pushes) return std::max(-error, 0.0);
    return std::abs(error);
}

double error_of(const engine::Joint& joint, std::span<const engine::Body> bodies) {
    const engine::Span span = span_of(joint, bodies);
    return (span.to - span.from).norm();
}

// m; 0 for the world.
double radius_of(const BuiltScene& scene, int body) {
    const auto index = static_cast<std::size_t>(body);
    return index < scene.bodies.size() ? bounding_radius(scene.bodies[index]) : 0.0;
}

// m; 0 leaves it out.
double scale_of(const Distance& distance, const BuiltScene& scene) {
    if (std::isfinite(distance.max_force) || distance.spring) return 0.0;
    if (distance.length > 0.0) return distance.length;
    return std::max(radius_of(scene, distance.body_a), radius_of(scene, distance.body_b));
}

double scale_of(const engine::Joint& joint, const BuiltScene& scene) {
    return std::max(radius_of(scene, joint.body_a), radius_of(scene, joint.body_b));
}

}  // namespace

double worst_stretch(const BuiltScene& scene) {
    double worst = 0.0;
    each_held(scene, [&](const auto& held) {
        const double scale = scale_of(held, scene);
        if (scale > 0.0) worst = std::max(worst, error_of(held, scene.world.bodies) / scale);
    });
    return worst;
}

}  // namespace pushfactor::demos
