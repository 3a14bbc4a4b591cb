#include "renderer/renderer.h"

#include "renderer/base/renderer_error.h"
#include "tests/catch.h"
#include "tests/renderer/sample_pictures.h"

#include <array>
#include <cstdint>
#include <fstream>

using namespace pushfactor::renderer;
using Catch::Contains;

TEST_CASE("The same picture gives the same bytes, whatever was drawn in between") {
    OffscreenRenderer offscreen(160, 90);
    const Image first = offscreen.render(stack_of_cubes(5));

    Picture other = stack_of_cubes(40);
    other.camera.eye *= 3.0f;
    other.towards_sun = {1.0f, 1.0f, 0.0f};
    other.ground.reset();
    CHECK(offscreen.render(other) != first);
    CHECK(offscreen.render(all_kinds()) != first);
    CHECK(offscreen.render(stack_of_cubes(5)) == first);
}

TEST_CASE("A fresh context gives the same bytes") {
    const Image first = OffscreenRenderer(160, 90).render(stack_of_cubes(5));
    CHECK(OffscreenRenderer(160, 90).render(stack_of_cubes(5)) == first);
}

TEST_CASE("A picture of all kinds gives the same bytes again, and in a fresh context") {
    OffscreenRenderer offscreen(160, 90);
    const Image first = offscreen.render(all_kinds());
    CHECK(offscreen.render(stack_of_cubes(3)) != first);
    CHECK(offscreen.render(all_kinds()) == first);
    CHECK(OffscreenRenderer(160, 90).render(all_kinds()) == first);
}

TEST_CASE("Spheres, bars and panels leave nothing behind for the next picture") {
    OffscreenRenderer offscreen(160, 90);
    const Image first = offscreen.render(stack_of_cubes(5));
    offscreen.render(all_kinds());
    CHECK(offscreen.render(stack_of_cubes(5)) == first);
}

TEST_CASE("Renderers that live at the same time do not disturb each other") {
    OffscreenRenderer wide(160, 90);
    const Image alone = wide.render(stack_of_cubes(5));
    OffscreenRenderer square(64, 64);
    const Image small = square.render(stack_of_cubes(2));
    CHECK(wide.render(stack_of_cubes(5)) == alone);
    CHECK(square.render(stack_of_cubes(2)) == small);
}

TEST_CASE("Two renderers may share a context") {
    const auto context = open_offscreen_context();
    Renderer wide(*context, 160, 90, shader_directory);
    const Image alone = wide.render(stack_of_cubes(5));
    Renderer(*context, 32, 32, shader_directory).render(stack_of_cubes(2));
    CHECK(wide.render(stack_of_cubes(5)) == alone);
}

TEST_CASE("A body thrown out of sight changes nothing") {
    OffscreenRenderer offscreen(160, 90);
    Picture picture = stack_of_cubes(3);
    const Image before = offscreen.render(picture);
    for (const float far : {1e4f, 1e20f, 1e38f}) {
        picture.bodies.push_back({.position = {far, -far, far}});
        picture.bodies.push_back({.position = {far, -far, far}, .shape = Sphere{}});
        picture.bars.push_back({.from = {far, -far, far}, .to = {far, far, far}});
        CHECK(offscreen.render(picture) == before);
    }
}

TEST_CASE("The image has the size that was asked for") {
    for (const auto& [width, height] : {std::pair{1, 1}, std::pair{3, 200}, std::pair{Renderer::max_side, 2}}) {
        const Image image = OffscreenRenderer(width, height).render(stack_of_cubes(1));
        CHECK(image.width == width);
        CHECK(image.height == height);
        CHECK(image.rgb.size() == static_cast<std::size_t>(3 * width * height));
    }
}

TEST_CASE("Sizes that are empty or too large are refused") {
    const auto context = open_offscreen_context();
    for (const auto& [width, height] :
         {std::pair{0, 90}, std::pair{160, 0}, std::pair{-160, 90}, std::pair{Renderer::max_side + 1, 90},
          std::pair{160, Renderer::max_side + 1}}) {
        CHECK_THROWS_AS(Renderer(*context, width, height, shader_directory), RendererError);
    }
}

TEST_CASE("A missing shader is named") {
    const auto context = open_offscreen_context();
    CHECK_THROWS_AS(Renderer(*context, 8, 8, "no/such/folder"), RendererError);
    CHECK_THROWS_WITH(Renderer(*context, 8, 8, "no/such/folder"), Contains("no/such/folder/body.vert"));
}

TEST_CASE("A shader that does not compile is named, with the compiler's message") {
    namespace fs = std::filesystem;
    const fs::path copy = fs::temp_directory_path() / "pushfactor_broken_shaders";
    fs::remove_all(copy);
    fs::copy(shader_directory, copy);
    std::ofstream(copy / "ground.frag") << "#version 330 core\nvoid main() { unheard_of = 1.0; }\n";

    const auto context = open_offscreen_context();
    CHECK_THROWS_WITH(Renderer(*context, 8, 8, copy), Contains("ground.frag") && Contains("unheard_of"));

    std::ofstream(copy / "ground.frag") << "#version 330 core\nvoid missing();\nvoid main() { missing(); }\n";
    CHECK_THROWS_WITH(Renderer(*context, 8, 8, copy), Contains("ground.frag") && Contains("missing"));
    fs::remove_all(copy);
}
