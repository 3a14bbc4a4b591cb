// Warnings of a run about unsolved steps and about steps that were too long.
#pragma once

#include "demos/runs/measurements.h"

#include <string>

namespace pushfactor::demos {

// One line for unsolved steps, one for steps whose rows contradict each other, one for energy without a source and
// stretched bars, with the option to try; empty without warnings. `name` is the name of the run.
std::string warning_text(const std::string& name, const Simulation& simulation, const Measurements& measured);

}  // namespace pushfactor::demos
