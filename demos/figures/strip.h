// Runs as rows and moments as columns of one picture.
#pragma once

#include "demos/figures/figure.h"
#include "demos/options/overlay_choice.h"
#include "demos/pages/figure_output.h"
#include "demos/runs/simulation.h"

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

struct Strip {
    std::vector<Choices> runs{};
    std::vector<Cell> cells{};          // in the order in which they are shown; of one run in the order of time
    std::vector<std::string> titles{};  // of the rows of the picture, in a margin on the left; lines end with \n
    int columns = 1;
    double cell_aspect = 1.0;    // width over height
    bool fit = true;             // one camera that shows all that moves in all cells; else the scene's own
    std::optional<View> view{};  // from where, instead of the scene's own
    std::optional<OverlayItem> overlay{};  // with its scale
    // Is shown every cell's run at its moment, for the numbers of the caption.
    std::function<void(const Cell& cell, const Simulation& run)> look{};
};

renderer::Image draw_strip(FigureOutput& output, const Strip& strip);

// The same as a figure's picture.
Plate draw_plate(FigureOutput& output, const Figure& figure, const Strip& strip);

}  // namespace pushfactor::demos::figures
