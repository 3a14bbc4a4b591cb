#include "renderer/picture/bodies.h"

#include "renderer/picture/instances.h"
#include "renderer/picture/views.h"

#include <glm/geometric.hpp>

#include <algorithm>

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
    Bodies bodies{.boxes = box_instances(picture.boxes),
                  .spheres = sphere_instances(picture.spheres),
                  .polyhedra = polyhedron_instances(picture.polyhedra),
                  .bars = bar_instances(picture.bars),
                  .shapes = {}};
    for (const Polyhedron& polyhedron : picture.polyhedra) bodies.shapes.push_back(polyhedron.shape);
    for (std::vector<Instance>* kind : {&bodies.boxes, &bodies.spheres, &bodies.polyhedra, &bodies.bars}) {
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
