#include "demos/draw_list.h"

#include <array>

namespace pushfactor::demos {

namespace {

// sRGB; told apart by the colour-blind too, by their lightness.
constexpr std::array palette{
    glm::vec3(0.90f, 0.33f, 0.22f),  // vermilion
    glm::vec3(0.95f, 0.62f, 0.18f),  // orange
    glm::vec3(0.20f, 0.55f, 0.80f),  // blue
    glm::vec3(0.16f, 0.66f, 0.55f),  // green
    glm::vec3(0.45f, 0.40f, 0.75f),  // violet
    glm::vec3(0.88f, 0.85f, 0.78f),  // ivory
};

glm::vec3 to_glm(const engine::Vector3& v) {
    return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}

glm::quat to_glm(const engine::Quaternion& q) {
    return {static_cast<float>(q.w()), static_cast<float>(q.x()), static_cast<float>(q.y()),
            static_cast<float>(q.z())};
}

}  // namespace

renderer::Picture draw_list(const Scene& scene) {
    renderer::Picture picture;
    picture.camera.eye = to_glm(scene.view.eye);
    picture.camera.target = to_glm(scene.view.target);
    for (const Drawn& drawn : scene.drawn) {
        const engine::Body& body = scene.world.bodies[static_cast<std::size_t>(drawn.body)];
        switch (drawn.form) {
            case Drawn::Form::ground:
                picture.ground = renderer::Ground{.height = static_cast<float>(body.position.y())};
                break;
            case Drawn::Form::box:
                picture.boxes.push_back(
                    {.position = to_glm(body.position),
                     .orientation = to_glm(body.orientation),
                     .half_extents = to_glm(drawn.half_size),
                     .colour = palette[static_cast<std::size_t>(drawn.colour) % palette.size()]});
                break;
        }
    }
    return picture;
}

}  // namespace pushfactor::demos
