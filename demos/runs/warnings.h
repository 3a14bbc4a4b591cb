// What a run says aloud about what was not solved, and about steps that were too long for it.
#pragma once

#include "demos/runs/measurements.h"

#include <string>

namespace pushfactor::demos {

// One line for steps that were not solved, one for steps whose rows contradict each other, one for energy out of
// nothing and bars that gave way, with the option that helps; empty when all is well. `name` is what the run is
// called.
std::string warning_text(const std::string& name, const Simulation& simulation, const Measurements& measured);

}  // namespace pushfactor::demos
