// Scenes about friction, whose outcome mechanics knows. Bodies that do not touch each other share a scene.
#pragma once

#include "demos/scenes/scene_description.h"

namespace pushfactor::demos::reports::stability {

// 16 cubes of 1 m in a ring that slide outwards at `speed` [m/s], each in another direction relative to its edges,
// on a plane or on a box.
SceneDescription cubes_in_16_directions(double speed, double friction, bool on_box);

// 16 cubes of 1 m in a field that slide in the same direction, each turned otherwise about the vertical.
SceneDescription cubes_turned_16_ways(double speed, double friction);

// 16 balls of radius 0.5 m in a ring that slide outwards without turning.
SceneDescription balls_in_16_directions(double speed, double friction);

// A slab of 1 x 0.2 x 1 m that slides at `speed` [m/s] and turns by `spin` [rad/s] about the vertical; gravity
// 9.81 m/s^2.
SceneDescription spinning_slab(double speed, double spin, double friction);

// Cubes of 1 m that turn on the spot about the vertical by `spin` [rad/s], some one way and some the other.
SceneDescription spinning_cubes(double spin, double friction);

// Cubes of 1 m on an inclined plane, each turned otherwise about its normal, friction 0.5: the ground is level,
// gravity is inclined by `angle` [rad] towards +x.
SceneDescription slope(double angle);

// Balls of radius 0.5 m, of 1 kg and of 10 kg, at rest on such a slope, and where `across` is not zero one that
// begins to roll across it at that speed [m/s].
SceneDescription balls_on_slope(double angle, double across);

// Cubes of 1 m in steady motion at 1 m/s, a few millimetres above a plane; a force holds their weight.
SceneDescription hovering_cubes();

}  // namespace pushfactor::demos::reports::stability
