// A tower of equal cubes above the ground, the common part of the stacks.
#pragma once

#include "demos/scenes/scene_description.h"

namespace pushfactor::demos::scenes {

// The cubes of section 10.1; the paper gives no friction.
struct Tower {
    int count = 5;
    double side = 2.4;        // m
    double mass = 1.2;        // kg, each
    double gap = 0.6;         // m between neighbours, below zero is overlap
    double ground_gap = 0.8;  // m below the lowest
    double jitter = 0.0;      // m, each cube up to this far sideways; then also turned by up to 0.02 rad
    int seed = 1;             // of the jitter
};

// The first body is the ground, then the cubes from below.
SceneDescription cube_tower(const Tower& tower);

// A view that shows everything up to `height` [m].
View view_of_height(double height);

}  // namespace pushfactor::demos::scenes
