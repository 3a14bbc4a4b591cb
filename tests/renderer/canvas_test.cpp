#include "renderer/images/canvas.h"

#include "renderer/base/renderer_error.h"
#include "tests/catch.h"
#include "tests/renderer/sample_pictures.h"

#include <cstdint>
#include <limits>
#include <numbers>

using namespace pushfactor::renderer;

namespace {

const glm::vec3 white(1.0f);
const Paint black{};
constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();
constexpr float infinite = std::numeric_limits<float>::infinity();

// The black coverage of a pixel in a white image, 0..1.
double cover(const Image& image, int x, int y) {
    return (765.0 - brightness(image, x, y)) / 765.0;
}

double area(const Image& image) {
    double sum = 0.0;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) sum += cover(image, x, y);
    }
    return sum;
}

Image cropped(const Image& image, int left, int top, int width, int height) {
    Image part = blank_image(width, height, white);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const Pixel pixel = image.pixel(left + x, top + y);
            std::copy(pixel.begin(), pixel.end(), &part.rgb[static_cast<std::size_t>(3 * (y * width + x))]);
        }
    }
    return part;
}

// One of everything, moved by `by`.
void draw_all(Image& image, const glm::vec2& by) {
    const Paint paint{.colour = red, .opacity = 0.7f};
    fill(image, {by.x + 3.25f, by.y - 4.5f, 20.5f, 11.0f}, paint);
    fill(image, {by.x - 6.0f, by.y + 20.25f, 12.0f, 30.0f}, paint, 4.0f);
    draw_frame(image, {by.x + 25.5f, by.y + 25.5f, 20.0f, 20.0f}, 2.5f, paint);
    draw_line(image, by + glm::vec2(-10.0f, 8.0f), by + glm::vec2(60.0f, 31.0f), 3.0f, paint);
    draw_arrow(image, by + glm::vec2(20.0f, 20.0f), by + glm::vec2(41.0f, 2.0f), 3.0f, paint);
    draw_dot(image, by + glm::vec2(39.0f, 20.5f), 6.25f, paint);
}

}  // namespace

TEST_CASE("A blank image is of its colour, and not empty", "[canvas]") {
    const Image image = blank_image(3, 2, {1.0f, 0.5f, 0.0f});
    CHECK(image == Image{3, 2, {255, 128, 0, 255, 128, 0, 255, 128, 0, 255, 128, 0, 255, 128, 0, 255, 128, 0}});
    CHECK_THROWS_AS(blank_image(0, 2, white), RendererError);
    CHECK_THROWS_AS(blank_image(2, -1, white), RendererError);
}

TEST_CASE("A dot covers the area of a disc", "[canvas]") {
    for (const float radius : {4.0f, 7.3f, 18.0f}) {
        Image image = blank_image(50, 50, white);
        draw_dot(image, {24.7f, 25.1f}, radius, black);
        CHECK(area(image) == Approx(std::numbers::pi * radius * radius).epsilon(0.01));
        CHECK(image.pixel(24, 25) == Pixel{0, 0, 0});
    }
}

TEST_CASE("A rectangle covers exactly its area, also where it is narrower than a pixel", "[canvas]") {
    for (const Rectangle& rectangle : {Rectangle{3.0f, 4.0f, 10.0f, 5.0f}, Rectangle{3.3f, 4.6f, 10.5f, 5.2f},
                                       Rectangle{3.9f, 2.0f, 0.4f, 20.0f}, Rectangle{5.4f, 6.4f, 0.2f, 0.2f}}) {
        Image image = blank_image(30, 30, white);
        fill(image, rectangle, black);
        CHECK(area(image) == Approx(rectangle.width * rectangle.height).margin(0.15));
    }
    Image image = blank_image(20, 20, white);
    fill(image, {3.0f, 4.0f, 2.0f, 1.0f}, black);
    CHECK(image.pixel(2, 4) == Pixel{255, 255, 255});
    CHECK(image.pixel(3, 4) == Pixel{0, 0, 0});
    CHECK(image.pixel(4, 4) == Pixel{0, 0, 0});
    CHECK(image.pixel(5, 4) == Pixel{255, 255, 255});
    CHECK(image.pixel(3, 3) == Pixel{255, 255, 255});
}

TEST_CASE("Rounded corners take away what lies between a square and its inscribed circle", "[canvas]") {
    const double missing = 4.0 - std::numbers::pi;
    Image image = blank_image(60, 40, white);
    fill(image, {5.0f, 5.0f, 50.0f, 30.0f}, black, 8.0f);
    CHECK(area(image) == Approx(50.0 * 30.0 - missing * 64.0).epsilon(0.002));
    // A radius that does not fit becomes half of the shorter side.
    image = blank_image(60, 40, white);
    fill(image, {5.0f, 5.0f, 50.0f, 30.0f}, black, 1000.0f);
    CHECK(area(image) == Approx(50.0 * 30.0 - missing * 225.0).epsilon(0.002));
}

