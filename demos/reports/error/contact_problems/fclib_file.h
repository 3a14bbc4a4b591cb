// Files of FCLib (HDF5), if its library was there when the program was built.
#pragma once

#include "demos/reports/error/contact_problems/contact_problem.h"

#include <filesystem>
#include <optional>
#include <variant>

namespace pushfactor::demos::reports::error {

bool has_fclib();

using ContactProblem = std::variant<GlobalProblem, LocalProblem>;

// Throws UsageError, one line: for what is not a three-dimensional problem of FCLib without equations (G, V, R), or
// for sizes that do not fit; or that names the packages to build with.
ContactProblem read_fclib(const std::filesystem::path& file);

// Replaces the file; read back the problem has the same numbers. Throws OutputError, or UsageError without FCLib.
void write_fclib(const GlobalProblem& problem, const std::filesystem::path& file);
// The same with a solution: these impulses [N s], and the velocities that follow from them.
void write_fclib(const GlobalProblem& problem, const engine::VectorX& impulses, const std::filesystem::path& file);
void write_fclib(const LocalProblem& problem, const std::filesystem::path& file);

// The impulses of a file's solution; none if it has no solution.
std::optional<engine::VectorX> read_solution(const std::filesystem::path& file);

}  // namespace pushfactor::demos::reports::error
