// Cards, planks and rods that lie, stand and lean; and rods on ball joints.
#pragma once

#include "demos/scenes/scene_description.h"

namespace pushfactor::demos::reports::stability {

constexpr double card_thickness = 0.01;   // m
constexpr double plank_thickness = 0.02;  // m

// A card 1 x 0.01 x 0.6 m: flat on the ground; upright on its long edge, flat against a box; and inclined by
// `angle` [rad] against the edge of a box 0.4 m high.
SceneDescription card_lying();
SceneDescription card_upright();
SceneDescription card_leaning(double angle);

// Two cards that lean against each other, each inclined by `angle` [rad] and standing on its long edge.
SceneDescription card_house(double angle);

// A plank 2 x 0.02 x 0.2 m on two boxes.
SceneDescription plank_on_supports();

// A rod 1 x 0.01 x 0.01 m on the ground.
SceneDescription rod_lying();

// A rod 1 x 0.04 x 0.04 m, hung by its end with a ball joint: it is `angle` [rad] from hanging, at rest.
SceneDescription rod_pendulum(double angle);
double rod_pendulum_period(double angle);  // s, by the elliptic integral

// Five rods 0.5 x 0.04 x 0.04 m joined by ball joints, in a straight line `angle` [rad] from hanging, at rest.
SceneDescription ball_joint_chain(double angle);
double ball_joint_chain_swing(double angle);  // J, from there to straight down

}  // namespace pushfactor::demos::reports::stability
