#include "renderer/offscreen_context.h"

#include "renderer/osmesa_context.h"

namespace pushfactor::renderer {

std::unique_ptr<OffscreenContext> open_offscreen_context() {
    return open_osmesa_context();
}

}  // namespace pushfactor::renderer
