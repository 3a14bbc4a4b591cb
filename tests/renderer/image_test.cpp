#include "renderer/image.h"

#include "tests/catch.h"

#include <array>
#include <cstdint>
#include <vector>

using namespace pushfactor::renderer;

TEST_CASE("What GL reads back comes out top row first and without the fourth channel") {
    const std::vector<std::uint8_t> rgba = {1, 2, 3, 255, 4,  5,  6,  255,  // the lower row
                                            7, 8, 9, 255, 10, 11, 12, 0};   // the upper row
    const Image image = image_from_bottom_up_rgba(2, 2, rgba);
    CHECK(image.rgb == std::vector<std::uint8_t>{7, 8, 9, 10, 11, 12, 1, 2, 3, 4, 5, 6});
    CHECK(image.pixel(0, 0) == std::array<std::uint8_t, 3>{7, 8, 9});
    CHECK(image.pixel(1, 1) == std::array<std::uint8_t, 3>{4, 5, 6});
}
