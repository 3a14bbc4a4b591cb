// A picture, as renderer/README.md shows it.
#include "renderer/gl/offscreen_context.h"
#include "renderer/renderer.h"
#include "tests/catch.h"

using namespace pushfactor::renderer;

namespace {

// [example: picture]
// A ball on the ground.
Image picture_of_a_ball(const std::filesystem::path& shader_directory) {
    Picture picture;
    picture.camera = {.eye = {2.0f, 1.5f, 5.0f}, .target = {0.0f, 0.5f, 0.0f}};
    picture.ground = Ground{.height = 0.0f};
    picture.bodies.push_back({.position = {0.0f, 0.5f, 0.0f}, .shape = Sphere{0.5f}, .colour = {0.8f, 0.3f, 0.1f}});

    const auto context = open_offscreen_context();
    Renderer renderer(*context, 320, 180, shader_directory);
    return renderer.render(picture);
}
// [end]

}  // namespace

TEST_CASE("example: the ball is in the middle of the picture, and red") {
    const Image image = picture_of_a_ball(PUSHFACTOR_ASSET_DIR "/shaders");
    const auto middle = image.pixel(160, 90);
    CHECK(middle[0] > 2 * middle[2]);
    const auto corner = image.pixel(5, 175);
    CHECK(corner[0] < corner[2] + 30);  // the ground is grey
}
