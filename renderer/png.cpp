#include "renderer/png.h"

#include "renderer/renderer_error.h"

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
#include <stb/stb_image_write.h>

#include <cstddef>

namespace pushfactor::renderer {
namespace {

// Half the time of stb's own settings for files that are a few percent larger. They are globals of stb, so
// they are set once, before the first image.
bool set_compression() {
    stbi_write_png_compression_level = 5;
    stbi_write_force_png_filter = 0;
    return true;
}

void append(void* bytes, void* data, int size) {
    const auto* first = static_cast<const std::uint8_t*>(data);
    static_cast<std::vector<std::uint8_t>*>(bytes)->insert(static_cast<std::vector<std::uint8_t>*>(bytes)->end(),
                                                           first, first + size);
}

}  // namespace

std::vector<std::uint8_t> encode_png(const Image& image) {
    [[maybe_unused]] static const bool once = set_compression();

    constexpr int channels = 3;
    const bool empty = image.width <= 0 || image.height <= 0;
    if (empty || image.rgb.size() !=
                     static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * channels) {
        throw RendererError("cannot encode an image whose bytes do not fit its width and height");
    }
    std::vector<std::uint8_t> png;
    if (stbi_write_png_to_func(append, &png, image.width, image.height, channels, image.rgb.data(),
                               channels * image.width) == 0) {
        throw RendererError("cannot encode the image as PNG");
    }
    return png;
}

}  // namespace pushfactor::renderer
