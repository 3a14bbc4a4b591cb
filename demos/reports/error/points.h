// One point of a sweep: a scene with a method at one value of its knob, run once for errors and work, and several
// times for CPU time, which measuring would distort. Points of other engines have the same columns and measures,
// and come from tests/compare error.
#pragma once

#include "demos/pages/table.h"
#include "demos/reports/error/experiments.h"
#include "demos/reports/error/work_plot.h"
#include "demos/reports/pieces.h"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace pushfactor::demos::reports::error {

// CPU seconds of the engine steps per simulated second, up to the last finite step. Scenes that come to rest cost
// more at first, so the medians of the first two seconds and of the last one are listed too.
struct CpuShare {
    double min = 0.0, median = 0.0, p95 = 0.0;
    double first_two_seconds = 0.0, last_second = 0.0;
};

struct ErrorPoint {
    std::string scene, method, differences, knob, value;
    std::vector<NamedError> errors{};  // over all finite steps, the plotted one first
    double multiply_adds = 0.0;        // of the solver per simulated second, equal on every machine
    CpuShare cpu{};
    std::string outcome{};  // as in a summary, or non-finite
    bool failed = false;    // it blew up or fell, which the exact solution does not

    double error() const { return errors.front().value; }
};

// Outcomes that the exact solution does not have; to fly up is none of them for some methods.
bool means_failure(const std::string& outcome);

ErrorPoint run_point(const Experiment& sweep, const Method& method, const std::string& value, int repeats,
                     const StopCheck& check);

// The points of sweeps as pieces, and the point of a result.
std::string key_of(const Experiment& sweep, const Method& method, const std::string& value);
Pieces point_pieces(std::vector<Experiment> sweeps);
ErrorPoint point_in(const Json& result, const Method& method);

// The smallest value that at least 95 % of `values`, which is not empty, do not exceed.
double percentile_95(std::vector<double> values);

Table table_of(const std::vector<ErrorPoint>& points);  // error.csv, one line per point and error

// Points of other engines, with the columns of error.csv. Throws UsageError with the line and what it must be.
std::vector<ErrorPoint> read_error_points(const std::filesystem::path& file);

// Those about the scene and the measure that is plotted for it.
std::vector<ErrorPoint> about(std::vector<ErrorPoint> points, const std::string& scene, const std::string& measure);

// Error against CPU time: of `ours` the methods that none of ours beats everywhere, and all others, in grey.
std::vector<WorkLine> lines_beside(std::span<const WorkLine> ours, std::span<const ErrorPoint> others);

// A line per other method: its smallest error, the CPU time for that, and the least of ours for that error or less.
TextTable who_is_faster(std::span<const WorkLine> ours, std::span<const ErrorPoint> others);

}  // namespace pushfactor::demos::reports::error
