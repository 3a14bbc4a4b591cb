// Scenes of the stress list that are not in the catalogue. Bodies that do not touch each other share a scene.
// Unless stated otherwise cubes have 1 m and bodies 1 kg; speeds are in m/s, angles in rad.
#pragma once

#include "demos/scenes/scene_description.h"

#include <vector>

namespace pushfactor::demos::reports::stability {

constexpr double usual_gravity = 10.0;  // m/s^2

// Single bodies.

SceneDescription falling_cube(double gap, double speed);  // `gap` [m] above the ground
SceneDescription ball_on_plate(
    double speed);  // radius 0.1 m, falls onto 0.1 m; lying there its centre is at height 0
// A ball of radius 0.1 m that passes a static box of these edges [m] at a distance of its radius, without gravity.
SceneDescription ball_past(const engine::Vector3& size, double speed);
SceneDescription free_rod(double rate);  // 2 x 0.1 x 0.1 m, turns by `rate` [rad/s] about its length and across
SceneDescription free_box();             // 1 x 4 x 9 m, turns by 3 rad/s, most of it about its middle axis
SceneDescription tumbling_box();         // 1 x 0.4 x 0.2 m, tumbles and bounces without friction, restitution 1
SceneDescription bouncing_ball();        // radius 0.1 m, dropped by 2 m, restitution 1

// Stacked cubes, each overlapping the one below by a ten-thousandth of its side and slightly offset, so that no
// symmetry helps.
struct Pile {
    int count = 5;
    double side = 1.0;                                 // m, of cubes as dense as water
    engine::Vector3 origin = engine::Vector3::Zero();  // m, below the lowest
    double gravity = 10.0;                             // m/s^2
};
SceneDescription pile(const Pile& pile);

// Two cubes on the ground that overlap by `overlap` [m], up to 1: the same centre.
SceneDescription overlapping(double overlap);
// A ball of 2 kg that hangs at `depth` [m] on bars of these lengths [m], all between the same two points.
SceneDescription hanging(const std::vector<double>& lengths, double depth);
// Two overlapping static boxes, and a ball far from them as the only movable body.
SceneDescription overlapping_walls();

// Thin bodies, and rods on ball joints.

constexpr double card_thickness = 0.01;   // m
constexpr double plank_thickness = 0.02;  // m

// A card 1 x 0.01 x 0.6 m: flat on the ground; upright on its long edge, flat against a box; inclined by `angle`
// against the edge of a box 0.4 m high; and two that lean against each other, each standing on its long edge.
SceneDescription card_lying();
SceneDescription card_upright();
SceneDescription card_leaning(double angle);
SceneDescription card_house(double angle);
SceneDescription plank_on_supports();  // 2 x 0.02 x 0.2 m on two boxes
SceneDescription rod_lying();          // 1 x 0.01 x 0.01 m

// A rod 1 x 0.04 x 0.04 m, hung by its end with a ball joint, at rest, `angle` from hanging.
SceneDescription rod_pendulum(double angle);
double rod_pendulum_period(double angle);  // s, by the elliptic integral

// Five rods 0.5 x 0.04 x 0.04 m joined by ball joints, in a straight line `angle` from hanging, at rest.
SceneDescription ball_joint_chain(double angle);
double ball_joint_chain_swing(double angle);  // J, from there to straight down

// Friction problems with known results.

// 16 cubes in a ring that slide outwards, each in a different direction relative to its edges, on a plane or a box.
SceneDescription cubes_in_16_directions(double speed, double friction, bool on_box);
// 16 cubes in a grid that slide in the same direction, each turned by a different angle about the vertical.
SceneDescription cubes_turned_16_ways(double speed, double friction);
// 16 balls of radius 0.5 m in a ring that slide outwards without turning.
SceneDescription balls_in_16_directions(double speed, double friction);
// A slab of 1 x 0.2 x 1 m that slides and turns by `spin` [rad/s] about the vertical; gravity 9.81 m/s^2.
SceneDescription spinning_slab(double speed, double spin, double friction);
// Cubes that turn on the spot about the vertical by `spin` [rad/s], some one way and some the other.
SceneDescription spinning_cubes(double spin, double friction);
// Cubes on an inclined plane, each turned by a different angle about its normal, friction 0.5: the ground is level,
// gravity is inclined by `angle` towards +x.
SceneDescription slope(double angle);
// Balls of radius 0.5 m, of 1 kg and of 10 kg, at rest on such a slope, and where `across` is not zero one that
// begins to roll across it at that speed.
SceneDescription balls_on_slope(double angle, double across);
// Cubes in steady motion at 1 m/s, a few millimetres above a plane; a force holds their weight.
SceneDescription hovering_cubes();

// Floors of flush boxes, which should behave like a single box.

struct Ride {
    double speed = 4.0;   // m/s
    double angle = 0.0;   // rad, about the vertical, between the direction of motion and the rows of boxes
    double uneven = 0.0;  // m, by which every other box lies lower
};

// A cube and a plank 2 x 0.2 x 0.2 m, which slide without friction, and on an even floor a rolling ball of radius
// 0.5 m: on a floor of boxes, and the same bodies again on a single box behind it. The higher boxes of an uneven
// floor carry the bodies, so that both should move alike.
SceneDescription seam_floor(const Ride& ride);

constexpr double way_to_stop = 0.5;  // m, of the bodies that are stopped

// A cube that slides without friction along flush boxes into a wall.
SceneDescription stopped_by_wall(double speed);
// A cube that slides, friction 0.3, into a box of the floor that is 0.05 m higher than the others. There its
// remaining speed tips it, and it falls back.
SceneDescription cube_stopped_by_step(double speed);
// A slab 1 x 0.1 x 1 m that slides without friction into such a step, which is as high as its centre, so that it
// does not tip.
SceneDescription slab_stopped_by_step(double speed);

}  // namespace pushfactor::demos::reports::stability
