#pragma once

#include "renderer/images/image.h"
#include "renderer/images/paint.h"

#include <glm/vec2.hpp>

#include <filesystem>
#include <memory>
#include <string_view>

namespace pushfactor::renderer {

// A TrueType font. Text is one line of UTF-8, from left to right, with kerning. Invalid UTF-8 is drawn as U+FFFD,
// and characters that the font lacks as the font's replacement glyph.
//
// `size` is that of the em square in pixels, up to `max_size`; text of other sizes has width 0 and draws nothing.
// All lengths in pixels. Thread-safe.
class Font {
  public:
    static constexpr float max_size = 1000.0f;

    // Throws RendererError with the name of the file if it cannot be read or is not a font. The contents of its
    // tables are trusted.
    explicit Font(const std::filesystem::path& ttf);
    ~Font();

    // Advance of the text: from its start to where following text would start.
    float width(std::string_view utf8, float size) const;

    // The first character of the text that the font lacks; empty if it has all.
    std::string_view lacks(std::string_view utf8) const;

    // Extent of letters above and below the baseline, both positive.
    float ascent(float size) const;
    float descent(float size) const;

    // Draws text from `baseline_start` on. Letters have subpixel positions, for even spacing, but the baseline is
    // rounded to a pixel boundary, so that all lines are equally crisp.
    void draw(Image& image, std::string_view utf8, glm::vec2 baseline_start, float size, const Paint& paint) const;

  private:
    class Face;

    std::unique_ptr<const Face> face_;
};

}  // namespace pushfactor::renderer
