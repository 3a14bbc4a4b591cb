#pragma once

#include "renderer/gl/offscreen_context.h"

#include <memory>
#include <string>
#include <vector>

namespace pushfactor::renderer {

// Opens a context of EGL without any surface, drawn by Mesa's software rasteriser, and makes it current.
// `libraries` are file names of EGL, tried in turn. Throws RendererError when none can be loaded, or the one loaded
// cannot do that.
//
// For the pictures to be the same everywhere Mesa is told to leave graphics cards alone: unless the environment has
// it already, LIBGL_ALWAYS_SOFTWARE is set. So open the first one before there are other threads.
std::unique_ptr<OffscreenContext> open_egl_context(const std::vector<std::string>& libraries = {"libEGL.so.1",
                                                                                                "libEGL.so"});

}  // namespace pushfactor::renderer
