// Images that are the mean of several draws.
#include "renderer/images/sampling.h"

#include "renderer/base/renderer_error.h"
#include "tests/catch.h"
#include "tests/renderer/sample_pictures.h"

#include <glm/geometric.hpp>

#include <set>

using namespace pushfactor::renderer;

namespace {

constexpr int width = 160;   // pixels
constexpr int height = 120;  // pixels

// A thin slab over the ground that reaches from the left to the middle: its shadow ends along x = 0 below the
// middle of the picture, whatever its height.
Picture slab_at(float altitude) {
    return {.camera = from_above,
            .towards_sun = {0.0f, 1.0f, 1.0f},
            .ground = Ground{},
            .boxes = {{.position = {-2.0f, altitude, altitude + 4.0f}, .half_extents = {2.0f, 0.01f, 0.5f}}}};
}

// The number of pixels along a row that are neither in full shadow nor in full light.
int half_lit(const Image& image, float z) {
    int count = 0;
    const auto [left, y] = pixel_from_above(from_above, width, height, -1.5f, z);
    const auto [right, _] = pixel_from_above(from_above, width, height, 1.5f, z);
    const int dark = brightness(image, left, y);
    const int light = brightness(image, right, y);
    for (int x = left; x <= right; ++x) {
        const int here = brightness(image, x, y);
        count += here > dark + (light - dark) / 10 && here < light - (light - dark) / 10 ? 1 : 0;
    }
    return count;
}

}  // namespace

TEST_CASE("Offsets cover the pixel and the sun's disc evenly, and a single one is none") {
    const glm::vec3 sun = glm::normalize(glm::vec3(-0.5f, 0.9f, 0.65f));
    CHECK(sample_offset(0, 1, sun).pixel == glm::vec2(0.0f));
    CHECK(sample_offset(0, 1, sun).towards_sun == sun);
    for (const int count : {2, 16, 256}) {
        glm::vec2 pixels(0.0f);
        glm::vec3 suns(0.0f);
        std::set<int> columns;
        for (int i = 0; i < count; ++i) {
            const SampleOffset offset = sample_offset(i, count, sun);
            CHECK(std::abs(offset.pixel.x) <= 0.5f);
            CHECK(std::abs(offset.pixel.y) <= 0.5f);
            CHECK(glm::length(offset.towards_sun) == Approx(1.0f));
            CHECK(glm::dot(offset.towards_sun, sun) > std::cos(glm::radians(1.5f)) - 1e-6f);
            pixels += offset.pixel / static_cast<float>(count);
            suns += offset.towards_sun / static_cast<float>(count);
            columns.insert(static_cast<int>(4.0f * (offset.pixel.x + 0.5f)));
        }
        CHECK(glm::length(pixels) < 2.0f / static_cast<float>(count));
        CHECK(glm::length(glm::cross(suns, sun)) < 0.03f / static_cast<float>(count) + 0.001f);
        CHECK(static_cast<int>(columns.size()) == std::min(count, 4));
    }
}

TEST_CASE("The mean of images is taken in linear light") {
    SampleMean mean(2, 1);
    const std::vector<PixelArea> all{{0, 0, 2, 1}};
    Image image{2, 1, std::vector<std::uint8_t>(6)};
    const Image first{2, 1, {0, 0, 255, 17, 200, 1}};
    mean.add(first, all);
    mean.put(1, all, image);
    CHECK(image == first);
    mean.add({2, 1, {255, 0, 255, 17, 201, 2}}, all);
    mean.put(2, all, image);
    CHECK(image.rgb[0] == 188);  // half of the light, not 128
    CHECK(image.rgb[1] == 0);
    CHECK(image.rgb[2] == 255);
    CHECK(image.rgb[3] == 17);
}

TEST_CASE("The mean of a part leaves the rest as it was") {
    SampleMean mean(2, 2);
    const std::vector<PixelArea> all{{0, 0, 2, 2}};
    const std::vector<PixelArea> lower_right{{1, 0, 1, 1}};
    const Image grey{2, 2, std::vector<std::uint8_t>(12, 100)};
    mean.add(grey, all);
    mean.clear(lower_right);
    mean.add({2, 2, std::vector<std::uint8_t>(12, 7)}, lower_right);
    Image image{2, 2, std::vector<std::uint8_t>(12, 55)};
    mean.put(1, lower_right, image);
    CHECK(image.rgb == std::vector<std::uint8_t>{55, 55, 55, 55, 55, 55, 55, 55, 55, 7, 7, 7});
    mean.put(1, all, image);
    CHECK(image.rgb == std::vector<std::uint8_t>{100, 100, 100, 100, 100, 100, 100, 100, 100, 7, 7, 7});
}

TEST_CASE("One sample is the plain image, and the same number of samples gives the same bytes") {
    CHECK(Studio(width, height, 1).render(all_kinds()) == Studio(width, height).render(all_kinds()));
    Studio studio(width, height, 7);
    const Image first = studio.render(all_kinds());
    studio.render(stack_of_cubes(2));
    CHECK(studio.render(all_kinds()) == first);
    CHECK(Studio(width, height, 7).render(all_kinds()) == first);
}

TEST_CASE("More samples make finer edges and leave the picture as it is") {
    const glm::quat tilted = glm::angleAxis(0.3f, glm::vec3(0.0f, 0.0f, 1.0f));
    const Picture picture{.camera = from_the_front,
                          .boxes = {{.orientation = tilted, .half_extents = glm::vec3(1.5f), .colour = red}}};
    const Image one = Studio(width, height).render(picture);
    const Image sixteen = Studio(width, height, 16).render(picture);
    const auto levels = [](const Image& image) {
        std::set<int> seen;
        for (std::size_t i = 2; i < image.rgb.size(); i += 3) seen.insert(image.rgb[i]);
        return seen.size();
    };
    CHECK(levels(sixteen) > levels(one) + 30);

    const Image still = Studio(width, height, 16).render(all_kinds());
    const Image frame = Studio(width, height).render(all_kinds());
    for (int row = 0; row < height; row += 30) {
        double difference = 0.0;
        for (int y = row; y < row + 30; ++y) {
            for (int x = 0; x < width; ++x) difference += brightness(still, x, y) - brightness(frame, x, y);
        }
        CHECK(std::abs(difference) / (3 * 30 * width) < 0.5);  // levels
    }
}

TEST_CASE("With many samples a shadow is softer the farther it falls") {
    // Pixels are 11 cm wide here; 1.5 degrees to each side at 24 m of slanting light are 1.3 m.
    Studio sharp(width, height);
    Studio soft(width, height, 32);
    CHECK(half_lit(sharp.render(slab_at(17.0f)), 4.0f) <= 3);
    const int near = half_lit(soft.render(slab_at(0.5f)), 4.0f);
    const int far = half_lit(soft.render(slab_at(17.0f)), 4.0f);
    CHECK(near <= 3);
    CHECK(far >= near + 3);
}

TEST_CASE("Numbers of samples that cannot be drawn are refused") {
    for (const int samples : {0, -1, Renderer::max_samples + 1}) {
        CHECK_THROWS_AS(Studio(8, 8, samples), RendererError);
    }
}
