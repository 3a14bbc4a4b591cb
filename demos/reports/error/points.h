// One point of a sweep: a scene with a method at one value of its knob, run once for errors and work, and several
// times for CPU time, which measuring would distort.
#pragma once

#include "demos/pages/table.h"
#include "demos/reports/error/experiments.h"

#include <functional>
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
    std::vector<NamedError> errors{};  // over all finite steps
    double multiply_adds = 0.0;        // of the solver per simulated second, equal on every machine
    double moves = 0.0;                // of all bodies per simulated second
    CpuShare cpu{};
    std::string outcome{};  // as in a summary, or non-finite
    bool failed = false;    // it blew up or fell, which the exact solution does not
};

// Outcomes that the exact solution does not have; to fly up is none of them for some methods.
bool means_failure(const std::string& outcome);

// `check` is called often; its exceptions end the run.
ErrorPoint run_point(const Experiment& sweep, const Method& method, const std::string& value, int repeats,
                     const std::function<void()>& check);

// The smallest value that at least 95 % of `values`, which is not empty, do not exceed.
double percentile_95(std::vector<double> values);

Table table_of(const std::vector<ErrorPoint>& points);  // error.csv, one line per point and error

}  // namespace pushfactor::demos::reports::error
