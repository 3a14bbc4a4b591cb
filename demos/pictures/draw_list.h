// Converts a scene to a picture: bodies, bars, planes.
#pragma once

#include "demos/runs/scene.h"
#include "renderer/picture/picture.h"

namespace pushfactor::demos::pictures {

// The scene as it is now, seen from `view`.
renderer::Picture draw_list(const BuiltScene& scene, const View& view);

}  // namespace pushfactor::demos::pictures
