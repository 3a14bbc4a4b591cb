#include "demos/pictures/studio.h"

#include <filesystem>

namespace pushfactor::demos::pictures {

renderer::Image Studio::draw(const renderer::Picture& picture, const Size& size, int samples) {
    const std::tuple wanted{size.width, size.height, samples};
    if (!renderer_ || wanted != made_for_) {
        renderer_.reset();
        renderer_ = std::make_unique<renderer::Renderer>(
            *context_, size.width, size.height, std::filesystem::path(PUSHFACTOR_ASSET_DIR) / "shaders", samples);
        made_for_ = wanted;
    }
    return renderer_->render(picture);
}

}  // namespace pushfactor::demos::pictures
