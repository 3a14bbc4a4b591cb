// One point of a sweep: a scene by a method at one value of its knob, run once for its errors and its work and some
// times more for the clock, which measuring would disturb.
#pragma once

#include "demos/pages/table.h"
#include "demos/reports/error/experiments.h"

#include <functional>
#include <string>
#include <vector>

namespace pushfactor::demos::reports::error {

// CPU seconds of the engine steps a simulated second, of a run up to where it became non-finite. Scenes that come
// to rest cost more before, so medians of the first two seconds and of the last one stand beside the whole.
struct CpuShare {
    double min = 0.0, median = 0.0, p95 = 0.0;
    double first_two_seconds = 0.0, last_second = 0.0;
};

struct ErrorPoint {
    std::string scene, method, differences, knob, value;
    std::vector<NamedError> errors{};  // of all steps before it became non-finite
    double multiply_adds = 0.0;        // of the solver, a simulated second: the same on every machine
    double moves = 0.0;                // of all bodies, a simulated second
    CpuShare cpu{};
    std::string outcome{};  // as in a summary, or non-finite
    bool failed = false;    // it blew up or fell where an exact answer would not
};

// `check` is called often; what it throws ends the run.
ErrorPoint run_point(const Experiment& sweep, const Method& method, const std::string& value, int repeats,
                     const std::function<void()>& check);

// The smallest value that at least 95 % of all do not exceed; `values` is not empty.
double percentile_95(std::vector<double> values);

Table table_of(const std::vector<ErrorPoint>& points);  // error.csv, one line per point and error

}  // namespace pushfactor::demos::reports::error
