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

// m; 0 for the world.
double radius_of(const BuiltScene& scene, int body) {
    const auto index = static_cast<std::size_t>(body);
    return index < scene.bodies.size() ? bounding_radius(scene.bodies[index]) : 0.0;
}

double scale_of(const Distance& distance, const BuiltScene& scene) {
    if (std::isfinite(distance.max_force)) return 0.0;
    if (distance.length > 0.0) return distance.length;
    return std::max(radius_of(scene, distance.body_a), radius_of(scene, distance.body_b));
}

}  // namespace

Stretch::Stretch(const BuiltScene& scene) {
    if (!scene.distances) return;
    for (const Distance& distance : scene.distances->distances()) scale_.push_back(scale_of(distance, scene));
}

double Stretch::worst(const BuiltScene& scene) const {
    double worst = 0.0;
    for (std::size_t i = 0; i < scale_.size(); ++i) {
        if (scale_[i] == 0.0) continue;
        worst = std::max(worst, error_of(scene.distances->distances()[i], scene.world.bodies) / scale_[i]);
    }
    return worst;
}

}  // namespace pushfactor::demos
