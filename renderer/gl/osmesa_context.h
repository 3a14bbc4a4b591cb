#pragma once

#include "renderer/gl/offscreen_context.h"

#include <memory>
#include <string>
#include <vector>

namespace pushfactor::renderer {

// Opens a context of Mesa's software rasteriser and makes it current. `libraries` are file names of OSMesa,
// tried in turn. Throws RendererError when none can be loaded or the one loaded has no GL 3.3 core.
std::unique_ptr<OffscreenContext> open_osmesa_context(const std::vector<std::string>& libraries = {
                                                          "libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"});

}  // namespace pushfactor::renderer
