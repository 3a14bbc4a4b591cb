// How far a slab slides that turns about the vertical while it slides: rigid, friction at its four lower corners by
// Coulomb's law, always lying flat.
//
// The corners' loads N follow from the weight and from the moments about both horizontal axes (friction attacks
// half a height below the centre): three equations for four unknowns. The fourth is a choice: here loads are linear
// in the place, as those of a slab on an elastic ground are. Shifting a tenth of the weight from one pair of
// opposite corners to the other moves the result by half a percent.
#pragma once

namespace pushfactor::demos::reports::stability {

struct Slab {
    double side = 1.0;      // m, of its square
    double height = 0.2;    // m
    double friction = 0.3;  // mu
    double gravity = 9.81;  // m/s^2
};

// From where it is to where it stops, m; from `speed` [m/s] and `spin` [rad/s], not both zero.
double slide_of(const Slab& slab, double speed, double spin);

}  // namespace pushfactor::demos::reports::stability
