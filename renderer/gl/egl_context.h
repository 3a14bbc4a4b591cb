#pragma once

#include "renderer/gl/offscreen_context.h"

#include <memory>
#include <string>
#include <vector>

namespace pushfactor::renderer {

// Opens an EGL context without a surface, using Mesa's software rasteriser, and makes it current. `libraries` are
// file names of EGL, tried in turn. Throws RendererError if none can be loaded or the loaded one is not capable of
// it.
//
// For identical pictures on all machines Mesa must not use graphics cards: sets LIBGL_ALWAYS_SOFTWARE unless the
// environment already has it. So open the first context before starting other threads.
std::unique_ptr<OffscreenContext> open_egl_context(const std::vector<std::string>& libraries = {"libEGL.so.1",
                                                                                                "libEGL.so"});

}  // namespace pushfactor::renderer
