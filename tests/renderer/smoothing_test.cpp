// Smoothing of edges that were drawn with one sample per pixel: against the share of each pixel that a straight
// edge covers.
#include "renderer/images/smoothing.h"

#include "renderer/images/light_bytes.h"
#include "tests/catch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

using namespace pushfactor::renderer;

namespace {

constexpr int side = 64;  // pixels
const std::vector<PixelArea> all{{0, 0, side, side}};

// An image, rows from the bottom, that is dark where `inside` holds of a pixel's centre; dark pixels are marked.
std::vector<std::uint8_t> drawn(const std::function<bool(double, double)>& inside, bool marked = true) {
    std::vector<std::uint8_t> rgba;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const bool dark = inside(x + 0.5, y + 0.5);
            const std::uint8_t level = dark ? 40 : 200;
            rgba.insert(rgba.end(), {level, level, level, static_cast<std::uint8_t>(dark && marked ? 255 : 0)});
        }
    }
    return rgba;
}

Image smoothed(const std::vector<std::uint8_t>& rgba, const std::vector<PixelArea>& areas = all) {
    Image image{side, side, std::vector<std::uint8_t>(3 * side * side)};
    smooth_edges(rgba, areas, image);
    return image;
}

// The share of a pixel, rows from the bottom, that is dark, by its light.
double dark_share(const Image& image, int x, int y) {
    const double light = light_of_byte(image.pixel(x, side - 1 - y)[0]);
    return (light_of_byte(200) - light) / (light_of_byte(200) - light_of_byte(40));
}

// The largest error of the share, of pixels well inside the image, below a line of this slope.
double worst_error(double slope, bool swapped) {
    const auto below = [&](double x, double y) {
        return swapped ? x < 0.5 * side + slope * (y - 0.5 * side) : y < 0.5 * side + slope * (x - 0.5 * side);
    };
    const Image image = smoothed(drawn(below));
    double worst = 0.0;
    for (int y = 20; y < side - 20; ++y) {
        for (int x = 20; x < side - 20; ++x) {
            int covered = 0;
            for (int i = 0; i < 64; ++i) covered += below(x + (i % 8 + 0.5) / 8.0, y + (i / 8 + 0.5) / 8.0) ? 1 : 0;
            worst = std::max(worst, std::abs(dark_share(image, x, y) - covered / 64.0));
        }
    }
    return worst;
}

}  // namespace

TEST_CASE("A straight edge becomes as smooth as the shares of the pixels that it covers") {
    for (const double slope : {1.0 / 14.0, 1.0 / 9.0, -1.0 / 6.0, 0.25, -0.4}) {
        for (const bool swapped : {false, true}) {
            INFO("slope " << slope << (swapped ? ", upright" : ", level"));
            CHECK(worst_error(slope, swapped) < 0.22);  // 0.5 as drawn
        }
    }
}

TEST_CASE("Level and upright edges stay as they are") {
    const auto rgba = drawn([](double x, double y) { return x > 20.0 && x < 44.0 && y > 20.0 && y < 44.0; });
    const Image image = smoothed(rgba);
    int changed = 0;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            changed +=
                image.pixel(x, side - 1 - y)[0] == rgba[static_cast<std::size_t>(4 * (y * side + x))] ? 0 : 1;
        }
    }
    CHECK(changed <= 4);  // the corners may be
}

TEST_CASE("A long edge that ends in a bevel stays straight") {
    const auto rgba = drawn([](double x, double y) {
        const double from_corner = std::min(x - 20.0, 44.0 - x) + std::min(y - 16.0, 48.0 - y);
        return x > 20.0 && x < 44.0 && y > 16.0 && y < 48.0 && from_corner > 2.0;
    });
    const Image image = smoothed(rgba);
    for (int y = 20; y < 44; ++y) {
        INFO("row " << y);
        for (const int x : {19, 20, 43, 44}) {
            CHECK(image.pixel(x, side - 1 - y)[0] == rgba[static_cast<std::size_t>(4 * (y * side + x))]);
        }
    }
}

TEST_CASE("What is not marked stays as crisp as it was drawn") {
    const auto disc = [](double x, double y) { return std::hypot(x - 32.0, y - 32.0) < 20.0; };
    const Image image = smoothed(drawn(disc, false));
    CHECK(std::ranges::count_if(image.rgb, [](std::uint8_t level) { return level != 40 && level != 200; }) == 0);
    const Image marked = smoothed(drawn(disc));
    CHECK(std::ranges::count_if(marked.rgb, [](std::uint8_t level) { return level != 40 && level != 200; }) > 200);
}

TEST_CASE("A disc keeps its size") {
    const auto disc = [](double x, double y) { return std::hypot(x - 32.0, y - 32.3) < 20.2; };
    const Image image = smoothed(drawn(disc));
    double dark = 0.0;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) dark += dark_share(image, x, y);
    }
    int as_drawn = 0;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) as_drawn += disc(x + 0.5, y + 0.5) ? 1 : 0;
    }
    CHECK(dark == Approx(as_drawn).epsilon(0.01));  // 0.8 % less seen, from the outermost rows and columns
}

TEST_CASE("Smoothing in parts gives the same bytes as all at once, and leaves the rest alone") {
    const auto rgba = drawn([](double x, double y) { return std::hypot(x - 32.0, y - 32.0) < 20.0; });
    const Image whole = smoothed(rgba);
    std::vector<PixelArea> parts;
    for (int i = 0; i < 16; ++i) parts.push_back({16 * (i % 4), 16 * (i / 4), 16, 16});
    CHECK(smoothed(rgba, parts) == whole);
    const Image some = smoothed(rgba, {parts[0]});
    CHECK(some.pixel(40, 3) == std::array<std::uint8_t, 3>{0, 0, 0});
}

TEST_CASE("Pixels come out top row first and without the fourth channel, also of images too small to have edges") {
    Image image{1, 1, {0, 0, 0}};
    smooth_edges(std::vector<std::uint8_t>{1, 2, 3, 255}, std::vector<PixelArea>{{0, 0, 1, 1}}, image);
    CHECK(image.rgb == std::vector<std::uint8_t>{1, 2, 3});

    const std::vector<std::uint8_t> rgba = {1, 2, 3, 255, 4,  5,  6,  255,  // the lower row
                                            7, 8, 9, 255, 10, 11, 12, 0};   // the upper row
    Image square{2, 2, std::vector<std::uint8_t>(12)};
    smooth_edges(rgba, std::vector<PixelArea>{{0, 0, 2, 2}}, square);
    CHECK(square.rgb == std::vector<std::uint8_t>{7, 8, 9, 10, 11, 12, 1, 2, 3, 4, 5, 6});
    CHECK(square.pixel(0, 0) == std::array<std::uint8_t, 3>{7, 8, 9});
    CHECK(square.pixel(1, 1) == std::array<std::uint8_t, 3>{4, 5, 6});
}
