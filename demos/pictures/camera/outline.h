// What a picture is about: everything that moves in it, and what that stands and hangs on; and cameras that fill
// the picture with it.
#pragma once

#include "demos/pictures/camera/framing.h"
#include "demos/runs/scene.h"
#include "demos/scenes/scene_description.h"

#include <limits>
#include <span>
#include <vector>

namespace pushfactor::demos::pictures {

// The farthest points of many balls in each of some directions. Memory does not grow with the number of balls; none
// of them is farther outside of the hull of those that are kept than about 1 % of its size.
class Outline {
  public:
    Outline();

    void add(const Ball& ball);
    void add(const Outline& other);

    bool empty() const { return farthest_.front().distance == -infinity; }
    std::vector<engine::Vector3> points() const;

  private:
    static constexpr double infinity = std::numeric_limits<double>::infinity();
    struct Farthest {
        double distance = -infinity;  // m, along the direction
        engine::Vector3 point = engine::Vector3::Zero();
    };
    std::vector<Farthest> farthest_;
};

// Adds the bodies that move or may move, as they are now, with the ends of their bars. Bodies that have left `near`
// are added where they left it.
void add_moving(const BuiltScene& scene, const Eigen::AlignedBox3d& near, Outline& outline);

// Adds what stands still next to the outline: bodies, and the planes that are drawn as walls, as far as they are
// near it.
void add_support(const BuiltScene& scene, Outline& outline);

// What a camera has to show, and where on the ground the sun throws its shadow; no shadow without a ground.
struct Subject {
    std::vector<engine::Vector3> points, shadow;  // m, world frame
};
Subject subject_of(const BuiltScene& scene, const Outline& outline);

// The same with room for letters above and below it, as shares of its height.
Subject with_room(Subject subject, double above, double below);

// The part of the picture that the points span, 0 to 1 from left and top, seen by `view`; beyond that range for
// points outside of the picture.
Eigen::AlignedBox2d extent_of(std::span<const engine::Vector3> points, const View& view, double aspect);

// A view of all points from about the direction of `view`, as close as possible: it is turned by up to 45 degrees
// and raised by up to 20 where that fills a picture of this aspect (width over height) much better. Where the
// subject leaves room to the sides, it is in the middle together with its shadow.
View composed(const View& view, const Subject& subject, double aspect);

}  // namespace pushfactor::demos::pictures