TEST_CASE("A frame is as wide as it should be, inside of its rectangle", "[canvas]") {
    Image image = blank_image(40, 30, white);
    draw_frame(image, {4.0f, 5.0f, 20.0f, 10.0f}, 1.5f, black);
    CHECK(area(image) == Approx(20.0 * 10.0 - 17.0 * 7.0).margin(0.3));
    CHECK(image.pixel(4, 5) == Pixel{0, 0, 0});
    CHECK(image.pixel(3, 8) == Pixel{255, 255, 255});
    CHECK(cover(image, 5, 10) == Approx(0.5).margin(0.01));
    CHECK(image.pixel(12, 10) == Pixel{255, 255, 255});
    // Where its sides meet it is full.
    image = blank_image(40, 30, white);
    draw_frame(image, {4.0f, 5.0f, 20.0f, 10.0f}, 100.0f, black);
    CHECK(area(image) == Approx(200.0));
}

TEST_CASE("A line is as wide as it should be, wherever it lies between pixels", "[canvas]") {
    for (const float width : {0.25f, 0.6f, 1.0f, 1.5f, 4.2f}) {
        for (const float y : {10.0f, 10.2f, 10.5f, 10.8f}) {
            INFO("width " << width << " at " << y);
            Image image = blank_image(40, 20, white);
            draw_line(image, {5.0f, y}, {35.0f, y}, width, black);
            double column = 0.0;
            for (int row = 0; row < 20; ++row) column += cover(image, 20, row);
            CHECK(column == Approx(width).margin(width < 1.0f ? 0.2 * width : 0.02));
        }
    }
    // Slanting, with the two halves of its round ends.
    Image image = blank_image(80, 60, white);
    draw_line(image, {10.0f, 12.0f}, {58.0f, 48.0f}, 5.0f, black);
    CHECK(area(image) == Approx(5.0 * 60.0 + std::numbers::pi * 6.25).epsilon(0.005));
}

TEST_CASE("An arrow has a shaft and a head whose tip is its end", "[canvas]") {
    Image image = blank_image(120, 60, white);
    draw_arrow(image, {10.0f, 30.0f}, {100.0f, 30.0f}, 5.0f, black);
    const auto height_at = [&](int x) {
        double sum = 0.0;
        for (int y = 0; y < 60; ++y) sum += cover(image, x, y);
        return sum;
    };
    CHECK(height_at(40) == Approx(5.0).margin(0.05));
    CHECK(height_at(82) == Approx(16.0).margin(0.8));  // the base of the head
    CHECK(height_at(90) == Approx(16.0 * 9.5 / 18.0).margin(0.3));
    CHECK(height_at(97) > 0.5);
    CHECK(height_at(101) == 0.0);
    CHECK(area(image) == Approx(5.0 * 72.0 + 0.5 * 16.0 * 18.0 + 0.5 * std::numbers::pi * 6.25).epsilon(0.01));

    // And no direction cuts anything of it off.
    for (float angle = 0.0f; angle < 6.3f; angle += 0.3f) {
        image = blank_image(120, 120, white);
        const glm::vec2 along(std::cos(angle), std::sin(angle));
        draw_arrow(image, {60.0f, 60.0f}, glm::vec2(60.0f) + 37.0f * along, 5.0f, black);
        CHECK(area(image) == Approx(5.0 * 19.0 + 0.5 * 16.0 * 18.0 + 0.5 * std::numbers::pi * 6.25).epsilon(0.02));
    }

    // Half as long as two heads, it is half as large.
    image = blank_image(120, 60, white);
    draw_arrow(image, {10.0f, 30.0f}, {28.0f, 30.0f}, 5.0f, black);
    CHECK(area(image) == Approx(2.5 * 9.0 + 0.5 * 8.0 * 9.0 + 0.5 * std::numbers::pi * 1.5625).epsilon(0.03));
}

TEST_CASE("A translucent arrow is nowhere darker than its paint", "[canvas]") {
    for (const glm::vec2 to : {glm::vec2(90.0f, 30.0f), glm::vec2(80.0f, 8.0f), glm::vec2(22.0f, 31.0f)}) {
        Image image = blank_image(100, 60, white);
        draw_arrow(image, {10.0f, 30.0f}, to, 6.0f, {.opacity = 0.4f});
        int darkest = 255;
        for (const std::uint8_t channel : image.rgb) darkest = std::min<int>(darkest, channel);
        CHECK(darkest == 153);
    }
}

TEST_CASE("What is drawn over an edge is what a larger image shows there", "[canvas]") {
    Image large = blank_image(200, 200, ivory);
    draw_all(large, {70.0f, 80.0f});
    Image small = blank_image(43, 37, ivory);
    draw_all(small, {0.0f, 0.0f});
    CHECK(small == cropped(large, 70, 80, 43, 37));
    CHECK(area(small) > 0.0);
    // At the opposite corner as well.
    small = blank_image(43, 37, ivory);
    draw_all(small, {20.0f, 10.0f});
    CHECK(small == cropped(large, 50, 70, 43, 37));
}

