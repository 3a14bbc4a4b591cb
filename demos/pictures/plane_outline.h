// The part of an infinite plane that is worth drawing.
#pragma once

#include "demos/runs/scene.h"

#include <vector>

namespace pushfactor::demos::pictures {

// Corners of the convex polygon of `plane` [m] that is above all other planes of the scene and within view,
// counter-clockwise as seen from above the plane. None when it is next to nothing.
std::vector<engine::Vector3> plane_outline(const BuiltScene& scene, const engine::Body& plane);

}  // namespace pushfactor::demos::pictures
