#pragma once

#include "renderer/gl/offscreen_context.h"

#include <string>

namespace pushfactor::renderer {

// What draws: "OSMesa, 4.5 (Core Profile) Mesa 22.3.6, llvmpipe (LLVM 15.0.6, 256 bits)". Equal texts stand for
// equal bytes of equal pictures. Makes the context current.
std::string driver_of(OffscreenContext& context);

}  // namespace pushfactor::renderer
