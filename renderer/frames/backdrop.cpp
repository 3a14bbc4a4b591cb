#include "renderer/frames/backdrop.h"

namespace pushfactor::renderer {

Backdrop::Backdrop(const Gl& gl, int width, int height, Stored stored)
    : image_(gl, width, height, stored), whole_{.x = 0, .y = 0, .width = width, .height = height} {}

bool Backdrop::is_worth_keeping(const BackdropView& view) {
    if (view_ == view) return true;
    view_ = view;
    drawn_ = false;
    return false;
}

void Backdrop::bind() {
    image_.bind();
    drawn_ = true;
}

}  // namespace pushfactor::renderer
