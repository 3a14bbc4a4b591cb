// Other engines beside our methods: their points have the columns of error.csv and the same measures, and come from
// tests/compare error.
#pragma once

#include "demos/reports/error/points.h"
#include "demos/reports/error/work_plot.h"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace pushfactor::demos::reports::error {

// With the columns of error.csv. Throws UsageError with the line and what it must be.
std::vector<ErrorPoint> read_error_points(const std::filesystem::path& file);

// Those about the scene and the measure that is plotted for it.
std::vector<ErrorPoint> about(const std::vector<ErrorPoint>& points, const std::string& scene,
                              const std::string& measure);

// Error against CPU time: of `ours` the methods that none of ours beats everywhere, and all others, in grey.
std::vector<WorkLine> lines_beside(std::span<const WorkLine> ours, std::span<const ErrorPoint> others);

// A line per other method: its smallest error, the CPU time for that, and the least of ours for that error or less.
TextTable who_is_faster(std::span<const WorkLine> ours, std::span<const ErrorPoint> others);

}  // namespace pushfactor::demos::reports::error
