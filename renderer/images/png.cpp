#include "renderer/images/png.h"

#include "renderer/base/renderer_error.h"
#include "renderer/images/cut_out.h"
#include "renderer/images/read_png.h"

#include <libdeflate.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <string>

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

void append_number(std::string& bytes, std::uint32_t number) {
    for (const int shift : {24, 16, 8, 0}) bytes += static_cast<char>(number >> shift & 0xff);
}

// Length, type, data and checksum.
std::string chunk(const std::string& type, const std::string& data) {
    std::string bytes;
    append_number(bytes, static_cast<std::uint32_t>(data.size()));
    bytes += type + data;
    append_number(bytes, libdeflate_crc32(0, bytes.data() + 4, bytes.size() - 4));
    return bytes;
}

}  // namespace

std::vector<std::uint8_t> with_notes(std::vector<std::uint8_t> png, const PngNotes& notes) {
    std::string chunks;
    if (notes.dots_per_inch > 0.0) {
        std::string data;
        const auto dots_per_metre = static_cast<std::uint32_t>(std::lround(notes.dots_per_inch / 0.0254));
        append_number(data, dots_per_metre);
        append_number(data, dots_per_metre);
        chunks += chunk("pHYs", data + '\1');
    }
    if (!notes.film.empty()) chunks += chunk("tEXt", film_key + ('\0' + notes.film));
    constexpr std::ptrdiff_t after_header = 8 + 25;  // signature and IHDR
    if (png.size() < after_header) return png;
    png.insert(png.begin() + after_header, chunks.begin(), chunks.end());
    return png;
}

std::vector<std::uint8_t> encode_png(const Image& image, const PngNotes& notes) {
    return with_notes(encode(image.width, image.height, 3, image.rgb), notes);
}

std::vector<std::uint8_t> encode_png(const CutOut& image, const PngNotes& notes) {
    return with_notes(encode(image.width, image.height, 4, image.rgba), notes);
}

}  // namespace pushfactor::renderer
