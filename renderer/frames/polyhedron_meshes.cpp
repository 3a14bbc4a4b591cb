#include "renderer/frames/polyhedron_meshes.h"

#include <cstddef>

namespace pushfactor::renderer {

void PolyhedronMeshes::set_instances(std::span<const Instance> polyhedra,
                                     std::span<const std::shared_ptr<const ConvexShape>> shapes) {
    for (Drawn* const drawn : drawn_) drawn->instances.clear();
    drawn_.clear();
    std::map<const ConvexShape*, Drawn*> known;  // by pointer, because equal shapes are mostly one
    for (const Instance& instance : polyhedra) {
        const ConvexShape& shape = *shapes[static_cast<std::size_t>(instance.number)];
        Drawn*& drawn = known[&shape];
        if (!drawn) {
            auto found = meshes_.find(shape);
            if (found == meshes_.end()) {
                found = meshes_.try_emplace(shape, gl_, convex_mesh(shape)).first;
            }
            drawn = &found->second;
        }
        if (drawn->instances.empty()) drawn_.push_back(drawn);
        drawn->instances.push_back(instance);
    }
    for (Drawn* const drawn : drawn_) drawn->mesh.set_instances(drawn->instances);
}

void PolyhedronMeshes::draw() const {
    for (const Drawn* const drawn : drawn_) drawn->mesh.draw();
}

}  // namespace pushfactor::renderer
