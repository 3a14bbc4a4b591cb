// A picture with texts that stay text: a PNG has them drawn, a PDF set.
#pragma once

#include "demos/figures/printing/format.h"
#include "demos/pictures/offscreen_renderer.h"
#include "renderer/images/canvas.h"

#include <string>
#include <vector>

namespace pushfactor::demos {

struct SheetText {
    std::string text;
    glm::vec2 at{};      // beginning or centre of the base line, pixels
    float size = 16.0f;  // of the font, pixels
    bool centred = false;
};

// The image over one background.
struct SheetLayer {
    renderer::Image image{};
    glm::vec3 paper{1.0f};   // sRGB, between the pictures
    glm::vec3 behind{1.0f};  // in the pictures
};

struct Sheet {
    std::vector<SheetLayer> layers{};  // one; for transparency one over dark and one over light
    std::vector<SheetText> texts{};

    static Sheet blank(int width, int height, const FigureFormat& format);

    int width() const { return layers.front().image.width; }
    int height() const { return layers.front().image.height; }

    // Draws the picture into each layer with its upper left pixel at (x, y); without ground for transparency.
    void paste(pictures::OffscreenRenderer& offscreen, renderer::Picture picture, const pictures::Size& size,
               int samples, int x, int y);
};

// The PNG of the image, with or without its texts.
std::vector<std::uint8_t> png_of(const Sheet& sheet, double dots_per_inch);
std::vector<std::uint8_t> png_of(Sheet sheet, const pictures::Lettering& lettering, const FigureFormat& format);

}  // namespace pushfactor::demos
