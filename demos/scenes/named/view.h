// Cameras that frame a scene.
#pragma once

#include "demos/scenes/scene_description.h"

namespace pushfactor::demos::scenes {

// A view of `target` [m] from the front right and somewhat above; `height` [m] fills most of the picture.
inline View view_of(const engine::Vector3& target, double height) {
    // 38 degrees of view show 0.69 m of height per metre of distance; about a tenth more on each side is left free.
    const double distance = 1.9 * (height + 0.7);
    return {.eye = target + distance * engine::Vector3(0.45, 0.28, 1.0).normalized(), .target = target};
}

}  // namespace pushfactor::demos::scenes
