#include "renderer/images/read_png.h"

#include "renderer/base/renderer_error.h"

#include <libdeflate.h>
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

std::uint32_t number_at(std::span<const std::uint8_t> bytes, std::size_t at) {
    std::uint32_t number = 0;
    for (std::size_t i = 0; i < 4; ++i) number = number << 8 | bytes[at + i];
    return number;
}

// Calls `visit` with type and data of each chunk. False unless all are whole, up to the last one.
template <typename Visit>
bool for_chunks(std::span<const std::uint8_t> png, const Visit& visit) {
    constexpr std::size_t signature = 8, around = 12;  // length, type and checksum of a chunk
    const std::string_view bytes(reinterpret_cast<const char*>(png.data()), png.size());
    for (std::size_t at = signature; at + around <= png.size();) {
        const std::size_t length = number_at(png, at);
        if (length > png.size() - at - around) return false;
        if (libdeflate_crc32(0, png.data() + at + 4, length + 4) != number_at(png, at + 8 + length)) return false;
        const std::string_view type = bytes.substr(at + 4, 4);
        if (type == "IEND") return true;
        visit(type, bytes.substr(at + 8, length));
        at += around + length;
    }
    return false;
}

std::vector<std::uint8_t> decode(std::span<const std::uint8_t> png, png_uint_32 format, Image& size) {
    if (png.empty()) throw RendererError("an empty file");
    const std::string_view text(reinterpret_cast<const char*>(png.data()), png.size());
    if (text.starts_with("version https://git-lfs")) {
        throw RendererError("a Git LFS pointer and not the picture, which `git lfs pull` brings");
    }
    Reader reader;
    reader.require(png_image_begin_read_from_memory(&reader.png, png.data(), png.size()));
    // Of chunks that are not needed for the pixels libpng does not look at the checksums.
    if (!for_chunks(png, [](std::string_view, std::string_view) {})) {
        throw RendererError("not a whole PNG file: a chunk is cut or damaged");
    }
    reader.png.format = format;
    const std::size_t pixels = std::size_t{reader.png.width} * reader.png.height;
    if (pixels > most_pixels) {
        throw RendererError("a PNG file of " + std::to_string(reader.png.width) + "x" +
                            std::to_string(reader.png.height) + " pixels: must be at most 268435456 in all");
    }
    size.width = static_cast<int>(reader.png.width);
    size.height = static_cast<int>(reader.png.height);
    std::vector<std::uint8_t> bytes(PNG_IMAGE_PIXEL_CHANNELS(format) * pixels);
    const png_color white{255, 255, 255};
    reader.require(png_image_finish_read(&reader.png, &white, bytes.data(), 0, nullptr));
    return bytes;
}

}  // namespace

Image decode_png(std::span<const std::uint8_t> png) {
    Image image;
    image.rgb = decode(png, PNG_FORMAT_RGB, image);
    return image;
}

Image decode_opacity(std::span<const std::uint8_t> png) {
    Image image;
    const std::vector<std::uint8_t> rgba = decode(png, PNG_FORMAT_RGBA, image);
    for (std::size_t i = 3; i < rgba.size(); i += 4) image.rgb.insert(image.rgb.end(), 3, rgba[i]);
    return image;
}

bool has_opacity(std::span<const std::uint8_t> png) {
    Reader reader;
    return png_image_begin_read_from_memory(&reader.png, png.data(), png.size()) != 0 &&
           (reader.png.format & PNG_FORMAT_FLAG_ALPHA) != 0;
}

std::string film_in_png(std::span<const std::uint8_t> png) {
    std::string film;
    const std::string start = film_key + std::string(1, '\0');
    for_chunks(png, [&](std::string_view type, std::string_view data) {
        if (type == "tEXt" && data.starts_with(start)) film = data.substr(start.size());
    });
    return film;
}

}  // namespace pushfactor::renderer
