// Files of FCLib (HDF5).
#pragma once

#include "tests/peers/problems/contact_problem.h"

#include <filesystem>

namespace pushfactor::tests::problems {

// Throws UsageError, one line, for what is not a three-dimensional problem of FCLib without equations (G, V, R), or
// for sizes that do not fit.
ContactProblem read_fclib(const std::filesystem::path& file);

// Replaces the file; read back the problem has the same numbers. Throws OutputError.
void write_fclib(const LocalProblem& problem, const std::filesystem::path& file);
// The same with a solution, unless it is empty: these impulses [N s], and the velocities that follow from them.
void write_fclib(const GlobalProblem& problem, const engine::VectorX& impulses, const std::filesystem::path& file);

}  // namespace pushfactor::tests::problems
