// Several pictures on one sheet.
#pragma once

#include "demos/pictures/studio.h"

#include <vector>

namespace pushfactor::demos::pictures {

// Equal cells in rows, with a white line between them.
struct Layout {
    int columns = 1, rows = 1;
    Size sheet{}, cell{};  // pixels
    int gap = 0;           // pixels between cells

    renderer::Rectangle place(std::size_t index) const;  // of a cell, row by row; pixels
};

Layout grid(const Size& sheet, int columns, int rows);

// The grid of `count` cells in which something `across` wide and `up` high (half, as tangents) is seen largest when
// a cell of any shape shows at least `least_up` of height.
Layout best_layout(const Size& sheet, int count, double across, double least_up);

// The pictures in their cells; a sheet without a gap when there is only one.
renderer::Image assemble(const Layout& layout, const std::vector<renderer::Image>& pictures);

}  // namespace pushfactor::demos::pictures
