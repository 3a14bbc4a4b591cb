#include "renderer/text/font.h"

#include "renderer/base/renderer_error.h"
#include "renderer/images/canvas.h"
#include "tests/catch.h"
#include "tests/renderer/sample_pictures.h"

#include <fstream>
#include <iterator>
#include <limits>
#include <string>

using namespace pushfactor::renderer;
using Catch::Contains;

namespace {

constexpr int width = 400;      // of the images, px
constexpr int height = 60;      // px
constexpr float start = 20.0f;  // of the text, px
constexpr float line = 40.0f;   // its baseline, px

const Font& sans() {
    static const Font font(PUSHFACTOR_FONT);
    return font;
}

Image written(std::string_view text, float size, glm::vec2 at = {start, line}, const Paint& paint = {}) {
    Image image = blank_image(width, height, glm::vec3(1.0f));
    sans().draw(image, text, at, size, paint);
    return image;
}

// The pixels that are not white, and how black they are in sum (in pixels).
struct Extent {
    float left = width;  // edges between pixels, px
    float right = 0.0f;
    float top = height;
    float bottom = 0.0f;
    double sum = 0.0;
    double middle = 0.0;  // of the ink, from the left
};
Extent ink_of(const Image& image) {
    Extent ink;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const int missing = 765 - brightness(image, x, y);
            if (missing == 0) continue;
            ink.left = std::min(ink.left, static_cast<float>(x));
            ink.right = std::max(ink.right, static_cast<float>(x + 1));
            ink.top = std::min(ink.top, static_cast<float>(y));
            ink.bottom = std::max(ink.bottom, static_cast<float>(y + 1));
            ink.sum += missing / 765.0;
            ink.middle += x * (missing / 765.0);
        }
    }
    ink.middle /= ink.sum;
    return ink;
}

}  // namespace

TEST_CASE("Text lies between its start and its width, and between ascent and descent", "[font]") {
    for (const float size : {9.0f, 13.5f, 16.0f, 40.0f}) {
        for (const std::string text : {"Hg|", "penetration", "kg·m/s²", "25 °C – β → ∞"}) {
            INFO(text << " at " << size);
            const Extent ink = ink_of(written(text, size));
            CHECK(ink.sum > 0.5);
            CHECK(ink.left >= start - 1.0f);
            CHECK(ink.right <= start + sans().width(text, size) + 1.0f);
            CHECK(ink.right >= start + 0.8f * sans().width(text, size));
            CHECK(ink.top >= line - sans().ascent(size) - 1.0f);
            CHECK(ink.bottom <= line + sans().descent(size) + 1.0f);
        }
    }
    const Extent capital = ink_of(written("H", 40.0f));
    CHECK(capital.bottom == line);  // it stands on the baseline
    CHECK(capital.bottom - capital.top == Approx(0.73f * 40.0f).margin(1.0));
    CHECK(ink_of(written("g", 40.0f)).bottom > line + 5.0f);
}

TEST_CASE("Widths add up, but for kerning, and grow with the size", "[font]") {
    const auto width_of = [](std::string_view text) { return sans().width(text, 20.0f); };
    CHECK(width_of("") == 0.0f);
    CHECK(width_of("0") == Approx(0.636f * 20.0f).epsilon(0.01));
    CHECK(width_of("0000") == Approx(4.0f * width_of("0")));
    CHECK(width_of("AA") == Approx(2.0f * width_of("A")).epsilon(0.05));
    CHECK(width_of("AV") < width_of("A") + width_of("V") - 0.5f);
    CHECK(width_of("1") == width_of("7"));  // digits stand in columns
    CHECK(sans().width("Push", 40.0f) == Approx(2.0f * sans().width("Push", 20.0f)));
    CHECK(sans().ascent(20.0f) > 14.0f);
    CHECK(sans().ascent(20.0f) < 24.0f);
    CHECK(sans().descent(20.0f) > 3.0f);
    CHECK(sans().descent(20.0f) < 8.0f);
}

TEST_CASE("Text continues where its width ends", "[font]") {
    const float size = 16.0f;
    Image parts = written("speed ", size);
    sans().draw(parts, "3 m/s", {start + sans().width("speed ", size), line}, size, {});
    CHECK(largest_difference(parts, written("speed 3 m/s", size)) <= 2);
}

TEST_CASE("Letters stand at fractions of a pixel and keep their ink", "[font]") {
    const Image first = written("m", 14.0f);
    for (const float shift : {0.25f, 0.5f, 0.75f, 3.4f}) {
        const Extent shifted = ink_of(written("m", 14.0f, {start + shift, line}));
        CHECK(shifted.sum == Approx(ink_of(first).sum).epsilon(0.02));
        CHECK(shifted.middle == Approx(ink_of(first).middle + shift).margin(0.06));
    }
    // The baseline is always between two pixels.
    CHECK(written("m", 14.0f, {start, line + 0.3f}) == first);
}

