// The report on errors: the methods that it compares, scene by scene, the points of their sweeps, and the
// convergence of scenes to themselves. A new solver or integrator only needs a line in experiments.cpp.
#pragma once

#include "demos/options/named_run.h"
#include "demos/pages/table.h"
#include "demos/reports/error/true_errors.h"
#include "demos/reports/error/work_plot.h"
#include "demos/reports/study.h"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace pushfactor::demos::reports::error {

struct Method {
    std::string name;                   // in legends
    OptionTexts differs;                // options that differ from the sweep's
    std::string knob;                   // the varied option: iterations, tolerance, substeps, small-steps or dt
    std::string colour;                 // name in the palette
    int dash = 1;                       // gnuplot's dash type: 1 is solid
    int mark = 7;                       // gnuplot's point type
    double order = 0.0;                 // of the error in dt, 0 if unknown
    int moves = 1;                      // of all bodies per engine step, more than 1 for composed steps
    bool flies = false;                 // the exact solution of the method flies up, so "fly" is no failure
    std::vector<std::string> values{};  // of the knob
};

struct Experiment {
    std::string scene;   // of the catalogue or of assets/scenes
    std::string name{};  // of the part and its files: the scene's, unless that has several experiments
    std::string title{};
    OptionTexts common;  // preset and what all methods share
    MakeTrueError error;
    std::string error_axis{};
    std::string caption{};
    std::vector<Method> methods{};
    double contraction = 0.0;  // of the error per sweep of cold pgs, 0 if unknown
    std::optional<double>
        clock_seconds{};  // s, length of the timed runs, if a shorter run costs the same per second
    int timed_runs = 5;   // per point
    bool solves = true;   // false: there are no rows, and work is counted in moves
};

// The experiments. `quick`: few values and short runs.
std::vector<Experiment> error_experiments(bool quick);

// "warm-start=off slop=0": options in which a method and its sweep differ from the preset.
std::string differences(const Experiment& sweep, const Method& method);

// The options at one value of the knob, and the run.
OptionTexts options_at(const Experiment& sweep, const Method& method, const std::string& value);
Choices run_at(const Experiment& sweep, const Method& method, const std::string& value);

// cos^2(pi / 2n): contraction of the error per Gauss-Seidel sweep in a column of n equal balls on the ground.
double column_contraction(int balls);

// CPU seconds of the engine steps per simulated second, up to the last finite step. Scenes that come to rest cost
// more at first, so the medians of the first two seconds and of the last one are listed too.
struct CpuShare {
    double min = 0.0, median = 0.0, p95 = 0.0;
    double first_two_seconds = 0.0, last_second = 0.0;
};

// One point of a sweep: a scene with a method at one value of its knob, run once for errors and work, and several
// times for CPU time, which measuring would distort. Points of other engines have the same columns and measures,
// and come from tests/compare error.
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

ErrorPoint run_point(const Experiment& sweep, const Method& method, const std::string& value,
                     const StopCheck& check);

// The points of sweeps as pieces, and the point of a result.
std::string key_of(const Experiment& sweep, const Method& method, const std::string& value);
Pieces point_pieces(const std::vector<Experiment>& sweeps);
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

// Convergence of each scene to itself at smaller steps. In several windows, runs restart from states of one run
// with the smallest step, so that chaos does not grow beyond a window.
//
//   e_c(h) = sqrt( mean over windows and bodies of |x^h - x^h_min|^2 ) at the end of a window
//   order p = log2( e_c(2h) / e_c(h) )
//
// Symbols: h step [s], h_min the smallest [s], x position [m], e_c [m].
Pieces consistency_pieces(bool quick);  // a scene each

// consistency.csv and its section.
void add_consistency(StudyRun& run);

}  // namespace pushfactor::demos::reports::error
