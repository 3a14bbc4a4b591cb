// The look of spheres in a frame.
#include "renderer/renderer.h"
#include "tests/catch.h"
#include "tests/renderer/sample_pictures.h"

using namespace pushfactor::renderer;

namespace {

constexpr int width = 640;   // pixels
constexpr int height = 360;  // pixels

// The image position of a point on a ball of 1 m at the origin, seen from the front: at this angle from the right,
// half way out to the outline.
std::pair<int, int> on_the_ball(float degrees) {
    const float angle = glm::radians(degrees);
    return pixel_from_the_front(width, height, {0.5f * std::cos(angle), 0.5f * std::sin(angle), 0.85f});
}

int brightness(const Image& image, const std::pair<int, int>& pixel) {
    return brightness(image, pixel.first, pixel.second);
}

}  // namespace

TEST_CASE("A sphere's outline is a circle of the right size, near and far") {
    OffscreenRenderer offscreen(width, height);
    const Image empty = offscreen.background();
    for (const float radius : {0.1f, 0.16f, 0.3f, 0.45f, 0.8f, 1.15f, 2.0f, 4.0f}) {
        INFO("radius " << radius << " m");
        const Image image =
            offscreen.render({.camera = from_the_front, .bodies = {{.shape = Sphere{radius}, .colour = red}}});
        // Lines of sight touch the sphere at an angle whose sine is radius over distance.
        const float distance = from_the_front.eye.z;
        const float half_angle = glm::radians(0.5f * from_the_front.vertical_field_of_view_degrees);
        const float outline = 0.5f * static_cast<float>(height) / std::tan(half_angle) * radius /
                              std::sqrt(distance * distance - radius * radius);
        int wrong = 0;
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                const float from_centre =
                    std::hypot(static_cast<float>(x - width / 2) + 0.5f, static_cast<float>(y - height / 2) + 0.5f);
                const bool seen = image.pixel(x, y) != empty.pixel(x, y);
                if (from_centre < outline - 1.0f && !seen) ++wrong;
                if (from_centre > outline + 1.0f && seen) ++wrong;
            }
        }
        CHECK(wrong == 0);
    }
}

TEST_CASE("A sphere's pattern turns with its quaternion") {
    OffscreenRenderer offscreen(width, height);
    const auto turned = [&](float degrees, const glm::vec3& axis) {
        const glm::quat turn = glm::angleAxis(glm::radians(degrees), axis);
        return offscreen.render(
            {.camera = from_the_front,
             .bodies = {{.orientation = turn, .shape = Sphere{1.0f}, .colour = glm::vec3(0.5f)}}});
    };
    const glm::vec3 z(0.0f, 0.0f, 1.0f);
    const Image straight = turned(0.0f, z);
    const Image quarter = turned(90.0f, z);
    // Light where x y z > 0.
    CHECK(brightness(straight, on_the_ball(45.0f)) > brightness(quarter, on_the_ball(45.0f)) + 40);
    CHECK(brightness(straight, on_the_ball(135.0f)) < brightness(quarter, on_the_ball(135.0f)) - 40);
    CHECK(brightness(straight, on_the_ball(225.0f)) > brightness(quarter, on_the_ball(225.0f)) + 25);

    // The sense of rotation: the light octant that starts at the right moves up, or down.
    CHECK(brightness(turned(-30.0f, z), on_the_ball(15.0f)) >
          brightness(turned(30.0f, z), on_the_ball(15.0f)) + 40);
    // About the vertical: what was left of the middle stays left, or what was right of it moves there.
    const glm::vec3 y(0.0f, 1.0f, 0.0f);
    const auto left_of_middle = pixel_from_the_front(width, height, {-0.25f, -0.4f, 0.88f});
    CHECK(brightness(turned(40.0f, y), left_of_middle) > brightness(turned(-40.0f, y), left_of_middle) + 40);
}

