#include "tests/renderer/decode_png.h"

#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#include <stb/stb_image.h>

#include <memory>
#include <stdexcept>

namespace pushfactor::renderer {

Image decode_png(const std::vector<std::uint8_t>& png) {
    Image image;
    int channels = 0;
    const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> pixels(
        stbi_load_from_memory(png.data(), static_cast<int>(png.size()), &image.width, &image.height, &channels, 0),
        stbi_image_free);
    if (pixels == nullptr || channels != 3) throw std::runtime_error("this is not a PNG file with three channels");
    image.rgb.assign(pixels.get(), pixels.get() + 3 * image.width * image.height);
    return image;
}

}  // namespace pushfactor::renderer
