// Bodies on a floor of flush boxes, which should be one floor to them.
#pragma once

#include "demos/scenes/scene_description.h"

namespace pushfactor::demos::reports::stability {

struct Ride {
    double speed = 4.0;   // m/s
    double angle = 0.0;   // rad, about the vertical, between the way and the rows of boxes
    double uneven = 0.0;  // m, by which every other box lies lower
};

// A cube of 1 m and a plank 2 x 0.2 x 0.2 m, which slide without friction, and on an even floor a ball of radius
// 0.5 m, which rolls: on a floor of boxes, and the same bodies again on a single box behind it. Of an uneven floor
// the higher boxes carry, so that mechanics knows no difference.
SceneDescription seam_floor(const Ride& ride);

// How far the bodies of stopped_by_...() get, m.
constexpr double way_to_stop = 0.5;

// A cube of 1 m that slides without friction along flush boxes into a wall.
SceneDescription stopped_by_wall(double speed);

// A cube of 1 m that slides, friction 0.3, into a box of the floor which is 0.05 m higher than the others. Where it
// meets it, it tips by what is left of its speed, and falls back.
SceneDescription cube_stopped_by_step(double speed);

// A slab 1 x 0.1 x 1 m that slides without friction into such a step: nothing tips it, as the step is as high as
// its centre.
SceneDescription slab_stopped_by_step(double speed);

}  // namespace pushfactor::demos::reports::stability
