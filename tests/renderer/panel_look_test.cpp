// The look of translucent panels in a frame.
#include "renderer/renderer.h"
#include "tests/catch.h"
#include "tests/renderer/sample_pictures.h"

#include <algorithm>

using namespace pushfactor::renderer;

namespace {

// A square of 4 m that faces the camera `from_the_front`. No line of its grid and no edge is near its middle
// when that is not at a whole number of metres.
Panel square_at(float z, const glm::vec3& colour, float opacity) {
    return {.corners = {{-1.6f, -1.6f, z}, {2.4f, -1.6f, z}, {2.4f, 2.4f, z}, {-1.6f, 2.4f, z}},
            .colour = colour,
            .opacity = opacity};
}

Panel reversed(Panel panel) {
    std::ranges::reverse(panel.corners);
    return panel;
}

Pixel at(const Image& image, const glm::vec3& point) {
    const auto [x, y] = pixel_from_the_front(image.width, image.height, point);
    return image.pixel(x, y);
}

int difference(const Pixel& a, const Pixel& b) {
    return std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]) + std::abs(a[2] - b[2]);
}

const glm::vec3 middle(0.45f, 0.45f, 0.0f);

}  // namespace

TEST_CASE("A ball behind a panel is still seen, and the panel tints it") {
    OffscreenRenderer offscreen(320, 180);
    const Body ball{.position = {0.5f, 0.5f, -1.0f}, .shape = Sphere{}, .colour = red};
    const Panel panel = square_at(0.0f, blue, 0.4f);
    const Pixel bare = at(offscreen.render({.camera = from_the_front, .bodies = {ball}}), middle);
    const Pixel alone = at(offscreen.render({.camera = from_the_front, .panels = {panel}}), middle);
    const Pixel both =
        at(offscreen.render({.camera = from_the_front, .bodies = {ball}, .panels = {panel}}), middle);
    CHECK(both[1] < alone[1] - 30);  // still without the light of the background
    CHECK(both[0] > both[1] + 60);   // and red
    CHECK(both[0] < bare[0] - 15);   // but tinted
    CHECK(both[2] > bare[2] + 30);
}

TEST_CASE("A panel behind a ball does not show through it") {
    OffscreenRenderer offscreen(320, 180);
    const Body ball{.position = {0.5f, 0.5f, 1.0f}, .shape = Sphere{}, .colour = red};
    const Pixel bare = at(offscreen.render({.camera = from_the_front, .bodies = {ball}}), middle);
    const Picture picture{.camera = from_the_front, .bodies = {ball}, .panels = {square_at(-1.0f, blue, 1.0f)}};
    CHECK(at(offscreen.render(picture), middle) == bare);
}

TEST_CASE("A panel is seen from both sides, from the back fainter") {
    OffscreenRenderer offscreen(320, 180);
    const Panel panel = square_at(0.0f, blue, 0.5f);
    const Pixel empty = at(offscreen.background(), middle);
    const Pixel front = at(offscreen.render({.camera = from_the_front, .panels = {panel}}), middle);
    const Pixel back = at(offscreen.render({.camera = from_the_front, .panels = {reversed(panel)}}), middle);
    CHECK(difference(back, empty) > 30);
    CHECK(difference(front, empty) > 1.5 * difference(back, empty));
}

TEST_CASE("Opacity says how much a panel hides") {
    OffscreenRenderer offscreen(320, 180);
    const auto seen = [&](float opacity) {
        return at(offscreen.render({.camera = from_the_front, .panels = {square_at(0.0f, blue, opacity)}}), middle);
    };
    CHECK(seen(0.0f) == at(offscreen.background(), middle));
    CHECK(seen(0.3f)[0] > seen(0.6f)[0] + 15);
    CHECK(seen(0.6f)[0] > seen(1.0f)[0] + 15);
}

