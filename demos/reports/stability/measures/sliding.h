// Measures of bodies that slide, roll or swing: one number for each movable body of the scene.
#pragma once

#include "demos/reports/stability/measures/tracks.h"

#include <optional>

namespace pushfactor::demos::reports::stability {

// How far it ended from where it started, and how far it ever was; horizontally [m].
double slide(const Track& track);
double farthest(const Track& track);

// How far it ever was beside the vertical plane through its start along its first velocity [m].
double sideways(const Track& track);

double last_speed(const Track& track);  // m/s

// The largest angular velocity, and that about the vertical [rad/s].
double largest_spin(const Track& track);
double vertical_spin(const Track& track);

// By which angle it turned in all, from one moment to the next by less than half a turn [rad].
double turned_angle(const Track& track);

// Over the last second [m/s^2].
std::optional<double> acceleration(const Track& track);

// How far the velocity ever was from the first one [m/s].
double deflection(const Track& track);

// Time of a swing to and fro, from the first to the last passage of its centre through x = 0 in the direction of +x
// [s]. Nothing below two passages.
std::optional<double> swing_period(const Track& track);

// Twins: the first half of a scene's movable bodies and, in the same order, the second half. How far their ways
// and their velocities ever differ: one number a pair.
std::vector<double> twin_distances(const Evidence& evidence);   // m
std::vector<double> twin_velocities(const Evidence& evidence);  // m/s

}  // namespace pushfactor::demos::reports::stability
