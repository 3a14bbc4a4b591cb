#include "demos/runs/measured_errors.h"

#include "engine/base/elementary.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace pushfactor::demos {

namespace {

double end_of(const MotionDescription& motion) {
    const auto* const poses = std::get_if<std::vector<TimedPose>>(&motion.kind);
    return poses ? poses->back().time : std::numeric_limits<double>::infinity();
}

// In degrees.
double angle_between(const engine::Quaternion& a, const engine::Quaternion& b) {
    const engine::Quaternion turn = a * b.conjugate();
    return 2.0 * engine::elementary::atan2(turn.vec().norm(), std::abs(turn.w())) * 180.0 / std::numbers::pi;
}

}  // namespace

MeasuredErrors::MeasuredErrors(const BuiltScene& scene) {
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        const BodyDescription& measured = scene.bodies[i];
        if (measured.measured_of.empty()) continue;
        const auto body = std::ranges::find(scene.bodies, measured.measured_of, &BodyDescription::name);
        pairs_.push_back(
            {static_cast<std::size_t>(body - scene.bodies.begin()), i, end_of(measured.motion.value())});
    }
}

std::vector<MeasuredError> MeasuredErrors::at(const Simulation& simulation) const {
    const auto& bodies = simulation.scene().world.bodies;
    std::vector<MeasuredError> errors;
    for (const Pair& pair : pairs_) {
        // That of the scene, also in a resumed run; exact to rounding.
        if (simulation.scene().world.time() > pair.until * (1.0 + 1e-9)) continue;
        const engine::Body &body = bodies[pair.body], &measured = bodies[pair.measured];
        errors.push_back({pair.body, (body.position - measured.position).norm(),
                          angle_between(body.orientation, measured.orientation)});
    }
    return errors;
}

void MeasuredSum::add(const std::vector<MeasuredError>& errors) {
    for (const MeasuredError& error : errors) {
        ++count;
        distance += error.distance;
        angle += error.angle;
        largest_distance = std::max(largest_distance, error.distance);
        largest_angle = std::max(largest_angle, error.angle);
    }
}

}  // namespace pushfactor::demos
