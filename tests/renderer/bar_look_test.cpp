// The look of bars in a frame.
#include "renderer/renderer.h"
#include "tests/catch.h"
#include "tests/renderer/sample_pictures.h"

#include <glm/geometric.hpp>

using namespace pushfactor::renderer;

namespace {

constexpr int width = 320;   // pixels
constexpr int height = 180;  // pixels

// The summed darkening of the pixels within 2 of a point, `image` against `empty`.
int darkening_around(const Image& image, const Image& empty, int x, int y) {
    int sum = 0;
    for (int row = y - 2; row <= y + 2; ++row) {
        for (int column = x - 2; column <= x + 2; ++column) {
            sum += brightness(empty, column, row) - brightness(image, column, row);
        }
    }
    return sum;
}

}  // namespace

TEST_CASE("A bar is seen between its ends and not beyond, whatever its direction") {
    OffscreenRenderer offscreen(width, height);
    const Image empty = offscreen.background();
    for (const glm::vec3 direction :
         {glm::vec3(1.0f, 0.0f, 0.0f), glm::vec3(0.0f, 1.0f, 0.0f), glm::vec3(0.0f, -1.0f, 0.0f),
          glm::vec3(-0.6f, -0.8f, 0.0f), glm::vec3(0.8f, -0.6f, 0.0f), glm::vec3(0.48f, 0.6f, 0.64f)}) {
        const glm::vec3 from = glm::vec3(0.3f, 0.2f, 0.0f) - 1.2f * direction;
        const glm::vec3 to = from + 2.4f * direction;
        const Image image = offscreen.render(
            {.camera = from_the_front, .bars = {{.from = from, .to = to, .radius = 0.1f, .colour = red}}});
        for (const float part : {0.0f, 0.1f, 0.5f, 0.9f, 1.0f}) {
            const auto [x, y] = pixel_from_the_front(width, height, from + part * (to - from));
            CHECK(is_red(image.pixel(x, y)));
        }
        for (const glm::vec3 beyond : {from - 0.35f * direction, to + 0.35f * direction}) {
            const auto [x, y] = pixel_from_the_front(width, height, beyond);
            CHECK(image.pixel(x, y) == empty.pixel(x, y));
        }
        // And of the right width.
        const glm::vec3 across = glm::normalize(glm::cross(direction, glm::vec3(0.0f, 0.0f, 1.0f)));
        const auto [in_x, in_y] = pixel_from_the_front(width, height, 0.5f * (from + to) + 0.06f * across);
        CHECK(is_red(image.pixel(in_x, in_y)));
        const auto [out_x, out_y] = pixel_from_the_front(width, height, 0.5f * (from + to) + 0.19f * across);
        CHECK(image.pixel(out_x, out_y) == empty.pixel(out_x, out_y));
    }
}

TEST_CASE("A bar whose ends coincide is a dot") {
    OffscreenRenderer offscreen(width, height);
    const Image image = offscreen.render(
        {.camera = from_the_front, .bars = {{.to = glm::vec3(0.0f), .radius = 0.2f, .colour = red}}});
    CHECK(is_red(image.pixel(width / 2, height / 2)));
    CHECK_FALSE(is_red(image.pixel(width / 2, height / 2 - 10)));
}

TEST_CASE("A bar much thinner than a pixel has no gaps") {
    OffscreenRenderer offscreen(width, height);
    const Image empty = offscreen.background();
    for (const float degrees : {0.0f, 3.0f, 20.0f, 45.0f, 77.0f, 90.0f, 130.0f}) {
        INFO(degrees << " degrees");
        const float angle = glm::radians(degrees);
        const glm::vec3 end = 2.5f * glm::vec3(std::cos(angle), std::sin(angle), 0.0f);
        // A pixel is 4 cm here.
        const Image image =
            offscreen.render({.camera = from_the_front,
                              .bars = {{.from = -end, .to = end, .radius = 0.001f, .colour = glm::vec3(0.05f)}}});
        int least = 1 << 20;
        int most = 0;
        for (float part = -0.95f; part <= 0.95f; part += 0.01f) {
            const auto [x, y] = pixel_from_the_front(width, height, part * end);
            const int darkening = darkening_around(image, empty, x, y);
            least = std::min(least, darkening);
            most = std::max(most, darkening);
        }
        CHECK(least > 5 * 300);  // five pixels, each more than half dark
        CHECK(least > most * 6 / 10);
        CHECK(most < 5 * 1600);  // but not a thick line either
    }
}

TEST_CASE("The shadow of a thin bar has no gaps") {
    OffscreenRenderer offscreen(width, height);
    Picture picture{.camera = from_above, .towards_sun = {-1.0f, 1.0f, 0.0f}, .ground = Ground{}};
    const Image lit = offscreen.render(picture);
    const glm::vec3 from(-6.0f, 3.0f, -2.5f);
    const glm::vec3 to(-1.0f, 3.0f, 4.0f);
    picture.bars = {{.from = from, .to = to, .radius = 0.001f, .colour = ivory}};
    const Image shadowed = offscreen.render(picture);
    for (float part = 0.05f; part <= 0.95f; part += 0.01f) {
        const glm::vec3 above = from + part * (to - from);
        const auto [x, y] = pixel_from_above(picture.camera, width, height, above.x + 3.0f, above.z);
        CHECK(darkening_around(shadowed, lit, x, y) > 150);
    }
}

TEST_CASE("A bar does not darken the picture elsewhere") {
    OffscreenRenderer offscreen(width, height);
    Picture picture{.camera = from_above, .ground = Ground{}};
    const Image empty = offscreen.render(picture);
    picture.bars = {{.from = {-1.0f, 0.5f, 0.0f}, .to = {1.0f, 0.5f, 0.0f}, .radius = 0.05f}};
    const Image image = offscreen.render(picture);
    for (int y = 0; y < height / 3; ++y) {
        for (int x = 0; x < width; ++x) CHECK(image.pixel(x, y) == empty.pixel(x, y));
    }
}
