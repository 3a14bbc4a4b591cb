#include "renderer/frames/frame_plan.h"

#include "renderer/picture/views.h"
#include "tests/catch.h"
#include "tests/renderer/sample_pictures.h"

#include <glm/geometric.hpp>

#include <random>
#include <vector>

using namespace pushfactor::renderer;

namespace {

constexpr int width = 320;   // pixels
constexpr int height = 180;  // pixels

// The number of areas that contain each pixel, rows from the bottom.
std::vector<int> count(const std::vector<PixelArea>& areas) {
    std::vector<int> pixels(width * height);
    for (const PixelArea& area : areas) {
        for (int y = area.y; y < area.y + area.height; ++y) {
            for (int x = area.x; x < area.x + area.width; ++x) ++pixels.at(static_cast<std::size_t>(y * width + x));
        }
    }
    return pixels;
}

glm::mat4 view_of(const Camera& camera) {
    return camera_view(camera, static_cast<float>(width) / static_cast<float>(height), 1000.0f);
}

FrameView frame_view(const Picture& picture) {
    return {.width = width,
            .height = height,
            .world_to_clip = view_of(picture.camera),
            .towards_sun = glm::normalize(picture.towards_sun),
            .texel = 0.01f,
            .pixel = 0.001f};
}

std::vector<Instance> bodies_of(const Picture& picture) {
    return visible_bodies(picture, 1e6f).all();
}

Tiles occupied(const Picture& picture) {
    return occupied_tiles(frame_view(picture), bodies_of(picture), picture.panels);
}

Tiles shadowed(const Picture& picture) {
    return shadowed_tiles(frame_view(picture), bodies_of(picture), *picture.ground);
}

// The number of points in view but in none of the counted areas.
int missed(const std::vector<int>& pixels, const glm::mat4& world_to_clip, const std::vector<glm::vec3>& points) {
    int outside = 0;
    for (const glm::vec3& point : points) {
        const glm::vec4 clip = world_to_clip * glm::vec4(point, 1.0f);
        if (clip.w <= 0.0f || std::abs(clip.x) >= clip.w || std::abs(clip.y) >= clip.w) continue;
        const auto x = static_cast<int>(0.5f * (clip.x / clip.w + 1.0f) * static_cast<float>(width));
        const auto y = static_cast<int>(0.5f * (clip.y / clip.w + 1.0f) * static_cast<float>(height));
        if (pixels.at(static_cast<std::size_t>(y * width + x)) == 0) ++outside;
    }
    return outside;
}

// Points on the surfaces of a picture's bodies.
std::vector<glm::vec3> surface_points(const Picture& picture) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> any(-1.0f, 1.0f);
    const auto direction = [&] { return glm::normalize(glm::vec3(any(random), any(random), any(random))); };
    std::vector<glm::vec3> points;
    for (int i = 0; i < 1000; ++i) {
        for (const Body& body : picture.bodies) {
            if (const auto* box = std::get_if<Box>(&body.shape)) {
                glm::vec3 corner = box->half_extents * glm::vec3(any(random), any(random), any(random));
                corner[i % 3] = i % 2 == 0 ? box->half_extents[i % 3] : -box->half_extents[i % 3];
                points.push_back(body.position + body.orientation * corner);
            }
            if (const auto* sphere = std::get_if<Sphere>(&body.shape)) {
                points.push_back(body.position + sphere->radius * direction());
            }
        }
        for (const Bar& bar : picture.bars) {
            const float part = 0.5f * (any(random) + 1.0f);
            points.push_back(bar.from + part * (bar.to - bar.from) + bar.radius * direction());
        }
    }
    return points;
}

}  // namespace

TEST_CASE("A plan has each pixel of the tiles once, and shadows are looked up only where some may be") {
    for (const Picture& picture : {all_kinds(), stack_of_cubes(1), Picture{.camera = {}, .ground = Ground{}}}) {
        Tiles all(width, height);
        all.add_all();
        for (const Tiles& drawn : {all, occupied(picture)}) {
            const FramePlan plan = plan_frame(drawn, shadowed(picture));
            const std::vector<int> lit = count(plan.lit);
            const std::vector<int> dark = count(plan.shadowed);
            const std::vector<int> wanted = count(drawn.areas());
            const std::vector<int> reached = count(shadowed(picture).areas());
            int wrong = 0;
            for (std::size_t i = 0; i < lit.size(); ++i) {
                wrong += lit[i] + dark[i] == wanted[i] && dark[i] <= reached[i] ? 0 : 1;
            }
            CHECK(wrong == 0);
        }
    }
    CHECK(shadowed({.camera = {}, .ground = Ground{}}).none());
    CHECK(std::ranges::count(count(occupied(stack_of_cubes(2)).areas()), 1) < width * height / 4);
    CHECK(std::ranges::count(count(shadowed(stack_of_cubes(2)).areas()), 1) < width * height / 4);
}

