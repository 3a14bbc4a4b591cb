#include "renderer/frame_plan.h"

#include "renderer/views.h"
#include "tests/catch.h"
#include "tests/renderer/sample_pictures.h"

#include <glm/geometric.hpp>

#include <random>
#include <vector>

using namespace pushfactor::renderer;

namespace {

constexpr int width = 320;   // pixels
constexpr int height = 180;  // pixels

// What a plan says of each pixel, rows from the bottom: how often it is in each kind of part.
struct Counts {
    std::vector<int> bare = std::vector<int>(width * height);
    std::vector<int> edged = std::vector<int>(width * height);
    std::vector<int> shadowed = std::vector<int>(width * height);
};

void count(std::vector<int>& pixels, const std::vector<Rectangle>& parts) {
    for (const Rectangle& part : parts) {
        for (int y = part.y; y < part.y + part.height; ++y) {
            for (int x = part.x; x < part.x + part.width; ++x) ++pixels.at(static_cast<std::size_t>(y * width + x));
        }
    }
}

Counts counts_of(const FramePlan& plan) {
    Counts counts;
    for (const auto* parts : {&plan.bare.lit, &plan.bare.shadowed}) count(counts.bare, *parts);
    for (const auto* parts : {&plan.edged.lit, &plan.edged.shadowed}) count(counts.edged, *parts);
    for (const auto* parts : {&plan.bare.shadowed, &plan.edged.shadowed}) count(counts.shadowed, *parts);
    return counts;
}

glm::mat4 view_of(const Camera& camera) {
    return camera_view(camera, static_cast<float>(width) / static_cast<float>(height), 1000.0f);
}

FramePlan plan_of(const Picture& picture) {
    return plan_frame(width, height, view_of(picture.camera), visible_bodies(picture, 1e6f), picture,
                      glm::normalize(picture.towards_sun), 0.01f);
}

// How many of the points are in view but in none of the counted parts.
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
        for (const Box& box : picture.boxes) {
            glm::vec3 corner = box.half_extents * glm::vec3(any(random), any(random), any(random));
            corner[i % 3] = i % 2 == 0 ? box.half_extents[i % 3] : -box.half_extents[i % 3];
            points.push_back(box.position + box.orientation * corner);
        }
        for (const Sphere& sphere : picture.spheres)
            points.push_back(sphere.position + sphere.radius * direction());
        for (const Bar& bar : picture.bars) {
            const float part = 0.5f * (any(random) + 1.0f);
            points.push_back(bar.from + part * (bar.to - bar.from) + bar.radius * direction());
        }
    }
    return points;
}

}  // namespace

TEST_CASE("A frame's plan has each pixel once, and few of them where little is to be seen") {
    for (const Picture& picture :
         {all_kinds(), stack_of_cubes(1), Picture{.camera = {}, .ground = Ground{}}, Picture{}}) {
        const Counts counts = counts_of(plan_of(picture));
        int wrong = 0;
        for (std::size_t i = 0; i < counts.bare.size(); ++i) wrong += counts.bare[i] + counts.edged[i] == 1 ? 0 : 1;
        CHECK(wrong == 0);
    }
    CHECK(plan_of({.camera = {}, .ground = Ground{}}).edged.lit.empty());
    CHECK(plan_of({.camera = {}, .ground = Ground{}}).bare.shadowed.empty());
    const Counts counts = counts_of(plan_of(stack_of_cubes(2)));
    CHECK(std::ranges::count(counts.edged, 1) < width * height / 4);
    CHECK(std::ranges::count(counts.shadowed, 1) < width * height / 4);
}

TEST_CASE("All that is seen of bodies and of their shadows is in the parts for it") {
    for (const glm::vec3 eye : {glm::vec3(11.0f, 12.0f, 24.0f), glm::vec3(0.0f, 3.0f, 4.0f),
                                glm::vec3(-2.0f, 0.5f, 1.0f), glm::vec3(0.0f, 90.0f, 0.0f)}) {
        Picture picture = all_kinds();
        picture.camera = {.eye = eye, .target = {1.0f, 2.0f, 0.0f}};
        picture.boxes.push_back({.position = {0.0f, 9.0f, 0.0f},
                                 .orientation = glm::angleAxis(0.7f, glm::vec3(0.6f, 0.0f, 0.8f)),
                                 .half_extents = {6.0f, 0.1f, 0.4f}});
        const std::vector<glm::vec3> points = surface_points(picture);
        const glm::mat4 world_to_clip = view_of(picture.camera);
        for (const glm::vec3 towards_sun : {picture.towards_sun, glm::vec3(1.0f, 0.15f, -0.3f)}) {
            picture.towards_sun = towards_sun;
            const Counts counts = counts_of(plan_of(picture));
            CHECK(missed(counts.edged, world_to_clip, points) == 0);
            std::vector<glm::vec3> shadows;
            for (const glm::vec3& point : points) shadows.push_back(point - point.y / towards_sun.y * towards_sun);
            CHECK(missed(counts.shadowed, world_to_clip, shadows) == 0);
            for (const Panel& panel : picture.panels)
                CHECK(missed(counts.edged, world_to_clip, panel.corners) == 0);
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
