// A tower of equal cubes above the ground, the common part of both stacks.
#pragma once

#include "demos/scene.h"

namespace pushfactor::demos::scenes {

// The cubes of section 10.1.
constexpr double cube_side = 2.4;      // m
constexpr double cube_mass = 1.2;      // kg
constexpr double cube_friction = 0.5;  // the paper does not give one

struct Tower {
    int count = 5;
    double gap = 0.6;         // m between neighbours, below zero is overlap
    double ground_gap = 0.8;  // m below the lowest
    double jitter = 0.0;      // m, each cube up to this far sideways; then also turned by up to 0.02 rad
    int seed = 1;             // of the jitter
};

Scene cube_tower(const Tower& tower, const Settings& settings);

// A view from the front right that shows everything up to `height` [m].
View view_of_height(double height);

}  // namespace pushfactor::demos::scenes