TEST_CASE("A panel has a bright outline, even where it hides nothing") {
    OffscreenRenderer offscreen(320, 180);
    for (const float opacity : {0.0f, 0.5f}) {
        const Panel panel = square_at(0.0f, blue, opacity);
        for (const Panel& side : {panel, reversed(panel)}) {
            const Image image = offscreen.render({.camera = from_the_front, .panels = {side}});
            // A little inside each edge, between the lines of the grid.
            for (const glm::vec3 edge : {glm::vec3(2.38f, 0.45f, 0.0f), glm::vec3(-1.58f, 0.45f, 0.0f),
                                         glm::vec3(0.45f, 2.38f, 0.0f), glm::vec3(0.45f, -1.58f, 0.0f)}) {
                const Pixel line = at(image, edge);
                CHECK(*std::ranges::min_element(line) > 230);
            }
        }
    }
}

TEST_CASE("The nearer panel is drawn over the farther, whatever their order in the list") {
    OffscreenRenderer offscreen(320, 180);
    std::vector<Panel> panels{square_at(-2.0f, blue, 0.9f), square_at(-1.0f, ivory, 0.2f),
                              square_at(1.0f, red, 0.8f)};
    const Image first = offscreen.render({.camera = from_the_front, .panels = panels});
    CHECK(at(first, middle)[0] > at(first, middle)[2] + 60);  // red, which is the nearest
    for (int turn = 0; turn < 2; ++turn) {
        std::rotate(panels.begin(), panels.begin() + 1, panels.end());
        CHECK(offscreen.render({.camera = from_the_front, .panels = panels}) == first);
    }
    std::ranges::reverse(panels);
    CHECK(offscreen.render({.camera = from_the_front, .panels = panels}) == first);
}

TEST_CASE("Neither does the order matter of panels that are equally far away") {
    OffscreenRenderer offscreen(320, 180);
    const Panel level{
        .corners = {{-2.0f, 0.0f, 2.0f}, {2.0f, 0.0f, 2.0f}, {2.0f, 0.0f, -2.0f}, {-2.0f, 0.0f, -2.0f}},
        .colour = ivory,
        .opacity = 0.6f};
    Panel tilted = level;
    for (glm::vec3& corner : tilted.corners) corner.y = 0.5f * corner.x;
    Panel red_one = tilted;
    red_one.colour = red;
    std::vector<Panel> panels{level, red_one, tilted};
    const Camera camera{.eye = {0.0f, 4.0f, 9.0f}, .target = glm::vec3(0.0f)};
    const Image first = offscreen.render({.camera = camera, .panels = panels});
    do {
        std::rotate(panels.begin(), panels.begin() + 1, panels.end());
        CHECK(offscreen.render({.camera = camera, .panels = panels}) == first);
        std::swap(panels[0], panels[1]);
        CHECK(offscreen.render({.camera = camera, .panels = panels}) == first);
        std::swap(panels[0], panels[1]);
    } while (panels[0].corners != level.corners);
}

TEST_CASE("A ball's shadow falls on a panel, and the panel casts none") {
    OffscreenRenderer offscreen(320, 180);
    Picture picture{
        .camera = from_the_front, .towards_sun = {1.0f, 0.0f, 1.0f}, .panels = {square_at(0.0f, ivory, 0.8f)}};
    const Image lit = offscreen.render(picture);
    picture.bodies = {{.position = {2.45f, 0.45f, 2.0f}, .shape = Sphere{}, .colour = red}};
    CHECK(difference(at(offscreen.render(picture), middle), at(lit, middle)) > 60);

    Picture ground{.camera = from_above, .towards_sun = {-1.0f, 1.0f, 0.0f}, .ground = Ground{}};
    const Image bare = offscreen.render(ground);
    ground.panels = {
        {.corners = {{-4.0f, 3.0f, 1.0f}, {-2.0f, 3.0f, 1.0f}, {-2.0f, 3.0f, -1.0f}, {-4.0f, 3.0f, -1.0f}},
         .opacity = 1.0f}};
    const Image below = offscreen.render(ground);
    const auto [x, y] = pixel_from_above(ground.camera, 320, 180, 0.3f, 0.3f);
    CHECK(below.pixel(x, y) == bare.pixel(x, y));
    const auto [panel_x, panel_y] = pixel_from_above(ground.camera, 320, 180, -3.5f, 0.3f);
    CHECK(below.pixel(panel_x, panel_y) != bare.pixel(panel_x, panel_y));
}
