// State of a run besides the bodies. With both, a resumed run is bit-identical to an uninterrupted one.
#pragma once

#include "engine/constraints/contact_cache.h"
#include "engine/constraints/distance_constraints.h"
#include "engine/constraints/joint_constraints.h"
#include "engine/step/rest.h"

#include <vector>

namespace pushfactor::demos {

// What the division of a step into engine steps depends on besides the state of the bodies.
struct DivisionMemory {
    double parts = 0.0;                    // of the step before, before rounding up; 0: none
    double force_rate = engine::infinity;  // 1/s, that the forces of the step before asked for
};

struct RunState {
    double time = 0.0;  // s, of the world; forces may depend on it
    DivisionMemory division{.parts = 1.0};
    std::vector<engine::DistanceForce> distance_forces{};  // N, one per distance
    std::vector<engine::JointForce> joint_forces{};        // N, one per joint
    std::vector<double> joint_angles{};                    // rad, one per joint, or none; NaN where it is not known
    engine::ContactCache contact_forces{};                 // colliders are the bodies in their order
    std::vector<engine::Rest::Memory> rest{};              // one per body, or none
};

}  // namespace pushfactor::demos
