#include "renderer/picture.h"

#include "renderer/renderer_error.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <cstddef>
#include <string>

namespace pushfactor::renderer {
namespace {

void require(bool holds, const std::string& message) {
    if (!holds) throw RendererError("picture: " + message);
}

bool finite(float value) {
    return std::isfinite(value);
}
bool finite(const glm::vec3& v) {
    return finite(v.x) && finite(v.y) && finite(v.z);
}
bool finite(const glm::quat& q) {
    return finite(q.x) && finite(q.y) && finite(q.z) && finite(q.w);
}

void check(const Camera& camera) {
    require(finite(camera.eye), "camera.eye is not finite");
    require(finite(camera.target), "camera.target is not finite");
    require(camera.eye != camera.target, "camera.eye and camera.target are the same point");
    require(camera.vertical_field_of_view_degrees > 0.0f && camera.vertical_field_of_view_degrees < 180.0f,
            "camera.vertical_field_of_view_degrees is not between 0 and 180");
}

}  // namespace

void check(const Picture& picture) {
    check(picture.camera);
    require(finite(picture.towards_sun) && picture.towards_sun != glm::vec3(0.0f), "towards_sun has no direction");
    if (picture.ground) require(finite(picture.ground->height), "ground.height is not finite");
    for (std::size_t i = 0; i < picture.boxes.size(); ++i) {
        const Box& box = picture.boxes[i];
        const bool drawable =
            finite(box.position) && finite(box.orientation) && finite(box.half_extents) && finite(box.colour);
        require(drawable, "boxes[" + std::to_string(i) + "] is not finite");
    }
}

}  // namespace pushfactor::renderer
