// Frozen problems as `pushfactor report error --export` writes them (demos/FORMATS.md).
#pragma once

#include "demos/reports/error/error.h"

#include <filesystem>

namespace pushfactor::tests::problems {

// Throws UsageError that names the file, the place in it, the value and what is allowed.
demos::reports::error::FrozenProblem read_frozen(const std::filesystem::path& file);

}  // namespace pushfactor::tests::problems
