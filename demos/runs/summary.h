// The summary of a run as JSON text.
#pragma once

#include "demos/options/choices.h"
#include "demos/runs/measurements.h"

#include <string>

namespace pushfactor::demos {

std::string summary_text(const Choices& choices, const Simulation& simulation, const Measurements& measured);

}  // namespace pushfactor::demos
