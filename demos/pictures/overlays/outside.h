// What acts on a scene from outside, for overlays: forces and torques, motors, moved bodies, pairs that are kept
// from touching.
#pragma once

#include "demos/runs/scene.h"
#include "engine/base/math.h"

#include <cstddef>
#include <vector>

namespace pushfactor::demos::pictures {

struct Quantity {
    engine::Vector3 place = engine::Vector3::Zero();  // m
    engine::Vector3 value = engine::Vector3::Zero();  // N, N m or m/s; of lines m
    std::size_t kind = 0;                             // index into the entries of the overlay's kind
};

// Torques of the scene on single bodies as they are now [N m], at the centres of mass.
void add_applied_torques(const BuiltScene& scene, std::size_t kind, std::vector<Quantity>& found);

// Torques of motors in the last step [N m], along their axes on the bodies that they turn, at the hinges.
void add_motor_torques(const BuiltScene& scene, std::size_t kind, std::vector<Quantity>& found);

// Mean velocities of moved bodies in the last step [m/s]: of the centre, and of four points around the axis of one
// that turns.
void add_moved_velocities(const BuiltScene& scene, std::size_t kind, std::vector<Quantity>& found);

// Lines between bodies that do not touch each other [m], from `place` by `value`: one per pair, and one from each
// body of a group to the middle of the group.
void add_untouching(const BuiltScene& scene, std::size_t kind_of_pairs, std::size_t kind_of_groups,
                    std::vector<Quantity>& found);

}  // namespace pushfactor::demos::pictures
