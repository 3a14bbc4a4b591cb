// Work-precision diagrams, double logarithmic: lower left is better.
#pragma once

#include "demos/pages/page.h"

#include <Eigen/Core>

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace pushfactor::demos::reports::error {

struct WorkPoint {
    double error = 0.0;  // drawn at the left border if below the axis range
    double work = 0.0;
    std::string label{};  // the value of the knob
    bool failed = false;  // drawn hollow at the right border
};

struct WorkLine {
    std::string name;
    std::string colour{};  // name in the palette
    int dash = 1;          // gnuplot's dash type
    int mark = 7;          // gnuplot's point type
    std::vector<WorkPoint> points{};
};

// The point of the least work whose error is at most `error`, and its line; null if none reaches it.
std::pair<const WorkLine*, const WorkPoint*> cheapest(std::span<const WorkLine> lines, double error);

// Colour of a method by the solver that its name begins with, the same on all plots: "pgs, cold".
std::string colour_of_solver(const std::string& method);

struct WorkPlot {
    std::string name;  // of the files
    std::string error_axis, work_axis;
    std::string machine;  // in small print below
    std::vector<WorkLine> lines{};
    std::vector<WorkLine> theory{};  // thin and grey, with their names
    bool front = true;               // mark the Pareto front; not for lines that are no alternatives
};

// Writes NAME.dat and, where gnuplot is installed, draws it as NAME.png and NAME.svg. Adds the files to the plate;
// without gnuplot its caption says what to install.
void draw_work_plot(WorkPlot plot, const std::filesystem::path& folder, SectionContent& plate);

// A section with the plot, named like it.
Section work_section(const WorkPlot& plot, const std::string& heading, const std::string& caption,
                     const std::filesystem::path& folder, SectionContent plate = {});

// Indices of the points that no other point dominates (less error or work, and no more of the other), by rising
// error; of equal points the first.
std::vector<std::size_t> pareto_front(std::span<const WorkPoint> points);

// A position in letter widths, y upwards.
using Place = Eigen::Vector2d;

struct Segment {
    Place from, to;
};

// The centre of each label next to its point, so that none covers a point or another label, and if possible no
// line; none where there is no room. Labels stay inside the area from (0, 0) to `corner`.
std::vector<std::optional<Place>> place_labels(const std::vector<Place>& points,
                                               const std::vector<std::string>& labels,
                                               const std::vector<Segment>& lines, const Place& corner);

}  // namespace pushfactor::demos::reports::error
