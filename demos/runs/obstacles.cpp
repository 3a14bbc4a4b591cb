#include "demos/runs/obstacles.h"

#include "engine/base/overloaded.h"

#include <algorithm>

namespace pushfactor::demos {

namespace {

using engine::Vector3;

// Whether the segment between two places in the frame of a box crosses one of its middle planes inside it.
bool crosses_middle(const Vector3& from, const Vector3& to, const Vector3& half_size) {
    for (int axis = 0; axis < 3; ++axis) {
        if ((from[axis] < 0.0) == (to[axis] < 0.0)) continue;
        const Vector3 at = from + from[axis] / (from[axis] - to[axis]) * (to - from);
        if ((at.cwiseAbs().array() <= half_size.array()).all()) return true;
    }
    return false;
}

// The same for the polyhedron of half its size about its centre.
bool crosses_core(const Vector3& from, const Vector3& to, const engine::collision::Hull& hull) {
    double enters = 0.0, leaves = 1.0;  // shares of the way
    for (const engine::collision::HullFace& face : hull.faces) {
        const double at_from = face.normal.dot(from) - 0.5 * face.offset,
                     at_to = face.normal.dot(to) - 0.5 * face.offset;
        if (at_from > 0.0 && at_to > 0.0) return false;
        if (at_from > 0.0) enters = std::max(enters, at_from / (at_from - at_to));
        if (at_to > 0.0) leaves = std::min(leaves, at_from / (at_from - at_to));
    }
    return enters < leaves;
}

double distance_to_way(const Vector3& point, const Vector3& from, const Vector3& to) {
    const Vector3 way = to - from;
    const double length = way.squaredNorm();
    const double share = length > 0.0 ? std::clamp((point - from).dot(way) / length, 0.0, 1.0) : 0.0;
    return (from + share * way - point).norm();
}

}  // namespace

Obstacles::Obstacles(const BuiltScene& scene) {
    list(scene);
}

void Obstacles::follow(const BuiltScene& scene) {
    if (!scene.world.moves_any()) return;
    const std::vector<Box> boxes = std::move(boxes_);
    const std::vector<Sphere> spheres = std::move(spheres_);
    const std::vector<Polyhedron> polyhedra = std::move(polyhedra_);
    planes_.clear();
    boxes_.clear();
    spheres_.clear();
    polyhedra_.clear();
    list(scene);
    for (std::size_t i = 0; i < boxes.size(); ++i) boxes_[i].before = boxes[i].now;
    for (std::size_t i = 0; i < spheres.size(); ++i) spheres_[i].before = spheres[i].now;
    for (std::size_t i = 0; i < polyhedra.size(); ++i) polyhedra_[i].before = polyhedra[i].now;
}

void Obstacles::list(const BuiltScene& scene) {
    if (!scene.contacts) return;
    for (const auto& collider : scene.contacts->colliders()) {
        const engine::Body& body = scene.world.bodies[static_cast<std::size_t>(collider.body)];
        if (!body.is_static()) continue;
        const Pose pose{body.position, body.orientation.conjugate()};
        std::visit(engine::Overloaded{[&](const engine::collision::Plane&) {
                                          planes_.push_back({body.position, body.orientation * Vector3::UnitY()});
                                      },
                                      [&](const engine::collision::Box& box) {
                                          boxes_.push_back({pose, pose, box.half_size});
                                      },
                                      [&](const engine::collision::Sphere& sphere) {
                                          spheres_.push_back({pose, pose, sphere.radius});
                                      },
                                      [&](const engine::collision::Polyhedron& polyhedron) {
                                          polyhedra_.push_back({pose, pose, polyhedron.mesh});
                                      }},
                   collider.shape);
    }
}

bool Obstacles::is_behind_plane(const Vector3& centre) const {
    return std::any_of(planes_.begin(), planes_.end(),
                       [&](const Plane& plane) { return plane.normal.dot(centre - plane.point) < 0.0; });
}

bool Obstacles::is_passed(const Vector3& from, const Vector3& to) const {
    const auto passes_box = [&](const Box& box) {
        return crosses_middle(box.before.in_frame(from), box.now.in_frame(to), box.half_size);
    };
    const auto passes_sphere = [&](const Sphere& sphere) {
        return distance_to_way(Vector3::Zero(), sphere.before.in_frame(from), sphere.now.in_frame(to)) <
               0.5 * sphere.radius;
    };
    const auto passes_polyhedron = [&](const Polyhedron& polyhedron) {
        return crosses_core(polyhedron.before.in_frame(from), polyhedron.now.in_frame(to), polyhedron.mesh->hull());
    };
    return std::any_of(boxes_.begin(), boxes_.end(), passes_box) ||
           std::any_of(spheres_.begin(), spheres_.end(), passes_sphere) ||
           std::any_of(polyhedra_.begin(), polyhedra_.end(), passes_polyhedron);
}

}  // namespace pushfactor::demos
