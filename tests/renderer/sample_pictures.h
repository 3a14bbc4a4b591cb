// Pictures for the tests of the renderer, and queries of images.
#pragma once

#include "renderer/gl/offscreen_context.h"
#include "renderer/picture/picture.h"
#include "renderer/renderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <utility>

namespace pushfactor::renderer {

inline const std::filesystem::path shader_directory = std::filesystem::path(PUSHFACTOR_ASSET_DIR) / "shaders";

inline const glm::vec3 red{0.9f, 0.1f, 0.1f};
inline const glm::vec3 blue{0.1f, 0.2f, 0.9f};
inline const glm::vec3 ivory{0.88f, 0.85f, 0.78f};

inline const Camera from_the_front{.eye = {0.0f, 0.0f, 10.0f}, .target = glm::vec3(0.0f)};
inline const Camera from_above{.eye = {0.0f, 20.0f, 0.0f}, .target = glm::vec3(0.0f)};

// A renderer with a context of its own.
class OffscreenRenderer {
  public:
    OffscreenRenderer(int width, int height, int samples = 1)
        : renderer_(*context_, width, height, shader_directory, samples) {}

    Image render(const Picture& picture) { return renderer_.render(picture); }

    // The background of every picture. An empty picture is refused.
    Image background() {
        Image image = render({.camera = from_the_front, .bodies = {{}}});
        const auto corner = image.pixel(0, 0);
        for (std::size_t i = 0; i < image.rgb.size(); ++i) image.rgb[i] = corner[i % 3];
        return image;
    }

  private:
    std::unique_ptr<OffscreenContext> context_ = open_offscreen_context();
    Renderer renderer_;
};

// Cubes with sides of 2.4 m, each a little turned, on the ground.
inline Picture stack_of_cubes(int count) {
    Picture picture{.camera = {.eye = {11.0f, 12.0f, 24.0f}, .target = {0.0f, 5.0f, 0.0f}}, .ground = Ground{}};
    for (int i = 0; i < count; ++i) {
        const auto level = static_cast<float>(i);
        picture.bodies.push_back({.position = {0.0f, 1.2f + 2.4f * level, 0.0f},
                                  .orientation = glm::angleAxis(0.1f * level, glm::vec3(0.0f, 1.0f, 0.0f)),
                                  .shape = Box{glm::vec3(1.2f)},
                                  .colour = i % 2 == 0 ? red : ivory});
    }
    return picture;
}

// A wedge: a triangle and what it is on one side of, 1 m wide.
inline std::shared_ptr<const ConvexShape> wedge() {
    return std::make_shared<const ConvexShape>(
        ConvexShape{.corners = {{-0.9f, -0.5f, -0.5f},
                                {0.9f, -0.5f, -0.5f},
                                {0.2f, 0.9f, -0.5f},
                                {-0.9f, -0.5f, 0.5f},
                                {0.9f, -0.5f, 0.5f},
                                {0.2f, 0.9f, 0.5f}},
                    .faces = {{0, 2, 1}, {3, 4, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}}});
}

inline bool is_sphere(const Body& body) {
    return std::holds_alternative<Sphere>(body.shape);
}

// A little of everything: a funnel with balls in it, boxes, wedges, and a pendulum.
inline Picture all_kinds() {
    Picture picture = stack_of_cubes(3);
    for (int i = 0; i < 6; ++i) {
        const auto step = static_cast<float>(i);
        picture.bodies.push_back({.position = {4.0f + 0.3f * step, 1.0f + 0.9f * step, 0.4f * step - 1.0f},
                                  .orientation = glm::angleAxis(step, glm::vec3(0.6f, 0.8f, 0.0f)),
                                  .shape = Sphere{},
                                  .colour = i % 2 == 0 ? blue : ivory});
    }
    picture.bodies.push_back({.position = {-5.0f, 2.0f, 2.0f}, .shape = Sphere{0.8f}, .colour = red});
    const auto shape = wedge();
    picture.bodies.push_back({.position = {-3.0f, 0.5f, 4.5f}, .shape = shape, .colour = ivory});
    picture.bodies.push_back({.position = {-4.5f, 6.0f, -2.0f},
                              .orientation = glm::angleAxis(0.8f, glm::vec3(0.6f, 0.0f, 0.8f)),
                              .shape = shape,
                              .colour = blue});
    picture.bars.push_back({.from = {-4.0f, 8.0f, 2.0f}, .to = {-5.0f, 2.0f, 2.0f}});
    const glm::vec3 apex(5.0f, 0.0f, 0.0f);
    const glm::vec3 corners[] = {{2.0f, 6.0f, -3.0f}, {2.0f, 6.0f, 3.0f}, {8.0f, 6.0f, 3.0f}, {8.0f, 6.0f, -3.0f}};
    for (int i = 0; i < 4; ++i) picture.panels.push_back({.corners = {apex, corners[(i + 1) % 4], corners[i]}});
    return picture;
}

// Where the camera `from_the_front` sees a point, pixels.
inline std::pair<int, int> pixel_from_the_front(int width, int height, const glm::vec3& point) {
    const float half_angle = glm::radians(0.5f * from_the_front.vertical_field_of_view_degrees);
    const float pixels_per_metre =
        0.5f * static_cast<float>(height) / ((from_the_front.eye.z - point.z) * std::tan(half_angle));
    return {static_cast<int>(0.5f * static_cast<float>(width) + point.x * pixels_per_metre),
            static_cast<int>(0.5f * static_cast<float>(height) - point.y * pixels_per_metre)};
}

// Where a camera that looks straight down onto (0, 0, 0) sees a point of the ground, pixels; x is right, -z
// is up.
inline std::pair<int, int> pixel_from_above(const Camera& camera, int width, int height, float x, float z) {
    const float half_angle = glm::radians(0.5f * camera.vertical_field_of_view_degrees);
    const float pixels_per_metre = 0.5f * static_cast<float>(height) / (camera.eye.y * std::tan(half_angle));
    return {static_cast<int>(0.5f * static_cast<float>(width) + x * pixels_per_metre),
            static_cast<int>(0.5f * static_cast<float>(height) + z * pixels_per_metre)};
}

using Pixel = std::array<std::uint8_t, 3>;

inline bool is_red(const Pixel& pixel) {
    return pixel[0] > 120 && pixel[1] < 100 && pixel[2] < 100;
}
inline bool is_blue(const Pixel& pixel) {
    return pixel[2] > 120 && pixel[0] < 100;
}

// The largest difference of any channel of two images of the same size.
inline int largest_difference(const Image& a, const Image& b) {
    int largest = 0;
    for (std::size_t i = 0; i < a.rgb.size(); ++i) largest = std::max(largest, std::abs(a.rgb[i] - b.rgb[i]));
    return largest;
}

// Sum of the channels, 0..765.
inline int brightness(const Image& image, int x, int y) {
    const auto [r, g, b] = image.pixel(x, y);
    return r + g + b;
}

}  // namespace pushfactor::renderer
