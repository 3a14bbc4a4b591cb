// The named scenes, one file each, and what they share.
#pragma once

#include "demos/scenes/catalogue.h"
#include "demos/scenes/random.h"

#include <vector>

namespace pushfactor::demos::scenes {

// A view of `target` [m] from the front right and somewhat above; `height` [m] fills most of the picture.
inline View view_of(const engine::Vector3& target, double height) {
    // 38 degrees of view show 0.69 m of height per metre of distance; about a tenth more on each side is left free.
    const double distance = 1.9 * (height + 0.7);
    return {.eye = target + distance * engine::Vector3(0.45, 0.28, 1.0).normalized(), .target = target};
}

extern const SceneEntry stack, intersecting_stack;  // paper sections 10.1 and 10.2
extern const SceneEntry funnel, pendulum_grid;      // 10.3 with Figures 8 and 9
extern const SceneEntry pendulum_wave;              // 10.3 and Figure 10
extern const SceneEntry chain, heavy_on_light, arch, dominoes, platonic;

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

// The four planes of the funnel, as bodies without mass.
void add_funnel_planes(SceneDescription& scene, double mu);

// Centres [m] of `count` bodies that reach `reach` [m] from theirs: square layers as wide as the funnel at their
// height, each body a little off its place.
std::vector<engine::Vector3> funnel_places(int count, double reach, Random& random);

// Of a heap of `count` bodies of the volume of a ball of 0.5 m.
View view_into_funnel(int count);

}  // namespace pushfactor::demos::scenes
