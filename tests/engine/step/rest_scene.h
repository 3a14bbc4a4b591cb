// Scenes that come to rest, and queries for tests.
#pragma once

#include "engine/bodies/body.h"
#include "engine/step/rest.h"
#include "tests/catch.h"
#include "tests/engine/contact_scene.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace pushfactor::tests::resting {

using namespace engine;

inline constexpr double dt = ContactScene::dt;

// Boxes of 1 m on top of each other; the numbers of the bodies follow each other.
inline void add_tower(ContactScene& scene, int count, const Vector3& foot = {0, 0, 0}) {
    for (int i = 0; i < count; ++i) scene.add_box(Vector3::Ones(), foot + Vector3(0, 0.5 + i, 0));
}

inline void build(ContactScene& scene, const Vector3& gravity = {0, -10, 0}) {
    scene.build(gravity);
    scene.world.rest = std::make_unique<Rest>();
}

inline int steps_of(double seconds) {
    return static_cast<int>(std::lround(seconds / dt));
}

inline StepCount advance(World& world, double seconds) {
    StepCount count;
    for (int i = 0; i < steps_of(seconds); ++i) count = world.step(dt);
    return count;
}

// The most bodies that were at rest after any step.
inline int most_at_rest(World& world, double seconds) {
    int most = 0;
    for (int i = 0; i < steps_of(seconds); ++i) most = std::max(most, world.step(dt).at_rest);
    return most;
}

// Five boxes on the ground that have come to rest.
inline void settle_tower(ContactScene& scene) {
    build(scene);
    REQUIRE(advance(scene.world, 1.0).at_rest == 5);
}

inline void add_ground_and_tower(ContactScene& scene) {
    scene.add_ground();
    add_tower(scene, 5);
}

inline double energy(const World& world) {
    return kinetic_energy(world.bodies) + potential_energy(world.bodies, {0, -10, 0});
}

}  // namespace pushfactor::tests::resting
