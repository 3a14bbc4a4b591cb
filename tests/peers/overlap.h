// The overlap of bodies: one measure for all engines, from positions alone and without any engine's own contacts.
#pragma once

#include "tests/peers/scene.h"

namespace pushfactor::tests::peers {

// Over the pairs of bodies that overlap by more than rounding (1 nm), two movable ones or one and a fixed one.
// Depth of a pair: the shortest separating translation. Of two boxes that is the least overlap along their
// separating axes, of a box and a plane the depth of its deepest corner.
struct Overlap {
    double deepest = 0.0;  // m
    double rms = 0.0;      // m, 0 without pairs
    std::size_t pairs = 0;
};
Overlap overlap(const Scene& scene, const std::vector<State>& states);

}  // namespace pushfactor::tests::peers
