// Images with transparency, from the same picture over two backgrounds.
#include "renderer/images/cut_out.h"

#include "renderer/base/renderer_error.h"
#include "renderer/images/canvas.h"
#include "tests/catch.h"

using namespace pushfactor::renderer;

namespace {

constexpr glm::vec3 dark(0.02f), light(0.98f);

}  // namespace

TEST_CASE("an opaque, a translucent and an empty pixel are told apart by two backgrounds") {
    const glm::vec3 orange(0.9f, 0.5f, 0.1f);
    Image on_dark = blank_image(30, 10, dark), on_light = blank_image(30, 10, light);
    for (Image* image : {&on_dark, &on_light}) {
        fill(*image, {0, 0, 10, 10}, {.colour = orange});
        fill(*image, {10, 0, 10, 10}, {.colour = orange, .opacity = 0.5f});
    }
    const CutOut cut = cut_out(on_dark, dark, on_light, light);
    const auto byte = [&](int x, int channel) {
        return static_cast<int>(cut.rgba[static_cast<std::size_t>(4 * (5 * cut.width + x) + channel)]);
    };
    CHECK(byte(5, 3) == 255);
    CHECK(byte(15, 3) == Approx(127.5).margin(2));
    CHECK(byte(25, 3) == 0);
    for (const int x : {5, 15}) {
        for (int k = 0; k < 3; ++k) CHECK(byte(x, k) == Approx(255.0 * orange[k]).margin(x == 5 ? 1 : 12));
    }
    const std::vector<std::uint8_t> png = encode_png(cut);
    CHECK(png.at(25) == 6);  // red, green, blue and opacity
    CHECK_THROWS_AS(cut_out(on_dark, dark, blank_image(5, 5, light), light), RendererError);
}
