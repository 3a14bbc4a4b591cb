// Images that are the mean of several draws.
#include "renderer/images/sampling.h"

#include "renderer/base/renderer_error.h"
#include "renderer/images/exposure.h"
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
            .bodies = {{.position = {-2.0f, altitude, altitude + 4.0f}, .shape = Box{{2.0f, 0.01f, 0.5f}}}}};
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

TEST_CASE("The directions of all samples weigh the sky as it lights the ground, and walls about half as much") {
    for (const int count : {2, 16, 64, 256}) {
        double ground = 0.0;
        for (const glm::vec3& wall : {glm::vec3(1.0f, 0.0f, 0.0f), glm::vec3(0.0f, 0.0f, -1.0f)}) {
            double on_wall = 0.0;
            for (int i = 0; i < count; ++i) {
                const SampleOffset offset = sample_offset(i, count, glm::vec3(0.0f, 1.0f, 0.0f));
                CHECK(glm::length(offset.towards_sky) == Approx(1.0f));
                CHECK(offset.towards_sky.y > 0.0f);
                on_wall += offset.sky_weight * std::max(glm::dot(wall, offset.towards_sky), 0.0f) /
                           static_cast<float>(count);
            }
            if (count >= 16) CHECK(on_wall == Approx(0.5).epsilon(count < 64 ? 0.2 : 0.1));
        }
        for (int i = 0; i < count; ++i) {
            const SampleOffset offset = sample_offset(i, count, glm::vec3(0.0f, 1.0f, 0.0f));
            ground += offset.sky_weight * offset.towards_sky.y / static_cast<float>(count);
        }
        CHECK(ground == Approx(1.0).epsilon(1e-5));
    }
}

TEST_CASE("The mean of renderings is taken in linear light, and exposed then") {
    SampleMean mean(2, 1);
    const PixelArea all{0, 0, 2, 1};
    const std::vector<PixelArea> areas{all};
    Image image{2, 1, std::vector<std::uint8_t>(6)};
    mean.add(std::vector<float>{0.0f, 0.1f, 0.5f, 9.0f, 0.0f, 0.0f, 0.0f, 9.0f}, all);
    mean.add(std::vector<float>{1.0f, 0.1f, 0.5f, 9.0f, -2.0f, 0.0f, 0.2f, 9.0f}, all);
    mean.put(2, areas, image);
    CHECK(image.rgb[0] == 188);  // half of the light, not 128
    CHECK(image.rgb[1] == 89);
    CHECK(image.rgb[2] == 188);
    CHECK(image.rgb[3] == 0);  // there is no negative light
    CHECK(image.rgb[5] == 89);
    mean.clear(areas);
    mean.add(std::vector<float>{4.0f, 4.0f, 4.0f, 0.0f, 4.0f, 0.0f, 0.0f, 0.0f}, all);
    mean.put(1, areas, image);
    CHECK(image.rgb[0] >= 254);  // bent towards 1
    CHECK(image.rgb[4] == 0);
}

TEST_CASE("What is exposed can be told from the result, and dark light is left as it is") {
    for (const glm::vec3& light : {glm::vec3(0.1f, 0.2f, 0.6f), glm::vec3(0.7f, 0.1f, 0.0f), glm::vec3(1.5f)}) {
        CHECK(glm::length(unexposed(exposed(light)) - light) < 1e-4f);
    }
    CHECK(exposed(glm::vec3(0.1f, 0.2f, 0.5f)) == glm::vec3(0.1f, 0.2f, 0.5f));
    CHECK(exposed(glm::vec3(9.0f, 3.0f, 0.0f)).r <= 1.0f);
}

TEST_CASE("The mean of a part leaves the rest as it was") {
    SampleMean mean(2, 2);
    const PixelArea all{0, 0, 2, 2}, lower_right{1, 0, 1, 1};
    mean.add(std::vector<float>(16, 0.25f), all);
    const std::vector<PixelArea> part{lower_right};
    mean.clear(part);
    mean.add(std::vector<float>(4, 0.0f), lower_right);
    Image image{2, 2, std::vector<std::uint8_t>(12, 55)};
    mean.put(1, part, image);
    CHECK(image.rgb == std::vector<std::uint8_t>{55, 55, 55, 55, 55, 55, 55, 55, 55, 0, 0, 0});
    mean.put(1, std::vector<PixelArea>{all}, image);
    CHECK(image.rgb == std::vector<std::uint8_t>{137, 137, 137, 137, 137, 137, 137, 137, 137, 0, 0, 0});
}

TEST_CASE("One sample is the plain image, and the same number of samples gives the same bytes") {
    CHECK(OffscreenRenderer(width, height, 1).render(all_kinds()) ==
          OffscreenRenderer(width, height).render(all_kinds()));
    OffscreenRenderer offscreen(width, height, 7);
    const Image first = offscreen.render(all_kinds());
    offscreen.render(stack_of_cubes(2));
    CHECK(offscreen.render(all_kinds()) == first);
    CHECK(OffscreenRenderer(width, height, 7).render(all_kinds()) == first);
}

TEST_CASE("More samples make finer edges and leave the picture as it is") {
    const glm::quat tilted = glm::angleAxis(0.3f, glm::vec3(0.0f, 0.0f, 1.0f));
    const Picture picture{.camera = from_the_front,
                          .bodies = {{.orientation = tilted, .shape = Box{glm::vec3(1.5f)}, .colour = red}}};
    const Image one = OffscreenRenderer(width, height).render(picture);
    const Image sixteen = OffscreenRenderer(width, height, 16).render(picture);
    const auto levels = [](const Image& image) {
        std::set<int> seen;
        for (std::size_t i = 2; i < image.rgb.size(); i += 3) seen.insert(image.rgb[i]);
        return seen.size();
    };
    CHECK(levels(sixteen) > levels(one) + 15);

    // Few samples have the light of one; more darken what hides the sky from each other, and little else.
    const Image frame = OffscreenRenderer(width, height).render(all_kinds());
    for (const int samples : {8, 16, 64}) {
        const Image still = OffscreenRenderer(width, height, samples).render(all_kinds());
        double difference = 0.0;
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) difference += brightness(still, x, y) - brightness(frame, x, y);
        }
        INFO(samples);
        CHECK(std::abs(difference) / (3 * height * width) < (samples < 16 ? 1.5 : 4.0));  // levels
    }
}

TEST_CASE("With many samples a shadow is softer the farther it falls") {
    // Pixels are 11 cm wide here; 1.5 degrees to each side at 24 m of slanting light are 1.3 m.
    OffscreenRenderer sharp(width, height);
    OffscreenRenderer soft(width, height, 32);
    CHECK(half_lit(sharp.render(slab_at(17.0f)), 4.0f) <= 3);
    const int near = half_lit(soft.render(slab_at(0.5f)), 4.0f);
    const int far = half_lit(soft.render(slab_at(17.0f)), 4.0f);
    CHECK(near <= 4);
    CHECK(far >= near + 3);
}

TEST_CASE("Numbers of samples that cannot be drawn are refused") {
    for (const int samples : {0, -1, Renderer::max_samples + 1}) {
        CHECK_THROWS_AS(OffscreenRenderer(8, 8, samples), RendererError);
    }
}
