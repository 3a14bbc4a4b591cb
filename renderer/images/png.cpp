#include "renderer/images/png.h"

#include "renderer/base/renderer_error.h"

#include <libdeflate.h>

#include <cstddef>
#include <cstdlib>
#include <memory>

namespace {

struct FreeCompressor {
    void operator()(libdeflate_compressor* compressor) const { libdeflate_free_compressor(compressor); }
};

// What stb calls instead of its own compression, which takes several times as long for larger results: the zlib
// stream of `size` bytes, in memory that stb frees. Null, as stb expects it, when there is no memory.
unsigned char* compress(unsigned char* bytes, int size, int* compressed_size, int /*quality*/) {
    constexpr int level = 1;  // the fastest; a frame is written once and hardly ever kept
    // A compressor serves one call at a time.
    thread_local const std::unique_ptr<libdeflate_compressor, FreeCompressor> compressor(
        libdeflate_alloc_compressor(level));
    if (compressor == nullptr) return nullptr;
    const auto count = static_cast<std::size_t>(size);
    const std::size_t bound = libdeflate_zlib_compress_bound(compressor.get(), count);
    auto* compressed = static_cast<unsigned char*>(std::malloc(bound));
    if (compressed == nullptr) return nullptr;
    *compressed_size =
        static_cast<int>(libdeflate_zlib_compress(compressor.get(), bytes, count, compressed, bound));
    return compressed;
}

}  // namespace

#define STBIW_ZLIB_COMPRESS compress
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
#include <stb/stb_image_write.h>

namespace pushfactor::renderer {
namespace {

// One filter for all rows saves the time that stb takes to try all five; differences from the left neighbour
// suit flat colours and slow gradients. It is a global of stb, so it is set once, before the first image.
bool set_filter() {
    constexpr int difference_from_the_left = 1;
    stbi_write_force_png_filter = difference_from_the_left;
    return true;
}

void append(void* bytes, void* data, int size) {
    const auto* first = static_cast<const std::uint8_t*>(data);
    static_cast<std::vector<std::uint8_t>*>(bytes)->insert(static_cast<std::vector<std::uint8_t>*>(bytes)->end(),
                                                           first, first + size);
}

}  // namespace

std::vector<std::uint8_t> encode_png(const Image& image) {
    [[maybe_unused]] static const bool once = set_filter();

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
