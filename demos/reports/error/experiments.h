// Which methods the error report compares, scene by scene: the one place where they are listed. A method whose
// options this build does not know is left out, so a new solver or integrator needs no more than its line here.
#pragma once

#include "demos/options/named_run.h"
#include "demos/reports/error/true_errors.h"

#include <optional>
#include <string>
#include <vector>

namespace pushfactor::demos::reports::error {

struct Method {
    std::string name;     // in legends
    OptionTexts differs;  // from the preset of the sweep
    std::string knob;     // the option that is swept: iterations, tolerance, substeps, small-steps or dt
    std::string colour;   // name in the palette
    int dash = 1;         // gnuplot's dash type: 1 is solid
    int mark = 7;         // gnuplot's point type
    double order = 0.0;   // of the error in dt, 0 where nothing is known
    int moves = 1;        // of all bodies in an engine step: more where steps are composed
    bool flies = false;   // the exact answer of the method flies up, so that is no failure
    std::vector<std::string> values{};  // of the knob
};

struct Experiment {
    std::string scene;  // of the catalogue or of assets/scenes
    std::string title{};
    OptionTexts common;  // preset and what all methods share
    MakeTrueError error;
    std::string error_axis{};
    std::string caption{};
    std::vector<Method> methods{};
    double contraction = 0.0;  // of the error by a sweep of cold pgs, 0 where nothing is known
    std::optional<double>
        clock_seconds{};  // s, of the runs for the clock, where a shorter one costs the same a second
    bool solves = true;   // else there are no rows, and the moves are the work
};

// Only methods that this build has. `quick` takes few values and short runs.
std::vector<Experiment> error_experiments(bool quick);

// Whether all options of the method are known and allowed.
bool available(const Method& method);

// "warm-start=off slop=0": what a method and its sweep change of the preset.
std::string differences(const Experiment& sweep, const Method& method);

// The run at one value of the knob.
Choices run_at(const Experiment& sweep, const Method& method, const std::string& value);

// cos^2(pi / 2n): what a Gauss-Seidel sweep leaves of the error in a column of n equal balls on the ground.
double column_contraction(int balls);

}  // namespace pushfactor::demos::reports::error
