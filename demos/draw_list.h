// From a scene to a picture: the only place where the engine's types become the renderer's.
#pragma once

#include "demos/scene.h"
#include "renderer/picture.h"

namespace pushfactor::demos {

renderer::Picture draw_list(const Scene& scene);

}  // namespace pushfactor::demos