TEST_CASE("The signs of the reports are in the font, and differ from its sign for what is missing", "[font]") {
    const Image missing = written("\xEE\x80\x80", 30.0f);  // U+E000, private use
    CHECK(ink_of(missing).sum > 5.0);
    for (const std::string sign : {"β", "·", "²", "°", "–", "→", "µ", "×", "≤", "\xEF\xBF\xBD"}) {
        INFO(sign);
        CHECK(ink_of(written(sign, 30.0f)).sum > 2.0);
        CHECK(written(sign, 30.0f) != missing);
    }
}

TEST_CASE("Text that is not UTF-8 is drawn with signs of replacement", "[font]") {
    CHECK(written("a\xFF\xE2\x82z", 20.0f) == written("a\xEF\xBF\xBD\xEF\xBF\xBDz", 20.0f));
    std::string every_byte;
    for (int byte = 0; byte < 256; ++byte) every_byte += static_cast<char>(byte);
    CHECK(ink_of(written(every_byte, 8.0f)).sum > 10.0);
}

TEST_CASE("Text has its paint", "[font]") {
    const Image solid = written("I", 60.0f, {start, line}, {.colour = red});
    const Image faint = written("I", 60.0f, {start, line}, {.opacity = 0.4f});
    int darkest = 255;
    bool found_red = false;
    for (int x = 0; x < width; ++x) {
        found_red = found_red || is_red(solid.pixel(x, 20));
        darkest = std::min<int>(darkest, faint.pixel(x, 20)[0]);
    }
    CHECK(found_red);
    CHECK(darkest == 153);
}

TEST_CASE("Text over an edge is what a larger image shows there", "[font]") {
    const Image whole = written("Pushfactor", 30.0f);
    Image part = blank_image(50, 20, glm::vec3(1.0f));
    sans().draw(part, "Pushfactor", {start - 33.0f, line - 25.0f}, 30.0f, {});
    Image expected = blank_image(50, 20, glm::vec3(1.0f));
    paste(expected, whole, -33, -25);
    CHECK(part == expected);
    CHECK(ink_of(part).sum > 20.0);
}

TEST_CASE("Text without a place or a sensible size draws nothing", "[font]") {
    const Image empty = blank_image(width, height, glm::vec3(1.0f));
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float huge = std::numeric_limits<float>::max();
    for (const float size : {0.0f, -5.0f, nan, Font::max_size * 1.1f, std::numeric_limits<float>::infinity()}) {
        CHECK(written("text", size) == empty);
        CHECK(sans().width("text", size) == 0.0f);
        CHECK(sans().ascent(size) == 0.0f);
        CHECK(sans().descent(size) == 0.0f);
    }
    for (const float place : {nan, huge, -huge, std::numeric_limits<float>::infinity()}) {
        CHECK(written("text", 20.0f, {place, line}) == empty);
        CHECK(written("text", 20.0f, {start, place}) == empty);
    }
    CHECK(written("text", 20.0f, {start, line}, {.opacity = nan}) == empty);
    CHECK(ink_of(written("text", Font::max_size)).sum > 0.0);
}

TEST_CASE("A file that is no font is named", "[font]") {
    namespace fs = std::filesystem;
    CHECK_THROWS_AS(Font("no/such/font.ttf"), RendererError);
    CHECK_THROWS_WITH(Font("no/such/font.ttf"), Contains("cannot read") && Contains("no/such/font.ttf"));
    CHECK_THROWS_WITH(Font(fs::temp_directory_path()), Contains(fs::temp_directory_path().string()));

    std::ifstream stream(PUSHFACTOR_FONT, std::ios::binary);
    const std::string whole(std::istreambuf_iterator<char>(stream), {});
    const fs::path file = fs::temp_directory_path() / "pushfactor_no_font.ttf";
    for (const std::string& bytes :
         {std::string(), std::string("x"), std::string("This is a letter, not letters."), whole.substr(0, 12),
          whole.substr(0, 400), whole.substr(0, whole.size() / 2), std::string(1000, '\0')}) {
        std::ofstream(file, std::ios::binary) << bytes;
        CHECK_THROWS_WITH(Font(file), Contains("pushfactor_no_font.ttf"));
    }
    std::ofstream(file, std::ios::binary) << whole;
    CHECK_NOTHROW(Font(file));
    fs::remove(file);
}
