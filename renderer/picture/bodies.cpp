#include "renderer/picture/bodies.h"

#include "renderer/picture/instances.h"
#include "renderer/picture/views.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>

namespace pushfactor::renderer {

std::vector<Instance> Bodies::all() const {
    std::vector<Instance> bodies = thick();
    bodies.insert(bodies.end(), bars.begin(), bars.end());
    return bodies;
}

std::vector<Instance> Bodies::thick() const {
    std::vector<Instance> bodies = boxes;
    bodies.insert(bodies.end(), spheres.begin(), spheres.end());
    bodies.insert(bodies.end(), polyhedra.begin(), polyhedra.end());
    return bodies;
}

Bodies visible_bodies(const Picture& picture, float reach) {
    const glm::vec3& eye = picture.camera.eye;
    Bodies bodies;
    const std::array kinds{&bodies.boxes, &bodies.spheres, &bodies.polyhedra, &bodies.bars};  // as in Body::shape
    for (const Body& body : picture.bodies) {
        std::vector<Instance>& kind = *kinds[body.shape.index()];
        kind.push_back(instance_of(body, kind.size()));
        if (const auto* shape = std::get_if<Polyhedron>(&body.shape)) bodies.shapes.push_back(*shape);
    }
    for (const Bar& bar : picture.bars) bodies.bars.push_back(instance_of(bar, bodies.bars.size()));
    for (std::vector<Instance>* const kind : kinds) {
        // Negated, to remove bodies whose distance is not finite as well.
        std::erase_if(*kind, [&](const Instance& body) {
            return !(glm::distance(eye, body.position) - bounding_radius(body) <= reach);
        });
        std::ranges::stable_sort(*kind, {},
                                 [&](const Instance& body) { return glm::distance(eye, body.position); });
    }
    return bodies;
}

}  // namespace pushfactor::renderer
