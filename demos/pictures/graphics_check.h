// Whether and with what pictures can be drawn here.
#pragma once

#include "renderer/gl/offscreen_context.h"
#include "renderer/images/image.h"

#include <cstdint>
#include <string>

namespace pushfactor::demos::pictures {

// A back end, tried.
struct Graphics {
    std::string found;        // library, version and renderer, or what is missing and what to install
    renderer::Image picture;  // the test picture; empty if it could not be drawn
};

// Opens a context of this kind and draws a small test picture with text. Errors are reported in the result.
Graphics check_graphics(renderer::ContextKind kind);

// FNV-1a of an image's bytes.
std::uint64_t hash_of(const renderer::Image& image);

}  // namespace pushfactor::demos::pictures
