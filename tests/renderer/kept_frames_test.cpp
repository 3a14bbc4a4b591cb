// Reuse of the previous frame must not be visible: every frame of a run is byte for byte the one that a new
// renderer draws.
#include "renderer/frames/stages.h"
#include "renderer/renderer.h"
#include "tests/catch.h"
#include "tests/renderer/sample_pictures.h"

#include <glm/geometric.hpp>

#include <functional>
#include <random>
#include <set>
#include <vector>

using namespace pushfactor::renderer;

namespace {

constexpr int width = 240;   // pixels
constexpr int height = 150;  // pixels

// The frames that differ when nothing of the previous frame can be reused: between them the other renderer draws
// something else, from another viewpoint.
std::set<int> frames_that_differ(int count, const std::function<Picture(int)>& picture, int samples = 1) {
    OffscreenRenderer film(width, height, samples);
    OffscreenRenderer afresh(width, height, samples);
    std::set<int> differ;
    for (int frame = 0; frame < count; ++frame) {
        afresh.render({.camera = from_the_front, .bodies = {{}}});
        if (film.render(picture(frame)) != afresh.render(picture(frame))) differ.insert(frame);
    }
    return differ;
}

const std::set<int> none;

// Something of everything, and in front of it a slab that shadows the rest when it is moved.
Picture crowd() {
    Picture picture = all_kinds();
    picture.bodies.push_back({.position = {-3.0f, 9.0f, 4.0f}, .shape = Box{{2.0f, 0.1f, 1.0f}}, .colour = blue});
    return picture;
}

// Counts how often something was drawn.
class Counter final : public Stages {
  public:
    void end(Stage stage) override { drawn_ += stage == Stage::bodies ? 1 : 0; }
    int drawn() const { return drawn_; }

  private:
    int drawn_ = 0;
};

}  // namespace

TEST_CASE("A polyhedron that moves and turns, then another shape in its place") {
    const auto pyramid = std::make_shared<const ConvexShape>(ConvexShape{
        .corners = {{-0.9f, -0.5f, -0.5f}, {0.9f, -0.5f, -0.5f}, {0.0f, 0.9f, 0.0f}, {0.0f, -0.5f, 0.5f}},
        .faces = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}});
    CHECK(frames_that_differ(8, [&](int frame) {
              Picture picture = crowd();
              const auto moved = static_cast<float>(std::min(frame, 4));
              picture.bodies[10].position += 0.2f * moved * glm::vec3(1.0f, 0.2f, -0.5f);
              picture.bodies[11].orientation = glm::angleAxis(0.3f * moved, glm::vec3(0.0f, 1.0f, 0.0f));
              if (frame > 5) picture.bodies[11].shape = pyramid;
              return picture;
          }) == none);
}

TEST_CASE("One body that moves among others that stand, and comes to rest") {
    CHECK(frames_that_differ(8, [](int frame) {
              Picture picture = crowd();
              const int moved = std::min(frame, 5);
              picture.bodies[5].position += 0.31f * static_cast<float>(moved) * glm::vec3(-1.0f, 0.3f, 0.2f);
              picture.bodies[1].position.x += moved > 2 ? 0.4f : 0.0f;
              return picture;
          }) == none);
}

TEST_CASE("The shadow of a body that moves, on bodies, panels and ground that stand") {
    for (const glm::vec3 towards_sun : {glm::vec3(-0.5f, 0.9f, 0.65f), glm::vec3(-1.0f, 0.2f, 0.4f)}) {
        CHECK(frames_that_differ(6, [&](int frame) {
                  Picture picture = crowd();
                  picture.towards_sun = towards_sun;
                  picture.bodies.back().position.x += 0.7f * static_cast<float>(frame);
                  return picture;
              }) == none);
    }
}

TEST_CASE("Without a ground shadows fall on bodies all the same") {
    CHECK(frames_that_differ(5, [](int frame) {
              Picture picture = crowd();
              picture.ground.reset();
              picture.bodies.back().position.x += 0.7f * static_cast<float>(frame);
              return picture;
          }) == none);
}

