// Contact problems and their solvers on a page: problems.csv, a plot for each, Dolan-Moré profiles over all.
#pragma once

#include "tests/peers/problems/problem_points.h"

#include <filesystem>

namespace pushfactor::tests::problems {

// Points of a solver of others.
using OtherSolver = std::vector<ProblemPoint> (*)(const LocalProblem& problem, bool quick);

// Throws OutputError, and RunError if it is interrupted.
void report_problems(const std::vector<ContactProblem>& problems, bool quick, OtherSolver other,
                     const std::filesystem::path& folder);

}  // namespace pushfactor::tests::problems
