#include "demos/pictures/camera/layout.h"

#include <algorithm>

namespace pushfactor::demos::pictures {

renderer::Rectangle Layout::place(std::size_t index) const {
    const int column = static_cast<int>(index) % columns;
    const int row = static_cast<int>(index) / columns;
    return {static_cast<float>(column * (cell.width + gap)), static_cast<float>(row * (cell.height + gap)),
            static_cast<float>(cell.width), static_cast<float>(cell.height)};
}

Layout grid(const Size& sheet, int columns, int rows) {
    Layout layout{.columns = columns, .rows = rows, .sheet = sheet};
    if (columns * rows > 1) layout.gap = std::max(2, std::min(sheet.width, sheet.height) / 240);
    layout.cell.width = (sheet.width - layout.gap * (columns - 1)) / columns;
    layout.cell.height = (sheet.height - layout.gap * (rows - 1)) / rows;
    return layout;
}

Layout best_layout(const Size& sheet, int count, const std::function<double(const Layout&)>& scale) {
    Layout best;
    double largest = -1.0;
    for (int columns = 1; columns <= count; ++columns) {
        const Layout layout = grid(sheet, columns, (count + columns - 1) / columns);
        const double own = scale(layout);
        if (own <= largest) continue;
        largest = own;
        best = layout;
    }
    return best;
}

Layout best_layout(const Size& sheet, int count, double across, double least_up) {
    return best_layout(sheet, count, [&](const Layout& layout) {
        // Pixels per unit of tangent: limited by the height or by the width of the cell.
        return std::min(0.5 * layout.cell.height / least_up, 0.5 * layout.cell.width / across);
    });
}

renderer::Image assemble(const Layout& layout, const std::vector<renderer::Image>& pictures) {
    renderer::Image sheet = renderer::blank_image(layout.sheet.width, layout.sheet.height, glm::vec3(1.0f));
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        const renderer::Rectangle place = layout.place(i);
        renderer::paste(sheet, pictures[i], static_cast<int>(place.x), static_cast<int>(place.y));
    }
    return sheet;
}

}  // namespace pushfactor::demos::pictures
