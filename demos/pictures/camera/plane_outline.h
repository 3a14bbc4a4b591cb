// Infinite planes: the level one is the ground, and of others the visible part is drawn.
#pragma once

#include "demos/runs/scene.h"

#include <optional>
#include <vector>

namespace pushfactor::demos::pictures {

bool is_level(const engine::Body& plane);

// Of the plane or of the floor that is drawn [m].
std::optional<double> ground_height(const BuiltScene& scene);

// Corners of the convex polygon of `plane` [m] that is above all other planes of the scene and within view,
// counter-clockwise as seen from above the plane. None if the area is negligible.
std::vector<engine::Vector3> plane_outline(const BuiltScene& scene, const engine::Body& plane);

}  // namespace pushfactor::demos::pictures
