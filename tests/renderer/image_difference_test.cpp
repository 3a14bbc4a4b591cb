#include "tests/renderer/image_difference.h"

#include "tests/catch.h"

#include <array>
#include <cmath>

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
    return same_to_the_eye(ImageDifference(grey, image)) && same_to_the_eye(ImageDifference(image, grey));
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

TEST_CASE("A difference is counted by pixel and level") {
    const ImageDifference difference(grey, changed(20, 3, 17));
    CHECK(difference.largest() == 17);
    CHECK(difference.pixels_above(16) == 20);
    CHECK(difference.pixels_above(17) == 0);
    CHECK(difference.share_above(0) == Approx(20.0 / 10000.0));
    CHECK(difference.rms() == Approx(17.0 * std::sqrt(20.0 / 30000.0)));
    CHECK(difference.similarity() == Approx(20.0 * std::log10(255.0 / difference.rms())));
    CHECK_FALSE(ImageDifference(grey, grey).any());
    CHECK(std::isinf(ImageDifference(grey, grey).similarity()));
}

TEST_CASE("A heat map is lighter where the difference is larger, and faint where there is none") {
    Image other = grey;
    for (std::size_t i = 0; i < 100; ++i) other.rgb[3 * i] = static_cast<std::uint8_t>(100 + i);
    const Image map = heat_map(grey, other);
    const auto light = [&](int x) {
        const auto pixel = map.pixel(x, 0);
        return pixel[0] + pixel[1] + pixel[2];
    };
    CHECK(map.pixel(0, 0) == std::array<std::uint8_t, 3>{25, 25, 25});
    CHECK(light(1) > light(0));
    for (int x = 2; x < 100; ++x) {
        INFO(x);
        CHECK(light(x) >= light(x - 1));
    }
}
