// The visible part of an infinite plane.
#pragma once

#include "demos/runs/scene.h"

#include <vector>

namespace pushfactor::demos::pictures {

// Corners of the convex polygon of `plane` [m] that is above all other planes of the scene and within view,
// counter-clockwise as seen from above the plane. None if the area is negligible.
std::vector<engine::Vector3> plane_outline(const BuiltScene& scene, const engine::Body& plane);

}  // namespace pushfactor::demos::pictures
