#include "renderer/picture/picture.h"

#include "renderer/base/renderer_error.h"
#include "tests/catch.h"
#include "tests/renderer/sample_pictures.h"

#include <limits>

using namespace pushfactor::renderer;
using Catch::Contains;

TEST_CASE("A picture that cannot be drawn is refused by the name of the field") {
    Picture picture = stack_of_cubes(3);
    REQUIRE_NOTHROW(check(picture));
    const float nan = std::numeric_limits<float>::quiet_NaN();

    SECTION("a body's position") {
        picture.bodies[1].position.y = nan;
        CHECK_THROWS_WITH(check(picture), Contains("bodies[1]"));
    }
    SECTION("a body's orientation") {
        picture.bodies[2].orientation.w = std::numeric_limits<float>::infinity();
        CHECK_THROWS_WITH(check(picture), Contains("bodies[2]"));
    }
    SECTION("a camera that looks nowhere") {
        picture.camera.target = picture.camera.eye;
        CHECK_THROWS_WITH(check(picture), Contains("camera.target"));
    }
    SECTION("a camera that sees nothing") {
        picture.camera.vertical_field_of_view_degrees = 0.0f;
        CHECK_THROWS_WITH(check(picture), Contains("field_of_view"));
    }
    SECTION("a sun that shines from nowhere") {
        picture.towards_sun = glm::vec3(0.0f);
        CHECK_THROWS_WITH(check(picture), Contains("towards_sun"));
    }
    SECTION("the ground's height") {
        picture.ground = Ground{nan};
        CHECK_THROWS_WITH(check(picture), Contains("ground.height"));
    }
    SECTION("a sphere's position") {
        picture.bodies = {{.shape = Sphere{}}, {.position = {0.0f, nan, 0.0f}, .shape = Sphere{}}};
        CHECK_THROWS_WITH(check(picture), Contains("bodies[1] is"));
    }
    SECTION("a sphere's radius") {
        picture.bodies = {{.shape = Sphere{}}, {.shape = Sphere{}}, {.shape = Sphere{-1.0f}}};
        CHECK_THROWS_WITH(check(picture), Contains("bodies[2].shape.radius"));
    }
    SECTION("a bar's end") {
        picture.bars = {{.to = {nan, 0.0f, 0.0f}}};
        CHECK_THROWS_WITH(check(picture), Contains("bars[0] is"));
    }
    SECTION("a bar's radius") {
        picture.bars = {{.radius = nan}};
        CHECK_THROWS_WITH(check(picture), Contains("bars[0].radius"));
    }
    SECTION("a panel's corner") {
        picture.panels = {{.corners = {{0.0f, 0.0f, 0.0f}, {1.0f, 0.0f, 0.0f}, {0.0f, nan, 0.0f}}}};
        CHECK_THROWS_WITH(check(picture), Contains("panels[0].corners"));
    }
    SECTION("a panel without an area") {
        picture.panels = {{.corners = {{0.0f, 0.0f, 0.0f}, {1.0f, 0.0f, 0.0f}}}};
        CHECK_THROWS_WITH(check(picture), Contains("panels[0].corners"));
    }
    SECTION("a panel's opacity") {
        picture.panels = {{.corners = {{0.0f, 0.0f, 0.0f}, {1.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}}}};
        REQUIRE_NOTHROW(check(picture));
        picture.panels[0].opacity = GENERATE(-0.1f, 1.1f, std::numeric_limits<float>::quiet_NaN());
        CHECK_THROWS_WITH(check(picture), Contains("panels[0].opacity"));
    }
    SECTION("an arrow's end") {
        picture.arrows = {{}, {.to = {nan, 0.0f, 0.0f}}};
        CHECK_THROWS_WITH(check(picture), Contains("arrows[1] is"));
    }
    SECTION("a dot's colour") {
        picture.dots = {{.colour = {0.0f, 0.0f, nan}}};
        CHECK_THROWS_WITH(check(picture), Contains("dots[0] is"));
    }
    CHECK_THROWS_AS(OffscreenRenderer(8, 8).render(picture), RendererError);
}
