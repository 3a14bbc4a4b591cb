// The light of the sky where bodies hide a part of it: pictures of many samples.
#include "renderer/images/light_bytes.h"
#include "tests/catch.h"
#include "tests/renderer/sample_pictures.h"

#include <cmath>

using namespace pushfactor::renderer;

namespace {

constexpr int side = 160;  // pixels

// Linear light of a pixel and its neighbours, mean of the channels: steps of a byte are too coarse for one.
double light(const Image& image, int x, int y) {
    double sum = 0.0;
    for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
            for (const std::uint8_t channel : image.pixel(x + dx, y + dy)) sum += light_of_byte(channel);
        }
    }
    return sum / 27.0;
}

double light_at(const Image& image, float x, float z) {
    const auto [column, row] = pixel_from_above(from_above, side, side, x, z);
    return light(image, column, row);
}

// A wall along x, of this height, behind the ground that is seen; the sun stands on the side that is seen.
Picture wall(float height) {
    return {.camera = from_above,
            .towards_sun = {0.0f, 1.0f, 1.0f},
            .ground = Ground{},
            .bodies = {{.position = {0.0f, 0.5f * height, -4.5f}, .shape = Box{{400.0f, 0.5f * height, 0.5f}}}}};
}

}  // namespace

TEST_CASE("Ground in front of a wall loses the part of the sky that the wall hides") {
    // A wall that is seen up to the elevation a hides (1 - cos a) / 2 of the light that a level surface gets from
    // an even sky. Points between the lines of the ground.
    const float height = 3.0f;
    const Image bare = OffscreenRenderer(side, side, 256).render(wall(0.002f));
    const Image walled = OffscreenRenderer(side, side, 256).render(wall(height));
    const auto lost = [&](float from_wall) {
        const float z = -4.0f + from_wall;
        return (light_at(bare, 0.5f, z) - light_at(walled, 0.5f, z)) / light_at(bare, 0.5f, z);
    };
    const auto hidden = [&](float from_wall) { return 0.5 * (1.0 - std::cos(std::atan2(height, from_wall))); };
    const double scale = lost(1.5f) / hidden(1.5f);
    CHECK(scale > 0.3);  // of all light on ground in the sun the sky's is about a half
    CHECK(scale < 0.7);
    for (const float distance : {0.5f, 2.5f, 4.5f}) {
        INFO(distance);
        CHECK(lost(distance) == Approx(scale * hidden(distance)).margin(0.02));
    }
}

TEST_CASE("Ground is darker the nearer it is to the foot of a cube, all around it") {
    const Picture cube{.camera = from_above,
                       .towards_sun = {0.0f, 1.0f, 0.0f},
                       .ground = Ground{},
                       .bodies = {{.position = {0.0f, 1.0f, 0.0f}, .shape = Box{glm::vec3(1.0f)}}}};
    const Image image = OffscreenRenderer(side, side, 64).render(cube);
    const double open = light_at(image, 5.5f, 5.5f);
    for (const glm::vec2& aside : {glm::vec2(1.0f, 0.0f), {-1.0f, 0.0f}, {0.0f, 1.0f}, {0.0f, -1.0f}}) {
        // Beside the lines through the middle.
        const glm::vec2 off = 0.5f * glm::vec2(aside.y, aside.x);
        const auto at = [&](float distance) {
            const glm::vec2 place = distance * aside + off;
            return light_at(image, place.x, place.y);
        };
        CHECK(at(1.5f) < 0.93 * open);
        CHECK(at(1.5f) < at(2.5f));
        CHECK(at(2.5f) < at(4.5f));
        CHECK(at(4.5f) > 0.96 * open);
    }
}

TEST_CASE("What no body hides has the light of a single sample") {
    const Picture far_ball{.camera = from_above,
                           .ground = Ground{},
                           .bodies = {{.position = {3.0f, 0.2f, 3.0f}, .shape = Sphere{0.2f}}}};
    const Image one = OffscreenRenderer(side, side).render(far_ball);
    for (const int samples : {4, 16, 64}) {
        const Image many = OffscreenRenderer(side, side, samples).render(far_ball);
        CHECK(light_at(many, -4.5f, -4.5f) == Approx(light_at(one, -4.5f, -4.5f)).epsilon(0.01));
    }
}

TEST_CASE("A side without sun is darker beside ground in its own shadow than beside ground in the sun") {
    // The face towards the camera has no sun; its own shadow is in front of it, and the farther the higher it is.
    const auto under = [](float altitude) {
        const Picture picture{.camera = from_the_front,
                              .towards_sun = {0.0f, 1.0f, -1.0f},
                              .ground = Ground{.height = -altitude},
                              .bodies = {{.shape = Box{{2.0f, 0.5f, 0.5f}}, .colour = ivory}}};
        const Image image = OffscreenRenderer(side, side, 64).render(picture);
        const auto [x, y] = pixel_from_the_front(side, side, {0.3f, -0.35f, 0.5f});
        return light(image, x, y);
    };
    CHECK(under(0.6f) < 0.97 * under(3.0f));
}

TEST_CASE("Samples that are spread over pictures blur what moves between them, and nothing else") {
    std::vector<Picture> moving;
    for (int i = 0; i < 16; ++i) {
        moving.push_back({.camera = from_the_front,
                          .bodies = {{.position = {0.1f * static_cast<float>(i) - 0.75f, 0.0f, 0.0f},
                                      .shape = Box{glm::vec3(0.8f)},
                                      .colour = red}}});
    }
    const auto context = open_offscreen_context();
    Renderer renderer(*context, side, side, shader_directory, 16);
    Image blurred, still;
    renderer.render(moving, blurred);
    renderer.render(std::span(&moving[8], 1), still);
    const auto redness = [](const Image& image, float x) {
        const auto [column, row] = pixel_from_the_front(side, side, {x, 0.0f, 0.8f});
        return static_cast<int>(image.pixel(column, row)[0]) - image.pixel(column, row)[1];
    };
    CHECK(redness(blurred, 0.0f) > 100);
    CHECK(redness(still, 1.2f) < 20);
    CHECK(redness(blurred, 1.2f) > redness(still, 1.2f) + 20);
    CHECK(redness(blurred, 1.2f) < redness(blurred, 0.0f) - 20);

    const std::vector<Picture> same(16, moving[8]);
    Image resting;
    renderer.render(same, resting);
    CHECK(resting == still);
}
