#pragma once

#include "renderer/meshes/instanced_mesh.h"
#include "renderer/picture/picture.h"

#include <vector>

namespace pushfactor::renderer {

// The bodies of one frame, by their kind; of each the nearest first, as they hide the others.
struct Bodies {
    std::vector<Instance> boxes;
    std::vector<Instance> spheres;
    std::vector<Instance> bars;

    // All that cast a shadow.
    std::vector<Instance> all() const;

    // All that are thick enough to darken the ground where they touch it.
    std::vector<Instance> thick() const;
};

// The bodies that reach into `reach` m around the eye.
Bodies visible_bodies(const Picture& picture, float reach);

}  // namespace pushfactor::renderer
