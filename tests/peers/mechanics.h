// Mechanical quantities of states that several measures use.
#pragma once

#include "tests/peers/engine.h"

namespace pushfactor::tests::peers {

bool finite(const Run& run);

Vector3 angular_momentum(const Body& body, const State& s);  // about its centre, kg m^2/s

double kinetic(const Scene& scene, const std::vector<State>& states);    // J
double potential(const Scene& scene, const std::vector<State>& states);  // J, 0 at the origin

}  // namespace pushfactor::tests::peers
