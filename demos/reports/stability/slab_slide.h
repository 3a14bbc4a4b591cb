// Sliding distance of a slab that spins about the vertical while it slides: rigid, Coulomb friction at its four
// lower corners, always lying flat.
//
// The loads N of the corners follow from the weight and the moments about both horizontal axes (friction acts half
// the height below the centre): three equations for four unknowns. The fourth is a choice: here loads are linear in
// the position, as for a slab on elastic ground. Shifting a tenth of the weight from one pair of opposite corners
// to the other changes the result by half a percent.
#pragma once

namespace pushfactor::demos::reports::stability {

struct Slab {
    double side = 1.0;      // m, of its square
    double height = 0.2;    // m
    double friction = 0.3;  // mu
    double gravity = 9.81;  // m/s^2
};

// Distance from start to stop [m] for `speed` [m/s] and `spin` [rad/s], not both zero.
double slide_of(const Slab& slab, double speed, double spin);

}  // namespace pushfactor::demos::reports::stability
