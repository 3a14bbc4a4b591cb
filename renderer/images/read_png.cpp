#include "renderer/images/read_png.h"

#include "renderer/base/renderer_error.h"

#include <png.h>

#include <cstddef>
#include <string>

namespace pushfactor::renderer {

namespace {

// Larger ones are not pictures of ours, and their size may be what is broken.
constexpr std::size_t most_pixels = std::size_t{1} << 28;

// Frees what libpng holds.
struct Reader {
    png_image png{};

    Reader() { png.version = PNG_IMAGE_VERSION; }
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;
    ~Reader() { png_image_free(&png); }

    void require(int succeeded) const {
        if (succeeded == 0) throw RendererError("not a whole PNG file: " + std::string(png.message));
    }
};

}  // namespace

Image decode_png(std::span<const std::uint8_t> png) {
    Reader reader;
    reader.require(png_image_begin_read_from_memory(&reader.png, png.data(), png.size()));
    reader.png.format = PNG_FORMAT_RGB;
    const std::size_t pixels = std::size_t{reader.png.width} * reader.png.height;
    if (pixels > most_pixels) {
        throw RendererError("a PNG file of " + std::to_string(reader.png.width) + "x" +
                            std::to_string(reader.png.height) + " pixels: must be at most 268435456 in all");
    }
    Image image{
        .width = static_cast<int>(reader.png.width), .height = static_cast<int>(reader.png.height), .rgb = {}};
    image.rgb.resize(3 * pixels);
    const png_color white{255, 255, 255};
    reader.require(png_image_finish_read(&reader.png, &white, image.rgb.data(), 0, nullptr));
    return image;
}

}  // namespace pushfactor::renderer