TEST_CASE("Bodies that come, go, grow, turn, change their colour or their place in the list") {
    CHECK(frames_that_differ(9, [](int frame) {
              Picture picture = crowd();
              if (frame == 1) picture.bodies.pop_back();
              if (frame == 2) std::erase_if(picture.bodies, is_sphere);
              if (frame == 4) picture.bodies[3].shape = Sphere{0.9f};
              if (frame == 5) picture.bodies[1].orientation = glm::angleAxis(0.4f, glm::vec3(0.0f, 1.0f, 0.0f));
              if (frame == 6) picture.bars[0].colour = red;
              if (frame == 7) std::swap(picture.bodies[0], picture.bodies[2]);
              return picture;
          }) == none);
}

TEST_CASE("Camera, sun, ground and panels that change") {
    CHECK(frames_that_differ(10, [](int frame) {
              Picture picture = crowd();
              if (frame == 1) picture.camera.eye.x += 0.1f;
              if (frame == 2) picture.towards_sun.x -= 0.01f;
              if (frame == 3) picture.ground->height = -0.5f;
              if (frame == 4) picture.panels[0].opacity = 0.4f;
              if (frame == 5) picture.panels.pop_back();
              if (frame == 6) picture.ground.reset();
              if (frame == 8) picture.camera.vertical_field_of_view_degrees = 39.0f;
              return picture;
          }) == none);
}

TEST_CASE("A body that is thrown out of the shadow map's view, which grows") {
    CHECK(frames_that_differ(8, [](int frame) {
              Picture picture = crowd();
              picture.bodies[9].position += static_cast<float>(frame * frame) * glm::vec3(-1.7f, 0.9f, 0.3f);
              return picture;
          }) == none);
}

TEST_CASE("Arrows and dots leave nothing behind") {
    CHECK(frames_that_differ(4, [](int frame) {
              Picture picture = crowd();
              const glm::vec3 end(1.0f, 2.0f + static_cast<float>(frame), 3.0f);
              picture.arrows = {{.from = {0.0f, 6.0f, 0.0f}, .to = end, .colour = red}};
              if (frame < 3) picture.dots = {{.position = end, .colour = blue}};
              return picture;
          }) == none);
}

TEST_CASE("A mean of several drawings") {
    CHECK(frames_that_differ(
              6,
              [](int frame) {
                  Picture picture = crowd();
                  picture.bodies[5].position.x += 0.2f * static_cast<float>(std::min(frame, 3));
                  if (frame > 3) picture.bodies.back().position.z -= 0.3f * static_cast<float>(frame);
                  return picture;
              },
              3) == none);
}

TEST_CASE("Bodies at random, of which some move at random") {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> any(-1.0f, 1.0f);
    const auto place = [&] { return glm::vec3(6.0f * any(random), 3.0f + 3.0f * any(random), 6.0f * any(random)); };
    Picture picture = crowd();
    for (int i = 0; i < 12; ++i) {
        picture.bodies.push_back({.position = place(), .shape = Box{glm::vec3(0.7f + 0.3f * any(random))}});
        picture.bodies.push_back({.position = place(), .shape = Sphere{0.3f + 0.2f * any(random)}});
        picture.bars.push_back({.from = place(), .to = place(), .radius = 0.02f});
    }
    std::vector<Picture> frames;
    for (int frame = 0; frame < 12; ++frame) {
        const auto i = static_cast<std::size_t>(2 + frame % 12);
        picture.bodies[i].position += 0.5f * glm::vec3(any(random), any(random), any(random));
        picture.bodies[i + 13].position += 0.1f * glm::vec3(any(random), any(random), any(random));
        if (frame % 3 == 0) picture.bars[i - 1].from.x += 0.3f;
        frames.push_back(picture);
    }
    CHECK(frames_that_differ(12, [&](int frame) { return frames[static_cast<std::size_t>(frame)]; }) == none);
}

TEST_CASE("A picture that was drawn already is not drawn again, and after a refused one it is drawn anew") {
    Counter counter;
    const auto context = open_offscreen_context();
    Renderer renderer(*context, width, height, shader_directory, 1, &counter);
    const Image first = renderer.render(crowd());
    CHECK(counter.drawn() == 1);
    OffscreenRenderer other(width, height);
    other.render({.camera = from_the_front, .bodies = {{}}});
    CHECK(other.render(crowd()) == first);
    CHECK(renderer.render(crowd()) == first);
    CHECK(counter.drawn() == 1);
    CHECK_THROWS(renderer.render({.camera = {}, .bodies = {{.shape = Sphere{-1.0f}}}}));
    CHECK(renderer.render(crowd()) == first);
}
