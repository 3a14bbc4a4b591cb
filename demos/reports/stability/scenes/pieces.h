// Building blocks of scenes of the stress list.
#pragma once

#include "demos/reports/stability/scenes/scenes.h"

#include <string>
#include <utility>
#include <vector>

namespace pushfactor::demos::reports::stability {

inline BodyDescription ground() {
    return {.name = "ground", .shape = PlaneShape{}};
}

inline BodyDescription ball(double radius, const engine::Vector3& position,
                            const engine::Vector3& velocity = engine::Vector3::Zero()) {
    return {.name = "ball", .shape = SphereShape{radius}, .mass = 1.0, .position = position, .velocity = velocity};
}

inline BodyDescription box(const std::string& name, const engine::Vector3& size, const engine::Vector3& position) {
    return {.name = name, .shape = BoxShape{size}, .mass = 1.0, .position = position};
}

inline BodyDescription wall(const std::string& name, const engine::Vector3& size, const engine::Vector3& position) {
    return {.name = name, .shape = BoxShape{size}, .position = position};
}

// Turned by `angle` [rad] about the vertical.
inline engine::Quaternion turned(double angle) {
    return engine::exponential(angle * engine::Vector3::UnitY());
}

// A horizontal vector of this length, turned by `angle` [rad] about the vertical from the x axis.
inline engine::Vector3 along(double angle, double length) {
    return turned(angle) * engine::Vector3(length, 0, 0);
}

// Angular velocity [rad/s] with which a ball rolls on level ground at `velocity` [m/s].
inline engine::Vector3 rolling(const engine::Vector3& velocity, double radius) {
    return engine::Vector3::UnitY().cross(velocity) / radius;
}

// A view of the origin from the right; `height` is the upward component of the direction. Pictures find their own
// distance.
inline View seen_from(double height) {
    return {.eye = 20.0 * engine::Vector3(0.45, height, 1.0).normalized(), .target = engine::Vector3::Zero()};
}

// Bodies that may touch; `height` as in seen_from(), 0 for the usual view.
inline SceneDescription touching(const std::string& name, std::vector<BodyDescription> bodies,
                                 double height = 0.0) {
    SceneDescription scene;
    scene.name = name;
    scene.bodies = std::move(bodies);
    scene.contacts = true;
    if (height > 0.0) scene.view = seen_from(height);
    return scene;
}

}  // namespace pushfactor::demos::reports::stability
