// Layout of several pictures on one sheet.
#pragma once

#include "demos/pictures/offscreen_renderer.h"

#include <functional>
#include <vector>

namespace pushfactor::demos::pictures {

// Equal cells in rows, with a white line between them.
struct Layout {
    int columns = 1, rows = 1;
    Size sheet{}, cell{};  // pixels
    int gap = 0;           // pixels between cells

    double cell_aspect() const { return static_cast<double>(cell.width) / cell.height; }
    renderer::Rectangle place(std::size_t index) const;  // of a cell, numbered row by row; pixels
};

Layout grid(const Size& sheet, int columns, int rows);

// The grid of `count` cells with the largest `scale`.
Layout best_layout(const Size& sheet, int count, const std::function<double(const Layout&)>& scale);

// The grid of `count` cells that shows content of half width `across` (as a tangent) largest, while each cell shows
// at least half height `least_up`.
Layout best_layout(const Size& sheet, int count, double across, double least_up);

// The pictures pasted into their cells.
renderer::Image assemble(const Layout& layout, const std::vector<renderer::Image>& pictures);

}  // namespace pushfactor::demos::pictures
