// The look of a frame: the right thing in the right place, lit from the right side, without rasterisation
// artefacts.
#include "renderer/renderer.h"
#include "tests/catch.h"
#include "tests/renderer/sample_pictures.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

using namespace pushfactor::renderer;

namespace {

double mean_difference(const Image& a, const Image& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.rgb.size(); ++i) sum += std::abs(a.rgb[i] - b.rgb[i]);
    return sum / static_cast<double>(a.rgb.size());
}

}  // namespace

TEST_CASE("A red box in the middle is red there and leaves the background elsewhere") {
    OffscreenRenderer offscreen(160, 90);
    const Image empty = offscreen.background();
    const Image image = offscreen.render({.camera = from_the_front, .bodies = {{.colour = red}}});
    CHECK(is_red(image.pixel(80, 45)));
    for (const auto& [x, y] : {std::pair{0, 0}, std::pair{159, 0}, std::pair{0, 89}, std::pair{159, 89},
                               std::pair{80, 10}, std::pair{80, 80}, std::pair{20, 45}, std::pair{140, 45}}) {
        CHECK(image.pixel(x, y) == empty.pixel(x, y));
    }
}

TEST_CASE("Up in the world is up in the image, and right is right") {
    const Image image =
        OffscreenRenderer(160, 90).render({.camera = from_the_front,
                                           .bodies = {{.position = {0.0f, 2.5f, 0.0f}, .colour = red},
                                                      {.position = {4.0f, 0.0f, 0.0f}, .colour = blue}}});
    CHECK(is_red(image.pixel(80, 12)));
    CHECK_FALSE(is_red(image.pixel(80, 77)));
    CHECK(is_blue(image.pixel(132, 45)));
    CHECK_FALSE(is_blue(image.pixel(27, 45)));
}

TEST_CASE("What is nearer hides what is farther") {
    const Body near{.position = {0.0f, 0.0f, 3.0f}, .colour = red};
    const Body far{.position = {0.0f, 0.0f, -3.0f}, .shape = Box{glm::vec3(0.9f)}, .colour = blue};
    OffscreenRenderer offscreen(160, 90);
    CHECK(is_red(offscreen.render({.camera = from_the_front, .bodies = {near, far}}).pixel(80, 45)));
    CHECK(is_red(offscreen.render({.camera = from_the_front, .bodies = {far, near}}).pixel(80, 45)));
}

TEST_CASE("A box turns the way its quaternion says") {
    // A bar along x, turned by 90 degrees about z, stands upright.
    const glm::quat quarter = glm::angleAxis(glm::radians(90.0f), glm::vec3(0.0f, 0.0f, 1.0f));
    Body bar{.shape = Box{{2.0f, 0.3f, 0.3f}}, .colour = red};
    OffscreenRenderer offscreen(160, 90);
    CHECK(is_red(offscreen.render({.camera = from_the_front, .bodies = {bar}}).pixel(100, 45)));
    bar.orientation = quarter;
    const Image upright = offscreen.render({.camera = from_the_front, .bodies = {bar}});
    CHECK(is_red(upright.pixel(80, 25)));
    CHECK_FALSE(is_red(upright.pixel(100, 45)));

    // And by 30 degrees it points up on the right: the sense of the rotation.
    bar.orientation = glm::angleAxis(glm::radians(30.0f), glm::vec3(0.0f, 0.0f, 1.0f));
    const Image tilted = offscreen.render({.camera = from_the_front, .bodies = {bar}});
    CHECK(is_red(tilted.pixel(97, 35)));
    CHECK_FALSE(is_red(tilted.pixel(97, 55)));
}

