// What members of families are put together from. The ground is the plane y = 0.
#pragma once

#include "demos/scenes/families/family.h"
#include "demos/scenes/named/random.h"
#include "demos/scenes/scene_description.h"

#include <string>

namespace pushfactor::demos::families {

constexpr double gravity = 10.0;  // m/s^2

// The parameter "friction", between `low` and `high`.
FamilyParameter friction_of(double low, double high);

// An empty scene with its ground.
SceneDescription on_ground(double friction);

BodyDescription& add_box(SceneDescription& scene, const std::string& name, const engine::Vector3& size, double mass,
                         const engine::Vector3& position, double friction);
BodyDescription& add_ball(SceneDescription& scene, const std::string& name, double radius, double mass,
                          const engine::Vector3& position, double friction);

// Turned by `angle` [rad] about the vertical, and about the z axis.
engine::Quaternion turned(double angle);
engine::Quaternion inclined(double angle);

// Every orientation is as likely.
engine::Quaternion random_orientation(scenes::Random& random);

// When what falls from `height` [m] rests [s]: what a heap takes to settle, twice the time to fall, and the time
// that something slides that has got the speed of that fall and the `speed` [m/s] of what was thrown.
double rest_by(double height, double friction, double speed = 0.0);

// A camera that has all movable bodies in its picture.
void look_at_all(SceneDescription& scene);

}  // namespace pushfactor::demos::families
