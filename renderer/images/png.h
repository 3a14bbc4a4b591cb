#pragma once

#include "renderer/images/image.h"

#include <cstdint>
#include <string>
#include <vector>

namespace pushfactor::renderer {

// What a PNG file says about its picture beside the pixels.
struct PngNotes {
    double dots_per_inch = 0.0;  // 0: not said
    std::string film{};          // text of this key, Latin-1; empty: none
};

// A PNG file with these notes, too. Its chunks begin with the header, as in all PNG files.
std::vector<std::uint8_t> with_notes(std::vector<std::uint8_t> png, const PngNotes& notes);

// Encodes `image` as a PNG file (RGB, 8 bits per channel). Thread-safe. Throws RendererError if the image is empty
// or its bytes do not match its size.
std::vector<std::uint8_t> encode_png(const Image& image, const PngNotes& notes = {});

}  // namespace pushfactor::renderer