TEST_CASE("A body's shadow falls on the ground away from the sun") {
    const int width = 160;
    const int height = 120;
    OffscreenRenderer offscreen(width, height);
    for (const glm::vec3 towards_sun : {glm::vec3(-1.0f, 1.0f, 0.0f), glm::vec3(1.0f, 1.0f, 0.0f),
                                        glm::vec3(0.0f, 1.0f, 1.0f), glm::vec3(-0.5f, 0.9f, -0.65f)}) {
        Picture picture{.camera = from_above, .towards_sun = towards_sun, .ground = Ground{}};
        const Image lit = offscreen.render(picture);
        const float body_height = 3.0f;
        picture.bodies = {{.position = {0.0f, body_height, 0.0f}}};
        const Image shadowed = offscreen.render(picture);

        const glm::vec3 fall = towards_sun * (-body_height / towards_sun.y);
        const auto [x, y] = pixel_from_above(picture.camera, width, height, fall.x, fall.z);
        CHECK(brightness(shadowed, x, y) < brightness(lit, x, y) - 100);
        const auto [other_x, other_y] = pixel_from_above(picture.camera, width, height, -fall.x, -fall.z);
        CHECK(shadowed.pixel(other_x, other_y) == lit.pixel(other_x, other_y));
    }
}

TEST_CASE("The shadow of a body far above the picture still falls on the ground") {
    // The body is 40 m up and out of sight; its shadow falls 20 m beside it, where the camera looks.
    Picture picture{.camera = {.eye = {20.0f, 20.0f, 0.0f}, .target = {20.0f, 0.0f, 0.0f}},
                    .towards_sun = {-1.0f, 2.0f, 0.0f},
                    .ground = Ground{}};
    OffscreenRenderer offscreen(160, 90);
    const Image lit = offscreen.render(picture);
    picture.bodies = {{.position = {0.0f, 40.0f, 0.0f}, .shape = Box{glm::vec3(1.2f)}}};
    const Image shadowed = offscreen.render(picture);
    CHECK(brightness(shadowed, 83, 48) < brightness(lit, 83, 48) - 100);
    CHECK(shadowed.pixel(10, 10) == lit.pixel(10, 10));
}

TEST_CASE("The ground is darker right beside a body that stands on it") {
    OffscreenRenderer offscreen(160, 120);
    Picture picture{.camera = from_above, .towards_sun = {0.0f, 1.0f, 0.0f}, .ground = Ground{}};
    const Image empty = offscreen.render(picture);
    picture.bodies = {{.position = {0.0f, 1.0f, 0.0f}, .shape = Box{glm::vec3(1.0f)}}};
    const Image standing = offscreen.render(picture);
    picture.bodies[0].position.y = 4.0f;
    const Image floating = offscreen.render(picture);
    const auto [x, y] = pixel_from_above(picture.camera, 160, 120, 1.5f, 0.5f);
    CHECK(brightness(standing, x, y) < brightness(empty, x, y) - 15);
    CHECK(floating.pixel(x, y) == empty.pixel(x, y));
}

TEST_CASE("Edges are antialiased") {
    const glm::quat tilted = glm::angleAxis(0.3f, glm::vec3(0.0f, 0.0f, 1.0f));
    const Body box{.orientation = tilted, .shape = Box{glm::vec3(1.5f)}, .colour = red};
    const Image image = OffscreenRenderer(160, 90).render({.camera = from_the_front, .bodies = {box}});
    // The box has hardly any blue, the background much: in between are only pixels that show both.
    int mixed = 0;
    for (int y = 0; y < 90; ++y) {
        for (int x = 0; x < 160; ++x) mixed += image.pixel(x, y)[2] > 90 && image.pixel(x, y)[2] < 200 ? 1 : 0;
    }
    CHECK(mixed > 70);  // 96 seen; 42, on the bevels, with one sample per pixel
}

TEST_CASE("Nothing is over-exposed") {
    OffscreenRenderer offscreen(160, 90);
    for (const glm::vec3 towards_sun : {glm::vec3(0.0f, 0.0f, 1.0f), glm::vec3(-0.5f, 0.9f, 0.65f)}) {
        const glm::quat turned = glm::angleAxis(0.5f, glm::vec3(0.6f, 0.8f, 0.0f));
        const Body white{.orientation = turned, .shape = Box{glm::vec3(2.0f)}, .colour = glm::vec3(1.0f)};
        const Image image =
            offscreen.render({.camera = from_the_front, .towards_sun = towards_sun, .bodies = {white}});
        CHECK(*std::ranges::max_element(image.rgb) < 255);
    }
}

