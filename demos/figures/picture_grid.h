// A picture with runs as rows and times as columns.
#pragma once

#include "demos/figures/figure_output.h"
#include "demos/options/look_choices.h"
#include "demos/runs/session.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace pushfactor::demos::figures {

struct Cell {
    std::size_t row = 0;
    Rational time;      // s, a whole number of steps
    std::string label;  // "t = 0.5 s"
};

struct PictureGrid {
    std::vector<Choices> runs{};
    std::vector<Cell> cells{};          // in display order; those of one run by time
    std::vector<std::string> titles{};  // of the rows, in a margin on the left; \n separates lines
    int columns = 1;
    double cell_aspect = 1.0;              // width over height
    bool fit = true;                       // one camera that frames all motion in all cells; else the scene's own
    std::optional<OverlayItem> overlay{};  // with its scale
    // Called with the run at the time of each cell, for the numbers in the caption.
    std::function<void(const Cell& cell, const Simulation& run)> look{};
};

// The grid as the picture of a figure, and a replay of its runs.
SectionContent draw_figure(FigureOutput& output, const Figure& figure, const PictureGrid& grid);

}  // namespace pushfactor::demos::figures
