// The parts of a world as the settings ask for them. What the settings switch off is not constructed.
#pragma once

#include "demos/scene.h"
#include "demos/settings.h"

#include <vector>

namespace pushfactor::demos {

void add_gravity(Scene& scene);

// Contacts between `colliders`. `friction` [1] is the scene's own coefficient of all bodies; with 0 there is no
// friction rule.
void add_contacts(Scene& scene, std::vector<engine::collision::Collider> colliders, double friction,
                  const Settings& settings);

// Solver, termination and orientation step.
void add_solver(Scene& scene, const Settings& settings);

}  // namespace pushfactor::demos
