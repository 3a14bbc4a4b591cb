// What is said of a run: its summary, and warnings.
#pragma once

#include "demos/base/text/json.h"
#include "demos/options/choices.h"
#include "demos/runs/measurements.h"

#include <cstdint>
#include <string>

namespace pushfactor::demos {

Json summary_of(const Choices& choices, const Simulation& simulation, const Measurements& measured);

// State hash after one second of `intersecting-stack --preset paper`, from tests/hashes/lines.txt.
inline constexpr std::uint64_t touchstone = 0x7651e1c33b425dc8;

// Whether this build gives it, as others do. The first call steps that run, which takes a millisecond.
bool gives_listed_bits();

// One line for unsolved steps, one for steps whose rows contradict each other, one for energy without a source and
// stretched bars, with the option to try; empty without warnings. `name` is the name of the run.
std::string warning_text(const std::string& name, const Simulation& simulation, const Measurements& measured);

}  // namespace pushfactor::demos
