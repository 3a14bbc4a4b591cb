// The pictures whose golden images are in assets/golden.
#pragma once

#include "renderer/images/png.h"
#include "tests/renderer/sample_pictures.h"

#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace pushfactor::renderer::golden {

namespace fs = std::filesystem;

inline constexpr int width = 320;   // pixels
inline constexpr int height = 180;  // pixels

struct Sample {
    std::string name;
    Picture picture;
    int samples = 1;
};

// A row of balls of several sizes on thin bars, as pendulums hang.
inline Picture pendulums() {
    Picture picture{.camera = {.eye = {7.0f, 5.0f, 15.0f}, .target = {0.0f, 2.5f, 0.0f}}, .ground = Ground{}};
    for (int i = 0; i < 9; ++i) {
        const auto step = static_cast<float>(i);
        const float angle = 0.25f * step - 1.0f;
        const glm::vec3 pivot(1.3f * step - 5.2f, 5.5f, 0.0f);
        const glm::vec3 ball = pivot + (3.0f + 0.2f * step) * glm::vec3(0.0f, -std::cos(angle), std::sin(angle));
        picture.bars.push_back({.from = pivot, .to = ball, .radius = 0.004f * step});
        picture.bodies.push_back({.position = ball,
                                  .orientation = glm::angleAxis(angle, glm::vec3(1.0f, 0.0f, 0.0f)),
                                  .shape = Sphere{0.2f + 0.05f * step},
                                  .colour = i % 3 == 0   ? red
                                            : i % 3 == 1 ? blue
                                                         : ivory});
    }
    return picture;
}

// The panels and balls of all_kinds() alone, from above, without a ground.
inline Picture funnel() {
    Picture picture = all_kinds();
    picture.ground.reset();
    std::erase_if(picture.bodies, [](const Body& body) { return !is_sphere(body); });
    picture.bars.clear();
    picture.camera = {.eye = {8.0f, 14.0f, 12.0f}, .target = {5.0f, 3.0f, 0.0f}};
    return picture;
}

inline std::vector<Sample> samples() {
    return {{.name = "cubes", .picture = stack_of_cubes(5)},
            {.name = "pendulums", .picture = pendulums()},
            {.name = "funnel", .picture = funnel()},
            {.name = "all_kinds", .picture = all_kinds()},
            {.name = "still", .picture = all_kinds(), .samples = 16}};
}

inline fs::path golden_file(const Sample& sample) {
    return fs::path(PUSHFACTOR_ASSET_DIR) / "golden" / (sample.name + ".png");
}

inline void write_image(const fs::path& file, const Image& image) {
    fs::create_directories(file.parent_path());
    const std::vector<std::uint8_t> png = encode_png(image);
    std::ofstream stream(file, std::ios::binary);
    stream.write(reinterpret_cast<const char*>(png.data()), static_cast<std::streamsize>(png.size()));
    if (!stream.good()) throw std::runtime_error(file.string() + " could not be written");
}

}  // namespace pushfactor::renderer::golden
