// Scenes of the stress list that are known elsewhere too. Bodies that do not touch each other share a scene; units
// as in bodies.h.
#pragma once

#include "demos/scenes/scene_description.h"

namespace pushfactor::demos::reports::stability {

SceneDescription bouncing_ball();  // radius 0.1 m, dropped by 2 m, restitution 1

// Cards of 1 x 0.01 x 0.6 m: one inclined by `angle` against the edge of a box 0.4 m high; and two that lean
// against each other, each standing on its long edge.
constexpr double card_thickness = 0.01;  // m
SceneDescription card_leaning(double angle);
SceneDescription card_house(double angle);

// s, by the elliptic integral: of a rod 1 x 0.04 x 0.04 m that is hung by its end, from rest, `angle` from hanging.
double rod_pendulum_period(double angle);

// Five rods 0.5 x 0.04 x 0.04 m joined by ball joints, in a straight line `angle` from hanging, at rest.
SceneDescription ball_joint_chain(double angle);

// 16 cubes in a ring that slide outwards, each in a different direction relative to its edges, on a plane or a box.
SceneDescription cubes_in_16_directions(double speed, double friction, bool on_box);

// A slab of 1 x 0.2 x 1 m that slides and turns by `spin` [rad/s] about the vertical; gravity 9.81 m/s^2.
SceneDescription spinning_slab(double speed, double spin, double friction);

struct Ride {
    double speed = 4.0;   // m/s
    double angle = 0.0;   // rad, about the vertical, between the direction of motion and the rows of boxes
    double uneven = 0.0;  // m, by which every other box lies lower
};

// A cube and a plank 2 x 0.2 x 0.2 m, which slide without friction, and on an even floor a rolling ball of radius
// 0.5 m: on a floor of boxes, and the same bodies again on a single box behind it. The higher boxes of an uneven
// floor carry the bodies, so that both should move alike.
SceneDescription seam_floor(const Ride& ride);

}  // namespace pushfactor::demos::reports::stability
