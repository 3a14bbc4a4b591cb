#pragma once

#include "renderer/images/image.h"
#include "renderer/images/paint.h"

#include <glm/vec2.hpp>

#include <filesystem>
#include <memory>
#include <string_view>

namespace pushfactor::renderer {

// The letters of a TrueType file. Text is one line of UTF-8, from left to right, with kerning. What is not UTF-8 is
// drawn as U+FFFD, and a character that the font lacks as the font's own sign for that.
//
// `size` is that of the em square in pixels, up to `max_size`; text of other sizes is 0 wide and draws nothing. All
// lengths are pixels. May be used from several threads.
class Font {
  public:
    static constexpr float max_size = 1000.0f;

    // Throws RendererError that names the file when it cannot be read or is not a font. What lies inside of a
    // font's tables is trusted.
    explicit Font(const std::filesystem::path& ttf);
    ~Font();

    // From the start of the text to where more text would start.
    float width(std::string_view utf8, float size) const;

    // How far letters reach above the baseline, and below it: both positive.
    float ascent(float size) const;
    float descent(float size) const;

    // Draws text from `baseline_start` on. Letters stand at fractions of a pixel, so that their spacing is even,
    // but the baseline is moved to the nearest edge between pixels, so that all lines are equally crisp.
    void draw(Image& image, std::string_view utf8, glm::vec2 baseline_start, float size, const Paint& paint) const;

  private:
    class Face;

    std::unique_ptr<const Face> face_;
};

}  // namespace pushfactor::renderer
