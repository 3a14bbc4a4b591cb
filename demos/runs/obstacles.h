// The static bodies of a scene as obstacles that no other body may pass through.
#pragma once

#include "demos/runs/scene.h"

#include <vector>

namespace pushfactor::demos {

class Obstacles {
  public:
    explicit Obstacles(const BuiltScene& scene);
    // After each step, if any body has a path.
    void follow(const BuiltScene& scene);

    // Whether a centre is on the wrong side of a plane. Positions in m, world frame.
    bool is_behind_plane(const engine::Vector3& centre) const;
    // Whether a centre that moves straight from one place to the other gets to the other side of a box between its
    // faces, or as deep as half its radius into a sphere, or into the inner half of a polyhedron: bodies that touch
    // and roll off come nowhere near that. `from` belongs to the step before; relative to an obstacle that has
    // moved since.
    bool is_passed(const engine::Vector3& from, const engine::Vector3& to) const;

  private:
    struct Pose {
        engine::Vector3 centre;
        engine::Matrix3 from_world;

        engine::Vector3 in_frame(const engine::Vector3& point) const { return from_world * (point - centre); }
    };
    struct Obstacle {
        int body = 0;
        Pose before, now;
        engine::collision::Shape shape;
    };

    static Pose pose_of(const engine::Body& body);

    std::vector<Obstacle> all_;
};

}  // namespace pushfactor::demos
