#include "renderer/images/read_png.h"

#include "renderer/base/renderer_error.h"

#include <png.h>

#include <cstddef>
#include <string>
#include <string_view>

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

Image decode_png(std::span<const std::uint8_t> png, Behind behind) {
    if (png.empty()) throw RendererError("an empty file");
    const std::string_view text(reinterpret_cast<const char*>(png.data()), png.size());
    if (text.starts_with("version https://git-lfs")) {
        throw RendererError("a Git LFS pointer and not the picture, which `git lfs pull` brings");
    }
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
    const png_byte level = behind == Behind::white ? 255 : 0;
    const png_color colour{level, level, level};
    reader.require(png_image_finish_read(&reader.png, &colour, image.rgb.data(), 0, nullptr));
    return image;
}

bool has_opacity(std::span<const std::uint8_t> png) {
    Reader reader;
    return png_image_begin_read_from_memory(&reader.png, png.data(), png.size()) != 0 &&
           (reader.png.format & PNG_FORMAT_FLAG_ALPHA) != 0;
}

std::string film_in_png(std::span<const std::uint8_t> png) {
    constexpr std::size_t around = 12;  // length, type and checksum of a chunk
    const std::string_view bytes(reinterpret_cast<const char*>(png.data()), png.size());
    const std::string start = film_key + std::string(1, '\0');
    for (std::size_t at = 8; at + around <= bytes.size();) {
        std::size_t length = 0;
        for (std::size_t i = 0; i < 4; ++i) length = length << 8 | png[at + i];
        const std::string_view type = bytes.substr(at + 4, 4), data = bytes.substr(at + 8, length);
        if (type == "tEXt" && data.starts_with(start)) return std::string(data.substr(start.size()));
        if (type == "IDAT") break;
        at += around + length;
    }
    return "";
}

}  // namespace pushfactor::renderer