TEST_CASE("A sphere looks as round from the side and from straight above as from the front") {
    OffscreenRenderer offscreen(width, height);
    const auto covered = [&](const glm::vec3& eye) {
        const Camera camera{.eye = eye, .target = glm::vec3(0.0f)};
        const Image empty = offscreen.background();
        const Image image =
            offscreen.render({.camera = camera, .bodies = {{.shape = Sphere{1.0f}, .colour = red}}});
        int count = 0;
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) count += image.pixel(x, y) != empty.pixel(x, y) ? 1 : 0;
        }
        return count;
    };
    const int from_front = covered({0.0f, 0.0f, 10.0f});
    for (const glm::vec3 eye :
         {glm::vec3(10.0f, 0.0f, 0.0f), glm::vec3(0.0f, 10.0f, 0.0f), glm::vec3(0.0f, -10.0f, 0.0f),
          glm::vec3(0.0f, 0.0f, -10.0f), glm::vec3(0.0f, 8.0f, 6.0f)}) {
        CHECK(covered(eye) == Approx(from_front).epsilon(0.02));
    }
}

TEST_CASE("A sphere shadows the ground and what is on it, and is shadowed") {
    OffscreenRenderer offscreen(160, 120);
    Picture picture{.camera = from_above,
                    .towards_sun = {-1.0f, 1.0f, 0.0f},
                    .ground = Ground{},
                    .bodies = {{.position = {4.0f, 1.0f, 0.0f}, .shape = Sphere{1.0f}, .colour = ivory}}};
    const Image lit = offscreen.render(picture);
    picture.bodies.push_back({.position = {0.0f, 5.0f, 0.0f}, .shape = Sphere{1.0f}, .colour = red});
    picture.bodies.push_back({.position = {-6.0f, 3.0f, 4.0f}, .shape = Sphere{0.5f}, .colour = red});
    const Image shadowed = offscreen.render(picture);
    const auto [ball_x, ball_y] = pixel_from_above(picture.camera, 160, 120, 4.2f, 0.0f);
    CHECK(brightness(shadowed, ball_x, ball_y) < brightness(lit, ball_x, ball_y) - 100);
    const auto [x, y] = pixel_from_above(picture.camera, 160, 120, -3.0f, 4.0f);
    CHECK(brightness(shadowed, x, y) < brightness(lit, x, y) - 100);
    // The shadow is as wide as the ball.
    const auto [outside_x, outside_y] = pixel_from_above(picture.camera, 160, 120, -3.0f, 5.2f);
    CHECK(shadowed.pixel(outside_x, outside_y) == lit.pixel(outside_x, outside_y));
}

TEST_CASE("A sphere has no pattern of its own shadow, up to where the light ends") {
    OffscreenRenderer offscreen(width, height);
    for (const float radius : {1.0f, 1.5f}) {
        const Image image =
            offscreen.render({.camera = from_the_front, .bodies = {{.shape = Sphere{radius}, .colour = ivory}}});
        const float seen = 0.85f * radius * 52.0f;  // pixels, of the outline's radius
        int roughest = 0;
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                const auto right = static_cast<float>(x - width / 2);
                const auto down = static_cast<float>(y - height / 2);
                const bool beside_octants = std::abs(right) < 3.0f || std::abs(down) < 3.0f;
                if (beside_octants || std::hypot(right, down) > seen) continue;
                const int bend =
                    brightness(image, x - 1, y) - 2 * brightness(image, x, y) + brightness(image, x + 1, y);
                roughest = std::max(roughest, std::abs(bend));
            }
        }
        INFO("radius " << radius << " m");
        CHECK(roughest <= 16);  // 12 seen; 24 with a point on the triangle
    }
}

TEST_CASE("The ground is darker around the point where a sphere touches it") {
    OffscreenRenderer offscreen(160, 120);
    Picture picture{.camera = from_above, .towards_sun = {0.0f, 1.0f, 0.0f}, .ground = Ground{}};
    const Image empty = offscreen.render(picture);
    picture.bodies = {{.position = {0.0f, 2.0f, 0.0f}, .shape = Sphere{2.0f}}};
    const Image standing = offscreen.render(picture);
    picture.bodies[0].position.y = 8.0f;
    const Image floating = offscreen.render(picture);
    const auto [x, y] = pixel_from_above(picture.camera, 160, 120, 2.4f, 0.3f);
    CHECK(brightness(standing, x, y) < brightness(empty, x, y) - 10);
    const auto [far_x, far_y] = pixel_from_above(picture.camera, 160, 120, 4.5f, 0.3f);
    CHECK(standing.pixel(far_x, far_y) == empty.pixel(far_x, far_y));
    CHECK(floating.pixel(far_x, far_y) == empty.pixel(far_x, far_y));
}
