// FLIP against values of a separate computation with two-dimensional filters, written in another language from the
// paper's formulas, and against what must hold for any images.
#include "renderer/images/flip.h"

#include "tests/catch.h"

#include <algorithm>
#include <numeric>

using namespace pushfactor::renderer;

namespace {

template <typename Colour>
Image image_of(int width, int height, const Colour& colour) {
    Image image{width, height, {}};
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            for (const int value : colour(x, y)) image.rgb.push_back(static_cast<std::uint8_t>(value % 256));
        }
    }
    return image;
}

double mean(const std::vector<float>& errors) {
    return std::accumulate(errors.begin(), errors.end(), 0.0) / static_cast<double>(errors.size());
}

Image plain(int level) {
    return image_of(16, 9, [level](int, int) { return std::array{level, level, level}; });
}

}  // namespace

TEST_CASE("FLIP has the values of its formulas") {
    const Image a = image_of(48, 32, [](int x, int y) { return std::array{5 * x, 7 * y, 3 * (x + y)}; });
    const Image b = image_of(48, 32, [](int x, int y) {
        return std::array{5 * x + 13, 7 * y, 3 * (x + y) + (x > 24 ? 40 : 0)};
    });
    const std::vector<float> errors = flip(a, b);
    CHECK(mean(errors) == Approx(0.2687958).epsilon(1e-3));
    CHECK(errors[10 * 48 + 10] == Approx(0.1138415).epsilon(1e-3));
    CHECK(errors[20 * 48 + 40] == Approx(0.4553926).epsilon(1e-3));
    CHECK(*std::max_element(errors.begin(), errors.end()) == Approx(0.9595485).epsilon(1e-3));
    CHECK(mean(flip(plain(0), plain(255))) == Approx(0.9673798).epsilon(1e-4));
}

TEST_CASE("FLIP is zero for equal images, symmetric, and grows with the difference") {
    CHECK(mean(flip(plain(120), plain(120))) == 0.0);
    CHECK(mean(flip(plain(120), plain(140))) == Approx(mean(flip(plain(140), plain(120)))));
    double before = 0.0;
    for (const int level : {121, 125, 140, 180, 255}) {
        const double now = mean(flip(plain(120), plain(level)));
        CHECK(now > before);
        before = now;
    }
}

TEST_CASE("FLIP sees less of a fine pattern than of a coarse one") {
    const auto stripes = [](int width) {
        return image_of(96, 54, [width](int x, int) {
            const int level = x / width % 2 == 0 ? 118 : 138;
            return std::array{level, level, level};
        });
    };
    const Image grey = image_of(96, 54, [](int, int) { return std::array{128, 128, 128}; });
    CHECK(mean(flip(grey, stripes(1))) < 0.5 * mean(flip(grey, stripes(16))));
}
