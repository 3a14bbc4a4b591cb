// State of a run besides the bodies. With both, a resumed run is bit-identical to an uninterrupted one.
#pragma once

#include "engine/constraints/contact_cache.h"
#include "engine/constraints/distance_constraints.h"
#include "engine/constraints/joint_constraints.h"
#include "engine/step/rest.h"

#include <vector>

namespace pushfactor::demos {

struct RunState {
    double time = 0.0;   // s, of the world; forces may depend on it
    double parts = 1.0;  // of the last step, into engine steps, before rounding up; 0: none
    std::vector<engine::DistanceForce> distance_forces{};  // N, one per distance
    std::vector<engine::JointForce> joint_forces{};        // N, one per joint
    std::vector<double> joint_angles{};                    // rad, one per joint, or none; NaN where it is not known
    engine::ContactCache contact_forces{};                 // colliders are the bodies in their order
    std::vector<engine::Rest::Memory> rest{};              // one per body, or none
};

}  // namespace pushfactor::demos
