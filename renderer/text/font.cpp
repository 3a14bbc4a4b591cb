#include "renderer/text/font.h"

#include "renderer/base/renderer_error.h"
#include "renderer/base/utf8.h"

#define STB_TRUETYPE_IMPLEMENTATION
#define STBTT_STATIC
#include <stb/stb_truetype.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <span>
#include <system_error>
#include <vector>

namespace pushfactor::renderer {
namespace {

std::vector<std::uint8_t> read_bytes(const std::filesystem::path& file) {
    std::error_code unknown;
    // A folder can be opened as well, but reading it throws another exception.
    const bool readable = std::filesystem::is_regular_file(file, unknown);
    std::ifstream stream(file, std::ios::binary);
    if (!readable || !stream) throw RendererError("cannot read the font " + file.string());
    return {std::istreambuf_iterator<char>(stream), {}};
}

// A big-endian unsigned number of `size` bytes.
std::size_t number_at(std::span<const std::uint8_t> bytes, std::size_t offset, std::size_t size) {
    std::size_t number = 0;
    for (const std::uint8_t byte : bytes.subspan(offset, size)) number = number << 8 | byte;
    return number;
}

// Whether this is a TrueType or OpenType file whose tables are all inside the file, which stb does not check.
bool has_whole_tables(std::span<const std::uint8_t> bytes) {
    constexpr std::size_t header = 12;  // bytes
    constexpr std::size_t entry = 16;   // bytes
    if (bytes.size() < header) return false;
    const std::size_t kind = number_at(bytes, 0, 4);
    if (kind != 0x00010000 && kind != 0x74727565 /* "true" */ && kind != 0x4F54544F /* "OTTO" */) return false;
    const std::size_t tables = number_at(bytes, 4, 2);
    if (bytes.size() < header + entry * tables) return false;
    for (std::size_t i = 0; i < tables; ++i) {
        const std::size_t offset = number_at(bytes, header + entry * i + 8, 4);
        const std::size_t length = number_at(bytes, header + entry * i + 12, 4);
        if (offset > bytes.size() || length > bytes.size() - offset) return false;
    }
    return true;
}

bool drawable(float size) {
    return size > 0.0f && size <= Font::max_size;
}

}  // namespace

class Font::Face {
  public:
    explicit Face(const std::filesystem::path& file) : bytes_(read_bytes(file)) {
        if (!has_whole_tables(bytes_) || stbtt_InitFont(&font_, bytes_.data(), 0) == 0) {
            throw RendererError(file.string() + " is not a TrueType font");
        }
    }
    Face(const Face&) = delete;
    Face& operator=(const Face&) = delete;

    const stbtt_fontinfo& info() const { return font_; }

    float scale(float size) const { return stbtt_ScaleForMappingEmToPixels(&font_, size); }

    // Calls `visit` with each glyph and its distance from the start of the text, px. Returns the end of the text.
    template <typename Visit>
    double lay_out(std::string_view utf8, float size, const Visit& visit) const {
        const double pixels_per_unit = scale(size);
        double end = 0.0;
        int previous = -1;
        while (!utf8.empty()) {
            const int glyph = stbtt_FindGlyphIndex(&font_, static_cast<int>(take_character(utf8)));
            if (previous >= 0) end += pixels_per_unit * stbtt_GetGlyphKernAdvance(&font_, previous, glyph);
            visit(glyph, end);
            int advance = 0;
            stbtt_GetGlyphHMetrics(&font_, glyph, &advance, nullptr);
            end += pixels_per_unit * advance;
            previous = glyph;
        }
        return end;
    }

  private:
    std::vector<std::uint8_t> bytes_;
    stbtt_fontinfo font_{};
};

namespace {

// Rasterises glyphs with stb onto an image.
class GlyphStamp {
  public:
    GlyphStamp(const stbtt_fontinfo& font, float scale, Image& image, const Ink& ink)
        : font_(font), scale_(scale), image_(image), ink_(ink) {}

    // `x` and `baseline`: position of the glyph's origin, px; the baseline is integral.
    void put(int glyph, double x, double baseline) {
        const double column = std::floor(x);
        const auto shift = static_cast<float>(x - column);
        int left = 0, top = 0, right = 0, bottom = 0;
        stbtt_GetGlyphBitmapBoxSubpixel(&font_, glyph, scale_, scale_, shift, 0.0f, &left, &top, &right, &bottom);
        if (left >= right || top >= bottom) return;  // a space
        const bool seen = column + left < image_.width && column + right > 0.0 && baseline + top < image_.height &&
                          baseline + bottom > 0.0;
        if (!seen) return;

        const int width = right - left;
        const int height = bottom - top;
        coverage_.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0);
        stbtt_MakeGlyphBitmapSubpixel(&font_, coverage_.data(), width, height, width, scale_, scale_, shift, 0.0f,
                                      glyph);
        blend(static_cast<int>(column) + left, static_cast<int>(baseline) + top, width, height);
    }

  private:
    void blend(int left, int top, int width, int height) {
        for (int y = std::max(top, 0); y < std::min(top + height, image_.height); ++y) {
            for (int x = std::max(left, 0); x < std::min(left + width, image_.width); ++x) {
                const std::uint8_t coverage = coverage_[index(x - left, y - top, width)];
                if (coverage > 0) {
                    ink_.put(&image_.rgb[3 * index(x, y, image_.width)], static_cast<float>(coverage) / 255.0f);
                }
            }
        }
    }

    static std::size_t index(int x, int y, int width) {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }

    const stbtt_fontinfo& font_;
    float scale_;  // px per unit of the font
    Image& image_;
    const Ink& ink_;
    std::vector<std::uint8_t> coverage_;  // of the glyph's pixels, 0..255
};

}  // namespace

Font::Font(const std::filesystem::path& ttf) : face_(std::make_unique<Face>(ttf)) {}

Font::~Font() = default;

float Font::width(std::string_view utf8, float size) const {
    if (!drawable(size)) return 0.0f;
    return static_cast<float>(face_->lay_out(utf8, size, [](int, double) {}));
}

std::string_view Font::lacks(std::string_view utf8) const {
    while (!utf8.empty()) {
        const std::string_view before = utf8;
        const auto character = static_cast<int>(take_character(utf8));
        if (stbtt_FindGlyphIndex(&face_->info(), character) == 0)
            return before.substr(0, before.size() - utf8.size());
    }
    return {};
}

float Font::ascent(float size) const {
    if (!drawable(size)) return 0.0f;
    int ascent = 0;
    stbtt_GetFontVMetrics(&face_->info(), &ascent, nullptr, nullptr);
    return face_->scale(size) * static_cast<float>(ascent);
}

float Font::descent(float size) const {
    if (!drawable(size)) return 0.0f;
    int descent = 0;
    stbtt_GetFontVMetrics(&face_->info(), nullptr, &descent, nullptr);
    return -face_->scale(size) * static_cast<float>(descent);
}

void Font::draw(Image& image, std::string_view utf8, glm::vec2 baseline_start, float size,
                const Paint& paint) const {
    const Ink ink(paint);
    const bool placed = std::isfinite(baseline_start.x) && std::isfinite(baseline_start.y);
    if (!drawable(size) || !placed || !ink.visible()) return;
    GlyphStamp stamp(face_->info(), face_->scale(size), image, ink);
    const double baseline = std::round(baseline_start.y);
    face_->lay_out(utf8, size, [&](int glyph, double x) { stamp.put(glyph, baseline_start.x + x, baseline); });
}

}  // namespace pushfactor::renderer
