#include "tests/renderer/image_difference.h"

#include "tests/catch.h"

using namespace pushfactor::renderer;

namespace {

const Image grey{100, 100, std::vector<std::uint8_t>(30000, 100)};

// The grey image, of which `count` channels, each `step` after the last, are brighter.
Image changed(int count, int step, int brighter) {
    Image image = grey;
    for (int i = 0; i < count; ++i) {
        image.rgb[static_cast<std::size_t>(step * i)] = static_cast<std::uint8_t>(100 + brighter);
    }
    return image;
}

bool same(const Image& image) {
    return same_to_the_eye(image_difference(grey, image)) && same_to_the_eye(image_difference(image, grey));
}

}  // namespace

TEST_CASE("Equal images are the same") {
    CHECK(same(grey));
}

TEST_CASE("One pixel in 500 may differ by more than two levels") {
    CHECK(same(changed(20, 3, 3)));
    CHECK_FALSE(same(changed(21, 3, 3)));
    CHECK(same(changed(21, 3, 2)));
    CHECK(same(changed(60, 1, 3)));  // three channels of a pixel count once
}

TEST_CASE("One pixel in 5000 may differ by more than sixteen levels") {
    CHECK(same(changed(2, 3, 17)));
    CHECK_FALSE(same(changed(3, 3, 17)));
    CHECK(same(changed(3, 3, 16)));
}

TEST_CASE("Many differences too small to be seen add up") {
    // 50 dB below 255 squared is a mean square of 0.65025.
    CHECK(same(changed(19507, 1, 1)));
    CHECK_FALSE(same(changed(19508, 1, 1)));
}

TEST_CASE("The picture of a difference is black where there is none") {
    const Image picture = picture_of_difference(grey, changed(1, 3, 3));
    CHECK(picture.pixel(0, 0) == std::array<std::uint8_t, 3>{48, 0, 0});
    CHECK(picture.pixel(1, 0) == std::array<std::uint8_t, 3>{0, 0, 0});
    CHECK(picture_of_difference(grey, changed(1, 3, 100)).pixel(0, 0)[0] == 255);
}
