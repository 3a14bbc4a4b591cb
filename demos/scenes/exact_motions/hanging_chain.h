// The exact motion of a chain of balls on massless bars in a vertical plane. The reference for the chain. With
// M_k the mass of ball k and of all below it:
//
//   sum_j M_max(i,j) l_i l_j (cos(a_i - a_j) a_j'' + sin(a_i - a_j) a_j'^2) + J_i a_i'' + M_i g l_i sin a_i = 0
//
// Symbols: a angle of a bar from hanging straight down [rad], l its length [m], J moment of inertia of a ball that
// is fixed to the bar above it, 0 if bars hold it by its centre [kg m^2], g gravity [m/s^2].
#pragma once

#include <Eigen/Core>

#include <vector>

namespace pushfactor::demos::scenes {

struct HangingChain {
    Eigen::VectorXd lengths;  // of the bars, from the top
    Eigen::VectorXd masses;   // of the balls at their lower ends, kg
    Eigen::VectorXd moments;  // J
    double gravity = 10.0;    // g
};

struct ChainSwing {
    Eigen::VectorXd angles, rates;  // rad, rad/s
};

// Advances by `time` [s] in `steps` steps of the classical Runge-Kutta method.
ChainSwing advance(const HangingChain& chain, ChainSwing swing, double time, int steps);

// Of the balls: to the side towards which angles grow, and up, from where the chain hangs [m].
std::vector<Eigen::Vector2d> places(const HangingChain& chain, const ChainSwing& swing);

}  // namespace pushfactor::demos::scenes
