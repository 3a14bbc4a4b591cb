// Siconos, if it was there when this was built.
#pragma once

#include "tests/peers/problems/problem_points.h"

namespace pushfactor::tests::problems {

bool has_siconos();

// Its solvers with smaller and smaller tolerances, and the errors that they reached; none without it.
std::vector<ProblemPoint> siconos_points(const LocalProblem& problem, bool quick);

// The impulses of the most accurate of its solvers [N s]; zero without it.
engine::VectorX best_of_siconos(const LocalProblem& problem);

}  // namespace pushfactor::tests::problems
