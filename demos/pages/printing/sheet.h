// A picture with texts that stay text: a PNG has them drawn, a PDF set.
#pragma once

#include "demos/pages/printing/format.h"
#include "demos/pictures/lettering.h"
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

struct Sheet {
    renderer::Image image{};
    std::vector<SheetText> texts{};

    // Of one colour, that of the theme's paper.
    static Sheet blank(int width, int height, Theme theme);
};

// The image with its texts.
renderer::Image drawn(const Sheet& sheet, const pictures::Lettering& lettering, Theme theme);

// `text` in lines that are at most `width` [pixels] wide, broken between words.
std::vector<std::string> wrapped(const std::string& text, float size, float width,
                                 const pictures::Lettering& lettering);

}  // namespace pushfactor::demos
