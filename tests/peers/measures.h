// The measures, the same for every engine: from the states alone, without an engine's own figures.
#pragma once

#include "tests/peers/engine.h"

#include <string>
#include <vector>

namespace pushfactor::tests::peers {

struct Value {
    std::string name;  // with the unit
    double number = 0.0;
    std::string text;  // where it is a word
};

using Values = std::vector<Value>;

// Towers of cubes, the lowest first. Falls: a centre more than half a side below the lower of its start and its
// rest height. Leans: more than half a side sideways from its start. Penetration: how far the corners of a bottom
// lie below the plane of the top on which it stands, and the corners of that top above the plane of the bottom.
Values standing(const Scene& scene, const Run& run);

// Cubes that start inside each other. Thrown up: a centre more than half a side above its place at rest.
Values parting(const Scene& scene, const Run& run);

// Links: relative to the length. Energy: relative to what the bodies can lose, from the start to hanging straight
// down. Kinetic energy is taken at the time of the positions.
Values chain(const Scene& scene, const Run& run);

// Pendulums from fixed points that swing in the y-z plane, against the exact pendulum of the run's kind of joint,
// and the energy at the end.
Values wave(const Scene& scene, const Run& run);

// One body that turns freely: energy, angular momentum, and the attitude against a fine integration.
Values turning(const Scene& scene, const Run& run);

// The number of balls flying along x that are beyond x = 0.
Values through(const Scene& scene, const Run& run);

// Spheres on planes: the last second.
Values heap(const Scene& scene, const Run& run);

}  // namespace pushfactor::tests::peers
