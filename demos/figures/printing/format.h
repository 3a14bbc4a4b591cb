// How figures are made: on a screen, or for print.
#pragma once

#include <cmath>
#include <optional>

namespace pushfactor::demos {

// On paper: figures are not scaled there, so their letters have the size that is asked for.
struct Print {
    double width_mm = 85.0;
    int dpi = 300;
    double letters_pt = 8.0;  // size of the font, in points of 1/72 inch

    double inches() const { return width_mm / 25.4; }
    int pixels() const { return static_cast<int>(std::lround(inches() * dpi)); }
    double letter_pixels() const { return letters_pt / 72.0 * dpi; }
};

enum class Theme { light, dark };
enum class Background { plain, none };

struct FigureFormat {
    int width = 1600;                           // pixels
    int samples = 32;                           // renderings averaged per picture
    std::optional<Print> print{};               // then width is its pixels
    Theme theme = Theme::light;                 // dark: for talks
    Background background = Background::plain;  // none: transparent
};

}  // namespace pushfactor::demos
