// Cuboid dice with a square cross-section: how often one of the two square faces ends up on top.
#pragma once

#include <functional>
#include <vector>

namespace pushfactor::demos::reports::reality {

// The throws of assets/measured/dice.csv (Mathematical Gazette 97.16, 2013): steel dice.
struct Die {
    double length = 1.0;  // over the edge of the square
    double share = 0.0;   // of throws with a square face on top
    int throws = 0;
};

// Throws RunError for a missing or damaged file.
std::vector<Die> read_dice();

struct Bounce {
    double friction = 0.0, restitution = 0.0;
};

// How many of `throws` computed ones, the first of which has this number, end with a square face on top. A die of
// 12 mm falls from 0.2 m, at up to 1 m/s sideways, in any orientation and turning about any axis at up to 60 rad/s.
int square_faces(double length, const Bounce& bounce, int first, int throws, const std::function<void()>& check);

}  // namespace pushfactor::demos::reports::reality