TEST_CASE("A lit face does not shadow itself") {
    const int side = 120;
    OffscreenRenderer offscreen(side, side);
    for (const float sun_height : {0.15f, 0.3f, 0.6f, 1.0f, 3.0f}) {
        const Picture picture{.camera = from_above,
                              .towards_sun = {-0.8f, sun_height, 0.6f},
                              .bodies = {{.shape = Box{glm::vec3(4.0f)}, .colour = ivory}}};
        const Image image = offscreen.render(picture);
        // Light changes slowly over the face; its own shadow would be a pattern of stripes.
        int steepest = 0;
        for (int y = 25; y < 95; ++y) {
            for (int x = 25; x < 95; ++x) {
                const int step = brightness(image, x + 1, y) - brightness(image, x, y);
                steepest = std::max(steepest, std::abs(step));
            }
        }
        CHECK(steepest <= 4);  // 2 seen
    }
}

TEST_CASE("The resting keep their shadow while others move") {
    Picture picture{.camera = from_above,
                    .ground = Ground{},
                    .bodies = {{.position = {-4.0f, 1.0f, 2.0f}}, {.position = {6.0f, 1.0f, -3.0f}}}};
    OffscreenRenderer offscreen(160, 120);
    const Image before = offscreen.render(picture);
    for (const float step : {0.013f, 0.1f, 0.7f}) {
        picture.bodies[1].position += glm::vec3(step, step, -step);
        const Image after = offscreen.render(picture);
        int largest = 0;
        for (int y = 0; y < 120; ++y) {
            for (int x = 0; x < 90; ++x)
                largest = std::max(largest, std::abs(brightness(after, x, y) - brightness(before, x, y)));
        }
        CHECK(largest <= 3);
    }
}

TEST_CASE("A body far away does not coarsen the shadows near the camera's target") {
    Picture picture{.camera = from_above, .ground = Ground{}, .bodies = {{.position = {0.0f, 2.0f, 0.0f}}}};
    OffscreenRenderer offscreen(160, 120);
    const Image before = offscreen.render(picture);
    picture.bodies.push_back({.position = {-150.0f, 1.0f, 100.0f}});
    CHECK(mean_difference(offscreen.render(picture), before) < 0.035);  // 0.031 seen
}

TEST_CASE("No horizon shows: the far ground has the colour of the background") {
    const Camera level{.eye = {0.0f, 3.0f, 20.0f}, .target = {0.0f, 3.0f, 0.0f}};
    const Image image = OffscreenRenderer(160, 120).render({.camera = level, .ground = Ground{}});
    for (int x = 0; x < 160; ++x) {
        CHECK(image.pixel(x, 60) == image.pixel(x, 0));
        for (int y = 60; y < 70; ++y) CHECK(std::abs(brightness(image, x, y + 1) - brightness(image, x, y)) < 25);
    }
}

TEST_CASE("A scene a tenth or ten times the size looks the same") {
    OffscreenRenderer offscreen(160, 90);
    const Picture picture = stack_of_cubes(4);
    const Image image = offscreen.render(picture);
    for (const float factor : {0.1f, 10.0f}) {
        Picture scaled = picture;
        scaled.camera.eye *= factor;
        scaled.camera.target *= factor;
        for (Body& body : scaled.bodies) {
            body.position *= factor;
            std::get<Box>(body.shape).half_extents *= factor;
        }
        CHECK(mean_difference(offscreen.render(scaled), image) < 0.05);
    }
}

TEST_CASE("The ground is seen from above only") {
    OffscreenRenderer offscreen(160, 90);
    const Camera below{.eye = {0.0f, -5.0f, 10.0f}, .target = glm::vec3(0.0f)};
    const std::vector<Body> boxes{{.position = {0.0f, 2.0f, 0.0f}}};
    CHECK(largest_difference(offscreen.render({.camera = below, .ground = Ground{}, .bodies = boxes}),
                             offscreen.render({.camera = below, .bodies = boxes})) == 0);
}
