// Convergence of each scene to itself at smaller steps. In several windows, runs restart from states of one run
// with the smallest step, so that chaos does not grow beyond a window.
//
//   e_c(h) = sqrt( mean over windows and bodies of |x^h - x^h_min|^2 ) at the end of a window
//   order p = log2( e_c(2h) / e_c(h) )
//
// Symbols: h step [s], h_min the smallest [s], x position [m], e_c [m].
#pragma once

#include "demos/options/named_run.h"
#include "demos/text/rational.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace pushfactor::demos::reports::error {

struct ConsistencyCase {
    std::string scene;
    OptionTexts options;
    std::string colour;  // in the plot
};

struct ConsistencyPlan {
    std::vector<ConsistencyCase> cases;
    std::vector<Rational> steps;   // s, each half of the one before
    Rational smallest;             // s
    std::vector<Rational> starts;  // s, of the windows, whole numbers of the smallest step
    Rational window;               // s, length of each
};

ConsistencyPlan consistency_plan(bool quick);

struct ConsistencyPoint {
    double dt = 0.0;                // s
    double error = 0.0;             // m
    double size = 0.0;              // m, of a movable body
    std::optional<double> order{};  // against twice the step; not for the first
};

std::vector<ConsistencyPoint> check_consistency(const ConsistencyPlan& plan, const ConsistencyCase& which,
                                                const std::function<void()>& check);

}  // namespace pushfactor::demos::reports::error
