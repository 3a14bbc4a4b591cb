// Images with transparency.
#pragma once

#include "renderer/images/image.h"
#include "renderer/images/png.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace pushfactor::renderer {

// Like Image, with four bytes per pixel: red, green and blue, not multiplied with the opacity that follows.
struct CutOut {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgba{};
};

// What looks like `on_dark` over `dark` and like `on_light` over `light`: the same picture over two backgrounds
// (sRGB, each channel of `light` above that of `dark`). Throws RendererError if their sizes differ.
CutOut cut_out(const Image& on_dark, const glm::vec3& dark, const Image& on_light, const glm::vec3& light);

// As encode_png() of an image.
std::vector<std::uint8_t> encode_png(const CutOut& image, const PngNotes& notes = {});

}  // namespace pushfactor::renderer
