// Text on pictures: captions, panel names, legends.
#pragma once

#include "demos/base/text/palette.h"
#include "demos/options/choices.h"
#include "renderer/images/canvas.h"
#include "renderer/text/font.h"

#include <string>
#include <vector>

namespace pushfactor::demos::pictures {

// One line of a legend: an arrow of this length, or a dot when it is zero.
struct LegendLine {
    Colour colour;
    std::string text;
    float arrow = 0.0f;  // pixels
};

class Lettering {
  public:
    // Throws renderer::RendererError when the font cannot be read.
    Lettering();

    static std::string font_file();

    // Text on a light plate in a corner of the rectangle [pixels]: its name at the top left, a caption at the
    // bottom left, a legend at the bottom right. `size` is the font size in pixels. Text that is too long is cut:
    // a caption ends in "…", a name begins with it, because panels differ in the ends of their names. A legend
    // returns the width that it takes.
    void name(renderer::Image& image, const renderer::Rectangle& in, const std::string& text, float size) const;
    void caption(renderer::Image& image, const renderer::Rectangle& in, const std::string& text, float size) const;
    float legend(renderer::Image& image, const renderer::Rectangle& in, const std::vector<LegendLine>& lines,
                 float size) const;

    static constexpr glm::vec3 ink_colour{0.13f, 0.14f, 0.17f};  // sRGB

    // Plain text whose baseline begins at `at`; centred there when `centred`.
    void text(renderer::Image& image, const std::string& text, glm::vec2 at, float size, bool centred = false,
              const glm::vec3& colour = ink_colour) const;
    std::string_view lacks(std::string_view text) const { return font_.lacks(text); }
    float width(const std::string& text, float size) const { return font_.width(text, size); }

  private:
    std::string cut(const std::string& text, float size, float width, bool keep_end) const;
    void plate(renderer::Image& image, const renderer::Rectangle& in, const std::string& text, float size,
               bool below) const;

    renderer::Font font_;
};

// Readable font size for a picture of this height [pixels].
float letter_size(int height);

// Height that so many lines of a legend take, or a caption, which is one line.
float legend_height(std::size_t lines, float size);

// The scene, the preset, and every option that differs from it: "stack   preset paper   beta 0.4". The compared
// option is left out: it is in the panels' labels.
std::string caption_of(const Choices& choices);

}  // namespace pushfactor::demos::pictures
