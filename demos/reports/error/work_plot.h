// Work-precision diagrams, double logarithmic: lower left is better.
#pragma once

#include "demos/pages/page.h"

#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace pushfactor::demos::reports::error {

struct WorkPoint {
    double error = 0.0;  // drawn at the left border if below the axis range
    double work = 0.0;
    std::string label;    // the value of the knob
    bool failed = false;  // drawn hollow at the right border
};

struct WorkLine {
    std::string name;
    std::string colour;  // name in the palette
    int dash = 1;        // gnuplot's dash type
    int mark = 7;        // gnuplot's point type
    std::vector<WorkPoint> points;
};

// The point of the least work whose error is at most `error`, and its line; null if none reaches it.
struct Cheapest {
    const WorkLine* line = nullptr;
    const WorkPoint* point = nullptr;
};
Cheapest cheapest(std::span<const WorkLine> lines, double error);

// Colour of a method by the solver that its name begins with, the same on all plots: "pgs, cold".
std::string colour_of_solver(const std::string& method);

// Theory: a thin grey line.
struct TheoryLine {
    std::string label;
    std::vector<std::pair<double, double>> points;  // error, work
};

struct WorkPlot {
    std::string name;  // of the files
    std::string error_axis, work_axis;
    std::string machine;  // in small print below
    std::vector<WorkLine> lines;
    std::vector<TheoryLine> theory;
    bool front = true;  // mark the Pareto front; not for lines that are no alternatives
};

// Writes NAME.dat and, where gnuplot is installed, draws it as NAME.png and NAME.svg. Adds the files to the plate;
// without gnuplot its caption says what to install.
void draw_work_plot(const WorkPlot& plot, const std::filesystem::path& folder, SectionContent& plate);

}  // namespace pushfactor::demos::reports::error
