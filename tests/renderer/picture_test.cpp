#include "renderer/picture.h"

#include "renderer/renderer_error.h"
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
        picture.boxes[1].position.y = nan;
        CHECK_THROWS_WITH(check(picture), Contains("boxes[1]"));
    }
    SECTION("a body's orientation") {
        picture.boxes[2].orientation.w = std::numeric_limits<float>::infinity();
        CHECK_THROWS_WITH(check(picture), Contains("boxes[2]"));
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
    CHECK_THROWS_AS(Studio(8, 8).render(picture), RendererError);
}
