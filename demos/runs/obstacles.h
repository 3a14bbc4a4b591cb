// The static bodies of a scene as what no other body may get through.
#pragma once

#include "demos/runs/scene.h"

#include <vector>

namespace pushfactor::demos {

class Obstacles {
  public:
    explicit Obstacles(const BuiltScene& scene);  // static bodies stay where they are

    // Whether a centre is on the wrong side of a plane. Positions in m, world frame.
    bool is_behind_plane(const engine::Vector3& centre) const;

    // Whether a centre that moves straight from one place to the other gets to the other side of a box between its
    // faces, or as deep as half its radius into a sphere, or into the inner half of a polyhedron: bodies that touch
    // and roll off come nowhere near that.
    bool is_passed(const engine::Vector3& from, const engine::Vector3& to) const;

  private:
    struct Plane {
        engine::Vector3 point, normal;
    };
    struct Box {
        engine::Vector3 centre, half_size;
        engine::Quaternion to_box;  // from the world frame
    };
    struct Sphere {
        engine::Vector3 centre;
        double radius = 0.0;  // m
    };
    struct Polyhedron {
        engine::Vector3 centre;
        std::shared_ptr<const engine::collision::PolyhedronMesh> mesh;
        engine::Quaternion to_body;  // from the world frame
    };

    std::vector<Plane> planes_;
    std::vector<Box> boxes_;
    std::vector<Sphere> spheres_;
    std::vector<Polyhedron> polyhedra_;
};

}  // namespace pushfactor::demos
