#include "renderer/images/png.h"

#include "renderer/base/renderer_error.h"
#include "renderer/images/read_png.h"
#include "tests/catch.h"
#include "tests/renderer/sample_pictures.h"

#include <cstddef>
#include <cstdint>
#include <future>
#include <random>

using namespace pushfactor::renderer;

namespace {

Image noise(int width, int height) {
    std::mt19937 random(1);
    Image image{width, height, {}};
    for (int i = 0; i < 3 * width * height; ++i) image.rgb.push_back(static_cast<std::uint8_t>(random() & 255u));
    return image;
}

}  // namespace

TEST_CASE("A PNG decodes to the bytes of its image") {
    for (const Image& image : {noise(1, 1), noise(37, 11), OffscreenRenderer(96, 54).render(stack_of_cubes(3))}) {
        CHECK(decode_png(encode_png(image)) == image);
    }
}

TEST_CASE("A frame as PNG takes less than a fifth of its bytes") {
    const Image image = OffscreenRenderer(640, 360).render(stack_of_cubes(5));
    const std::size_t size = encode_png(image).size();
    INFO(size << " of " << image.rgb.size() << " bytes");
    CHECK(size < image.rgb.size() / 5);
}

TEST_CASE("Several threads may encode at the same time", "[threads]") {
    const Image image = noise(200, 100);
    const std::vector<std::uint8_t> alone = encode_png(image);
    std::vector<std::future<std::vector<std::uint8_t>>> results;
    for (int i = 0; i < 16; ++i) {
        results.push_back(std::async(std::launch::async, [&image] { return encode_png(image); }));
    }
    for (auto& result : results) CHECK(result.get() == alone);
}

TEST_CASE("An image whose bytes do not fit its size is not encoded") {
    CHECK_THROWS_AS(encode_png(Image{}), RendererError);
    CHECK_THROWS_AS(encode_png(Image{2, 2, {1, 2, 3}}), RendererError);
    CHECK_THROWS_AS(encode_png(Image{-1, -1, {1, 2, 3}}), RendererError);
}

TEST_CASE("A file that is not a whole PNG is refused, whatever is missing or changed") {
    const std::vector<std::uint8_t> png = encode_png(noise(40, 30));
    for (std::size_t size = 0; size + 12 < png.size(); size += 97) {  // the last 12 bytes only end the file
        INFO(size << " of " << png.size() << " bytes");
        CHECK_THROWS_AS(decode_png(std::span(png).first(size)), RendererError);
    }
    for (std::size_t at = 0; at + 12 < png.size(); at += 101) {
        std::vector<std::uint8_t> other = png;
        other[at] ^= 0x10u;
        INFO("byte " << at);
        CHECK_THROWS_AS(decode_png(other), RendererError);
    }
}
