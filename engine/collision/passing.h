// Which way bodies would meet that are nearly apart along more than one axis.
//
// What lies on a floor overlaps it a little, and beside the next box of the floor it overlaps that one by nothing
// but this little: the least overlap, or the only gap, is then along the floor, and the side of the next box would
// stop what only slides over the seam. So two bodies that overlap by no more than is permitted count as apart along
// an axis, and they meet along that axis which closes last. Two things say when an axis closes:
// - the motion before the step. What rests on something does not close in by its weight, because that is held;
// - what holds: the other touches of both bodies. A cube that lies on one box of a floor does not fall past the top
//   of the next one, whatever presses or drops it.
//
// Only asked where the axis that collide() chose would really close in this step: at rest nothing changes its
// normal.
//
// Not from the paper, whose manifolds (section 4) belong to the axis of least overlap.
#pragma once

#include "engine/bodies/motion.h"
#include "engine/collision/detector.h"
#include "engine/collision/separations.h"

#include <optional>
#include <span>
#include <vector>

namespace pushfactor::engine::collision {

class Passing {
  public:
    struct Step {
        std::span<const Collider> colliders;
        std::span<const Body> bodies;  // with the external forces of the step
        double dt = 0.0;               // s
        const Detection& detection;
        std::span<const int> awake;  // the colliders of bodies that are not at rest, ascending
        bool any_bounces = false;    // whether a collider does
    };

    // Gives the doubtful ones of `touches` (in ascending order of the pair) the points of the axis along which they
    // would meet, and takes out those that have none there. The new points are good until the next call.
    void put_right(std::vector<Touch>& touches, const Step& step);

    // Takes out of `touches` those that meet in the course of the step, as far as their motion alone is concerned,
    // but are kept apart by what holds their bodies.
    void take_out_held(std::vector<Touch>& touches, const Step& step);

  private:
    // The touches of each body, as linked lists.
    struct OfBody {
        std::vector<int> first;  // by body, place in `next` or -1
        std::vector<int> next;   // two for each touch, for its two bodies
    };
    struct Choice {
        Separation axis;
        double time = 0.0;  // s, until it closes
    };

    void list(std::span<const Touch> touches, const Step& step);
    bool is_held(const Touch& touch, const Separation& axis, const Vector3& where, std::span<const Touch> touches,
                 const Step& step) const;
    bool holds(const Touch& holder, int body, const Touch& touch, const Separation& axis, const Vector3& where,
               const Step& step) const;
    std::optional<Choice> last_to_close(const Touch& touch, std::span<const Touch> touches, const Step& step) const;
    bool is_kept_apart(const Touch& touch, std::span<const Touch> touches, const Step& step) const;

    // Of a touch of which something else was found than it had.
    struct Found {
        std::size_t touch = 0;  // by its place
        Manifold manifold;
    };

    OfBody of_body_;
    std::vector<Found> found_;
    std::vector<ContactPoint> points_;  // of all touches that have new ones
};

}  // namespace pushfactor::engine::collision
