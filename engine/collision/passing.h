// Chooses the contact axis of bodies that are nearly separated along more than one axis.
//
// A body on a floor overlaps it slightly, and it overlaps the adjacent box of the floor only by that little:
// the least overlap, or the only gap, is then along the floor, and the side of that box would stop a body that
// merely slides over the seam. So two bodies that overlap by no more than `permitted` count as separated along
// an axis, and they meet along the axis that closes last. Two things decide when an axis closes:
// - the motion before the step. A resting body does not close in by its weight, because that is held;
// - what holds the bodies: the other touches of both. A cube that lies on one box of a floor does not fall past
//   the top of the next one, whatever presses or drops it.
//
// Applied only if the axis chosen by collide() would really close in this step, so that at rest normals never
// change.
//
// Not from the paper, whose manifolds (section 4) belong to the axis of least overlap.
#pragma once

#include "engine/bodies/motion.h"
#include "engine/collision/detector.h"
#include "engine/collision/pairs/separations.h"

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
        std::span<const int> awake;  // colliders of bodies that are not at rest, ascending
        bool any_bounces = false;    // whether any collider bounces
    };

    // Gives the doubtful ones of `touches` (in ascending order of the pair) the points of the axis along which
    // they would meet, and removes those without points there. The new points are valid until the next call.
    void put_right(std::vector<Touch>& touches, const Step& step);

    // Removes from `touches` those that would meet during the step by their own motion but are kept apart by
    // what holds their bodies.
    void take_out_held(std::vector<Touch>& touches, const Step& step);

  private:
    // Touches of each body, as linked lists.
    struct OfBody {
        std::vector<int> first;  // by body, index into `next` or -1
        std::vector<int> next;   // two per touch, one for each body
    };
    struct Choice {
        Separation axis;
        double time = 0.0;  // s until it closes
    };

    void list(std::span<const Touch> touches, const Step& step);
    bool is_held(const Touch& touch, const Separation& axis, const Vector3& where, std::span<const Touch> touches,
                 const Step& step) const;
    bool holds(const Touch& holder, int body, const Touch& touch, const Separation& axis, const Vector3& where,
               const Step& step) const;
    std::optional<Choice> last_to_close(const Touch& touch, std::span<const Touch> touches, const Step& step) const;
    bool is_kept_apart(const Touch& touch, std::span<const Touch> touches, const Step& step) const;

    // New manifold of a touch.
    struct Found {
        std::size_t touch = 0;  // index
        Manifold manifold;
    };

    OfBody of_body_;
    std::vector<Found> found_;
    std::vector<ContactPoint> points_;  // of all touches with new ones
};

}  // namespace pushfactor::engine::collision
