// What a camera has to show of a scene in its current state, as balls.
#pragma once

#include "demos/pictures/camera/framing.h"
#include "demos/runs/scene.h"

#include <span>
#include <vector>

namespace pushfactor::demos::pictures {

// Balls whose hull is the body in this pose: corners without a radius, or a sphere; none for a plane.
std::vector<Ball> hull_of(const BodyDescription& body, const engine::Vector3& position,
                          const engine::Quaternion& orientation);

// The points that bars and joints hold.
std::vector<Ball> held_points(const BuiltScene& scene);

// Balls around the movable bodies of a scene, and the points that they hang on.
std::vector<Ball> movable_balls(const BuiltScene& scene);

// The region around a scene's movable_balls() at its start in which a body is worth being in the picture: from
// farther away than 300 radii or ten times the scene's size it is a dot, or all else is.
Eigen::AlignedBox3d surroundings(std::span<const Ball> start);

}  // namespace pushfactor::demos::pictures