TEST_CASE("Without a size, a place or an opacity nothing is drawn", "[canvas]") {
    const Image empty = blank_image(20, 20, white);
    Image image = empty;
    for (const float bad : {not_a_number, infinite, -infinite}) {
        fill(image, {bad, 1.0f, 5.0f, 5.0f}, black);
        fill(image, {1.0f, 1.0f, 5.0f, bad}, black);
        fill(image, {1.0f, 1.0f, 5.0f, 5.0f}, black, bad);
        draw_frame(image, {1.0f, bad, 5.0f, 5.0f}, 1.0f, black);
        draw_frame(image, {1.0f, 1.0f, 5.0f, 5.0f}, bad, black);
        draw_line(image, {1.0f, bad}, {5.0f, 5.0f}, 1.0f, black);
        draw_line(image, {1.0f, 1.0f}, {5.0f, 5.0f}, bad, black);
        draw_arrow(image, {1.0f, 1.0f}, {bad, 5.0f}, 1.0f, black);
        draw_arrow(image, {1.0f, 1.0f}, {15.0f, 5.0f}, bad, black);
        draw_dot(image, {bad, 5.0f}, 3.0f, black);
        draw_dot(image, {5.0f, 5.0f}, bad, black);
        draw_dot(image, {5.0f, 5.0f}, 3.0f, {.opacity = bad});
        draw_dot(image, {5.0f, 5.0f}, 3.0f, {.colour = {bad, 0.0f, 0.0f}});
    }
    for (const float nothing : {0.0f, -3.0f}) {
        fill(image, {1.0f, 1.0f, nothing, 5.0f}, black);
        fill(image, {1.0f, 1.0f, 5.0f, nothing}, black, 2.0f);
        draw_frame(image, {1.0f, 1.0f, 5.0f, 5.0f}, nothing, black);
        draw_line(image, {1.0f, 1.0f}, {5.0f, 5.0f}, nothing, black);
        draw_arrow(image, {1.0f, 1.0f}, {15.0f, 5.0f}, nothing, black);
        draw_dot(image, {5.0f, 5.0f}, nothing, black);
        draw_dot(image, {5.0f, 5.0f}, 3.0f, {.opacity = nothing});
    }
    draw_arrow(image, {5.0f, 5.0f}, {5.0f, 5.0f}, 3.0f, black);
    CHECK(image == empty);
}

TEST_CASE("Coordinates may be as large as numbers are", "[canvas]") {
    constexpr float huge = std::numeric_limits<float>::max();
    Image image = blank_image(20, 10, white);
    fill(image, {-huge, -huge, huge, huge}, black);
    draw_line(image, {huge, huge}, {huge, -huge}, 3.0f, black);
    draw_dot(image, {-huge, huge}, 10.0f, black);
    draw_arrow(image, {0.0f, huge}, {20.0f, huge}, 4.0f, black);
    CHECK(area(image) == 0.0);
    draw_line(image, {-huge, 5.0f}, {huge, 5.0f}, 2.0f, black);
    CHECK(area(image) == Approx(40.0));
    fill(image, {-1e30f, -1e30f, 2e30f, 2e30f}, black);
    CHECK(area(image) == Approx(200.0));
}

TEST_CASE("A pasted image is there byte by byte, and cut off at the edges", "[canvas]") {
    Image what = blank_image(5, 4, white);
    for (std::size_t i = 0; i < what.rgb.size(); ++i) what.rgb[i] = static_cast<std::uint8_t>(i);
    const Image empty = blank_image(9, 7, red);
    constexpr int most = std::numeric_limits<int>::max();
    constexpr int least = std::numeric_limits<int>::min();
    for (const auto& [left, top] :
         {std::pair{2, 1}, std::pair{-3, -2}, std::pair{7, 5}, std::pair{9, 0}, std::pair{0, -4},
          std::pair{most, most}, std::pair{least, least}, std::pair{1, most}}) {
        INFO("at " << left << ", " << top);
        Image image = empty;
        paste(image, what, left, top);
        for (int y = 0; y < 7; ++y) {
            for (int x = 0; x < 9; ++x) {
                const std::int64_t column = static_cast<std::int64_t>(x) - left;
                const std::int64_t row = static_cast<std::int64_t>(y) - top;
                const bool covered = column >= 0 && column < 5 && row >= 0 && row < 4;
                CHECK(image.pixel(x, y) ==
                      (covered ? what.pixel(static_cast<int>(column), static_cast<int>(row)) : empty.pixel(x, y)));
            }
        }
    }
    // The larger one onto the smaller.
    Image image = what;
    paste(image, empty, -2, -2);
    CHECK(image == blank_image(5, 4, red));
}
