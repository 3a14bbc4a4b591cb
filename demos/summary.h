// The summary of a run as JSON text.
#pragma once

#include "demos/choices.h"
#include "demos/measurements.h"

#include <string>

namespace pushfactor::demos {

std::string summary_text(const Choices& choices, const Simulation& simulation, const Measurements& measured);

}  // namespace pushfactor::demos
