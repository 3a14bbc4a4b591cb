// Measures of piles, towers and walls.
#pragma once

#include "tests/peers/measures.h"

namespace pushfactor::tests::peers {

// A pile that falls: overlap and energy.
Values falling(const Scene& scene, const Run& run);

// A pile that has fallen: the last second, and the time since when no body is faster than 0.1 mm/s. Balls beside
// boxes may roll for ever and are left out of both speeds.
Values settled(const Scene& scene, const Run& run);

// A structure that should stand: displacements of bodies, energy, the last second.
Values structure(const Scene& scene, const Run& run);

// The measure of overlap that is compared with other engines.
inline constexpr const char* typical_overlap = "overlap, rms, mm";

}  // namespace pushfactor::tests::peers
