#include "renderer/images/png.h"

#include "renderer/base/renderer_error.h"
#include "renderer/images/cut_out.h"

#include <libdeflate.h>

#include <cstddef>
#include <cstdlib>
#include <memory>

namespace {

struct FreeCompressor {
    void operator()(libdeflate_compressor* compressor) const { libdeflate_free_compressor(compressor); }
};

// Replaces stb's own compression, which takes several times as long for larger results. Returns the zlib stream of
// `size` bytes in memory that stb frees, or null if there is no memory.
unsigned char* compress(unsigned char* bytes, int size, int* compressed_size, int /*quality*/) {
    constexpr int level = 1;  // the fastest; a frame is written once and rarely kept
    // A compressor supports one call at a time.
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

// A fixed filter saves the time in which stb tries all five; differences from the left neighbour suit flat colours
// and slow gradients. It is a global of stb, so it is set once, before the first image.
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

std::vector<std::uint8_t> encode(int width, int height, int channels, const std::vector<std::uint8_t>& bytes) {
    [[maybe_unused]] static const bool once = set_filter();
    const bool empty = width <= 0 || height <= 0;
    if (empty || bytes.size() != static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
                                     static_cast<std::size_t>(channels)) {
        throw RendererError("cannot encode an image whose bytes do not fit its width and height");
    }
    std::vector<std::uint8_t> png;
    if (stbi_write_png_to_func(append, &png, width, height, channels, bytes.data(), channels * width) == 0) {
        throw RendererError("cannot encode the image as PNG");
    }
    return png;
}

}  // namespace

std::vector<std::uint8_t> encode_png(const Image& image) {
    return encode(image.width, image.height, 3, image.rgb);
}

std::vector<std::uint8_t> encode_png(const CutOut& image) {
    return encode(image.width, image.height, 4, image.rgba);
}

}  // namespace pushfactor::renderer
