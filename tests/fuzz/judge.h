// The claims that must hold in every scene, however wild.
//
//   finite            all numbers of the state, or the run ends with NonFiniteError (exit 5)
//   bounds            every force lies within its bounds, up to the tolerance
//   linear momentum   of an isolated system is constant, to rounding
//   angular momentum  of such a system too; a correction for a single frame moves bodies without their momenta, so
//                     that in its steps it changes by sum dx_corr x p. Not claimed of steps with a swept contact,
//                     whose impulse J acts at the positions x of the impact, not at those x' of the end of the
//                     step: the balance lacks (x' - x) x J
//   energy            the forces of the rows add no kinetic energy beyond the work of the lasting push factors
//
// Energy in one step (6.2.9, both sides with the inertia of its beginning): with p = p1 + dt f_ext the momenta
// without rows and p2 those with rows,
//
//   T(p2) - T(p) - dt lambda . v = dt^2 q(lambda),   q(lambda) = 1/2 lambda^T A lambda - b^T lambda,
//
// and T(p) - T(p1) is the work of f_ext at the velocity in the middle of the step. So the left side, taken from the
// momenta, says how good the solution is: no force gives q = 0, so a solution has q <= 0, and a truncated sweep has
// at most the q of the cached forces from which it started.
#pragma once

#include "demos/scenes/scene_description.h"

#include <optional>
#include <string>

namespace pushfactor::tests {

struct Verdict {
    enum class Kind { holds, non_finite, fails };

    Kind kind = Kind::holds;
    std::string claim;  // which one fails: "finite", "bounds", ..., or "accepted" when the scene is refused
    std::string what;   // in numbers
    long step = 0;      // of the run
};

// Runs the scene with its own options and duration. Catches what the engine throws.
Verdict judge(const demos::SceneDescription& scene);

}  // namespace pushfactor::tests