TEST_CASE("Tiles that form a rectangle are one area") {
    Tiles tiles(width, height);
    tiles.add_all();
    CHECK(tiles.areas() == std::vector<PixelArea>{{0, 0, width, height}});
}

TEST_CASE("All that is seen of bodies and of their shadows is in the tiles for it") {
    for (const glm::vec3 eye : {glm::vec3(11.0f, 12.0f, 24.0f), glm::vec3(0.0f, 3.0f, 4.0f),
                                glm::vec3(-2.0f, 0.5f, 1.0f), glm::vec3(0.0f, 90.0f, 0.0f)}) {
        Picture picture = all_kinds();
        picture.camera = {.eye = eye, .target = {1.0f, 2.0f, 0.0f}};
        picture.bodies.push_back({.position = {0.0f, 9.0f, 0.0f},
                                  .orientation = glm::angleAxis(0.7f, glm::vec3(0.6f, 0.0f, 0.8f)),
                                  .shape = Box{{6.0f, 0.1f, 0.4f}}});
        const std::vector<glm::vec3> points = surface_points(picture);
        const glm::mat4 world_to_clip = view_of(picture.camera);
        for (const glm::vec3 towards_sun : {picture.towards_sun, glm::vec3(1.0f, 0.15f, -0.3f)}) {
            picture.towards_sun = towards_sun;
            const std::vector<int> seen = count(occupied(picture).areas());
            CHECK(missed(seen, world_to_clip, points) == 0);
            for (const Panel& panel : picture.panels) CHECK(missed(seen, world_to_clip, panel.corners) == 0);

            std::vector<glm::vec3> shadows, passed;
            for (const glm::vec3& point : points) {
                shadows.push_back(point - point.y / towards_sun.y * towards_sun);
                for (const float part : {0.0f, 0.13f, 0.6f, 1.0f}) {
                    passed.push_back(point - 15.0f * part * glm::normalize(towards_sun));
                }
            }
            CHECK(missed(count(shadowed(picture).areas()), world_to_clip, shadows) == 0);
            const Tiles swept = swept_tiles(frame_view(picture), bodies_of(picture), 15.0f);
            CHECK(missed(count(swept.areas()), world_to_clip, passed) == 0);
        }
    }
}

TEST_CASE("Tiles know their neighbours and whether they show a ball") {
    Tiles tiles(width, height);
    const glm::mat4 world_to_clip = view_of(from_the_front);
    tiles.add_ball(world_to_clip, glm::vec3(0.0f), 0.1f);
    CHECK(tiles.has(width / 2 / Tiles::side, height / 2 / Tiles::side));
    CHECK_FALSE(tiles.has(1, 1));
    CHECK(tiles.show_ball(world_to_clip, glm::vec3(0.0f), 0.2f));
    CHECK_FALSE(tiles.show_ball(world_to_clip, glm::vec3(4.0f, 0.0f, 0.0f), 0.2f));
    const Tiles grown = tiles.with_neighbours();
    for (int row = 0; row < tiles.rows(); ++row) {
        for (int column = 0; column < tiles.columns(); ++column) {
            bool beside = false;
            for (int i = -1; i <= 1; ++i) {
                for (int k = -1; k <= 1; ++k) {
                    const bool inside =
                        column + i >= 0 && column + i < tiles.columns() && row + k >= 0 && row + k < tiles.rows();
                    beside = beside || (inside && tiles.has(column + i, row + k));
                }
            }
            CHECK(grown.has(column, row) == beside);
        }
    }
}

TEST_CASE("Around and behind the eye a body may be anywhere or nowhere") {
    Tiles tiles(width, height);
    const glm::mat4 world_to_clip = view_of(from_the_front);
    tiles.add_ball(world_to_clip, from_the_front.eye + glm::vec3(0.0f, 0.0f, 3.0f), 2.0f);
    CHECK_FALSE(tiles.has(5, 3));
    tiles.add_ball(world_to_clip, glm::vec3(1e6f, 0.0f, 0.0f), 2.0f);
    CHECK_FALSE(tiles.has(tiles.columns() - 1, tiles.rows() / 2));
    tiles.add_ball(world_to_clip, from_the_front.eye, 2.0f);
    CHECK(tiles.has(0, 0));
    CHECK(tiles.has(tiles.columns() - 1, tiles.rows() - 1));
}
