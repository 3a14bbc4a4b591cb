#pragma once

#include "renderer/meshes/instanced_mesh.h"
#include "renderer/picture/picture.h"

#include <vector>

namespace pushfactor::renderer {

// The bodies of one frame by kind, each front to back, because near ones hide others.
struct Bodies {
    std::vector<Instance> boxes;
    std::vector<Instance> spheres;
    std::vector<Instance> polyhedra;
    std::vector<Instance> bars;

    std::vector<Polyhedron> shapes;  // of all polyhedra, by Instance::number

    // All that cast a shadow.
    std::vector<Instance> all() const;

    // All that are thick enough to darken the ground on contact.
    std::vector<Instance> thick() const;
};

// Bodies within `reach` m of the eye.
Bodies visible_bodies(const Picture& picture, float reach);

}  // namespace pushfactor::renderer
