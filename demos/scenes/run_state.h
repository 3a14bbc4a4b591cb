// What a run carries from step to step beside the bodies; with it and theirs it goes on to the same bits.
#pragma once

#include "engine/constraints/contact_cache.h"
#include "engine/constraints/distance_constraints.h"
#include "engine/constraints/joint_constraints.h"
#include "engine/step/island_solver.h"
#include "engine/step/rest.h"

#include <vector>

namespace pushfactor::demos {

struct RunState {
    double time = 0.0;                                       // s, of the world; forces may depend on it
    std::vector<engine::IslandSolver::Memory> warm_start{};  // one per body; none when nothing has been solved yet
    double substeps = 1.0;                                   // asked for in the last step; fades from step to step
    std::vector<engine::DistanceForce> distance_forces{};    // N, one a distance
    std::vector<engine::JointForce> joint_forces{};          // N, one a joint
    engine::ContactCache contact_forces{};                   // colliders are the bodies in their order
    std::vector<engine::Rest::Memory> rest{};                // one per body, or none
};

}  // namespace pushfactor::demos
