// What the tests of the renderer draw, and how they look at it.
#pragma once

#include "renderer/offscreen_context.h"
#include "renderer/picture.h"
#include "renderer/renderer.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <utility>

namespace pushfactor::renderer {

inline const std::filesystem::path shader_directory = std::filesystem::path(PUSHFACTOR_ASSET_DIR) / "shaders";

inline const glm::vec3 red{0.9f, 0.1f, 0.1f};
inline const glm::vec3 blue{0.1f, 0.2f, 0.9f};
inline const glm::vec3 ivory{0.88f, 0.85f, 0.78f};

// A renderer with a context of its own.
class Studio {
  public:
    Studio(int width, int height) : renderer_(*context_, width, height, shader_directory) {}

    Image render(const Picture& picture) { return renderer_.render(picture); }

  private:
    std::unique_ptr<OffscreenContext> context_ = open_offscreen_context();
    Renderer renderer_;
};

// Cubes with sides of 2.4 m, each a little turned, on the ground.
inline Picture stack_of_cubes(int count) {
    Picture picture{.camera = {.eye = {11.0f, 12.0f, 24.0f}, .target = {0.0f, 5.0f, 0.0f}}, .ground = Ground{}};
    for (int i = 0; i < count; ++i) {
        const auto level = static_cast<float>(i);
        picture.boxes.push_back({.position = {0.0f, 1.2f + 2.4f * level, 0.0f},
                                 .orientation = glm::angleAxis(0.1f * level, glm::vec3(0.0f, 1.0f, 0.0f)),
                                 .half_extents = glm::vec3(1.2f),
                                 .colour = i % 2 == 0 ? red : ivory});
    }
    return picture;
}

// Where a camera that looks straight down onto (0, 0, 0) sees a point of the ground, pixels; x is right, -z
// is up.
inline std::pair<int, int> pixel_from_above(const Camera& camera, int width, int height, float x, float z) {
    const float half_angle = glm::radians(0.5f * camera.vertical_field_of_view_degrees);
    const float pixels_per_metre = 0.5f * static_cast<float>(height) / (camera.eye.y * std::tan(half_angle));
    return {static_cast<int>(0.5f * static_cast<float>(width) + x * pixels_per_metre),
            static_cast<int>(0.5f * static_cast<float>(height) + z * pixels_per_metre)};
}

// Sum of the channels, 0..765.
inline int brightness(const Image& image, int x, int y) {
    const auto [r, g, b] = image.pixel(x, y);
    return r + g + b;
}

}  // namespace pushfactor::renderer
