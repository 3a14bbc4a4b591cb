// Small scenes of the stress list that the catalogue has no use for.
#pragma once

#include "demos/scenes/scene_description.h"

#include <vector>

namespace pushfactor::demos::reports::stability {

// A cube of 1 m, `gap` [m] above the ground, falling at `speed` [m/s].
SceneDescription falling_cube(double gap, double speed);

// A ball of radius 0.1 m falling at `speed` [m/s] onto a plate 0.1 m thick. Lying on it its centre is at height 0.
SceneDescription ball_on_plate(double speed);

// A ball of radius 0.1 m that passes a static box of these edges [m] at a distance of its radius, without gravity.
SceneDescription ball_past(const engine::Vector3& size, double speed);

// A rod 2 x 0.1 x 0.1 m turning by `rate` [rad/s] about its length and by as much across, and nothing else.
SceneDescription free_rod(double rate);

// A box 1 x 4 x 9 m turning by 3 rad/s, most of it about its middle axis, and nothing else.
SceneDescription free_box();

// A box 1 x 0.4 x 0.2 m that tumbles and bounces without friction, restitution 1.
SceneDescription tumbling_box();

// A ball of radius 0.1 m dropped by 2 m, restitution 1.
SceneDescription bouncing_ball();

struct Pile {
    int count = 5;
    double side = 1.0;                                 // m, of cubes as dense as water
    engine::Vector3 origin = engine::Vector3::Zero();  // m, below the lowest
    double gravity = 10.0;                             // m/s^2
};

// Cubes on each other, each by a ten thousandth of its side in the one below and a little beside it, so that no
// symmetry helps.
SceneDescription pile(const Pile& pile);

// Two cubes of 1 m on the ground, the upper one in the lower one by `overlap` [m], up to 1: the same centre.
SceneDescription overlapping(double overlap);

// A ball of 2 kg that hangs at `depth` [m] on bars of these lengths [m], all between the same two points.
SceneDescription hanging(const std::vector<double>& lengths, double depth);

// Two static boxes in each other, and nothing that moves but a ball far from them.
SceneDescription overlapping_walls();

}  // namespace pushfactor::demos::reports::stability
