// Seams: which way two bodies touch that are flush with what one of them lies on.
//
// A body comes no closer to what it lies on along the normal there: a cube on a floor does not fall past the top of
// the next box of that floor. So a pair that is separated along this normal at the start of the step, or overlaps
// along it by no more than bodies may (`permitted`), stays so: it does not meet along any other direction, whatever
// its free motion says, and it touches along this one if it has a face there. Otherwise the side of the next box
// would stop the cube, because a body on a floor overlaps the side of that box by just as little as its top.
//
// What a body lies on is a touch of either body of the pair that holds it:
// - it touches before the pair meets, and is not itself held apart by the pair;
// - a movable body holds only what hardly moves towards it, for it may give way.
//
// Not from the paper, whose manifolds (section 4) belong to the axis of least overlap.
#pragma once

#include "engine/collision/detector.h"

#include <optional>
#include <span>
#include <vector>

namespace pushfactor::engine::collision {

class Seams {
  public:
    // Gives those of `touches` that cannot meet as found the points along the normal of what holds them, and
    // removes those without points there. `holders`: the touches that may hold.
    void put_right(const StepScene& step, std::span<const Touch> holders, std::vector<Touch>& touches);
    void put_right(const StepScene& step, std::vector<Touch>& touches) { put_right(step, touches, touches); }

  private:
    void list(std::span<const Touch> touches, std::size_t bodies);
    std::optional<Vector3> held_along(const Touch& touch, std::span<const Touch> holders,
                                      const StepScene& step) const;

    // Touches of each body as linked lists: by body, and two per touch, indices into `next_` or -1.
    std::vector<int> first_, next_;
    std::vector<std::size_t> in_doubt_;
    std::vector<std::pair<std::size_t, std::span<const ContactPoint>>> found_;  // new points, by touch
    Manifold manifold_;                                                         // scratch
};

}  // namespace pushfactor::engine::collision
