// Global problems as rows over rigid bodies, as our solvers take them, and back.
#pragma once

#include "demos/reports/error/error.h"
#include "tests/peers/problems/contact_problem.h"

#include <optional>

namespace pushfactor::tests::problems {

using demos::reports::error::FrozenProblem;

// One row per normal, and a disc for its two tangents. dt is 1 s, so that forces in N are impulses in N s. A static
// body stands for the world. Throws UsageError unless M is made of rigid bodies (one mass and a 3 x 3 inertia per
// six unknowns) and each contact acts on one or two of them.
FrozenProblem rows_over_bodies(const GlobalProblem& problem);

// The first column: the solution that moves the bodies. None for problems that FCLib has no words for: rows that
// are not contacts, or friction that is not Coulomb's with both tangents on a disc.
std::optional<GlobalProblem> global_form(const FrozenProblem& problem);

// lambda of such rows as impulses, contact by contact [N s].
engine::VectorX impulses_of(const engine::Columns& lambda);

}  // namespace pushfactor::tests::problems
