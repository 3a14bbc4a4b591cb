// The methods that the error report compares, scene by scene. A new solver or integrator only needs a line here.
#pragma once

#include "demos/options/named_run.h"
#include "demos/reports/error/true_errors.h"

#include <optional>
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

}  // namespace pushfactor::demos::reports::error
