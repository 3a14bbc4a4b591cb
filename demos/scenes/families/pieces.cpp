#include "demos/scenes/families/pieces.h"

#include "demos/scenes/named/named_scenes.h"

#include <algorithm>

namespace pushfactor::demos::families {

using engine::Quaternion;
using engine::Vector3;

FamilyParameter friction_of(double low, double high) {
    return {{"friction", "MU", "friction coefficient", 0, low, high}};
}

FamilyParameter inside_of(std::string_view help) {
    return {{"inside", "0|1", help, 0, 0, 1, true}};
}

FamilyParameter beyond_of(double low, double high, std::string_view help) {
    return {{"beyond", "X", help, 0, low, high}};
}

double less_than_limit(const ParameterValues& values) {
    return values.whole("inside") == 1 ? 1.0 - values.number("beyond") : 1.0 + values.number("beyond");
}

double more_than_limit(const ParameterValues& values) {
    return values.whole("inside") == 1 ? 1.0 + values.number("beyond") : 1.0 - values.number("beyond");
}

Prospect standing(SceneDescription scene) {
    look_at_all(scene);
    return {.scene = std::move(scene)};
}

Prospect comes_to_rest(const ParameterValues& values, SceneDescription scene, double height, double speed) {
    look_at_all(scene);
    const double falls = std::sqrt(2.0 * height / gravity);
    const double slides = elementary::hypot(falls, speed / gravity) / values.number("friction");
    return {.scene = std::move(scene), .ends = Ends::rests, .rest_by = 5.0 + 2.0 * falls + slides};
}

Prospect ends_by_limit(const ParameterValues& values, SceneDescription scene, Ends outside, double rest_by,
                       const std::string& leaving) {
    if (values.whole("inside") == 1) return standing(std::move(scene));
    look_at_all(scene);
    return {.scene = std::move(scene), .ends = outside, .rest_by = rest_by, .leaving = {leaving}};
}

SceneDescription on_ground(double friction) {
    SceneDescription scene;
    scene.gravity = Vector3(0, -gravity, 0);
    scene.bodies.push_back({.name = "ground", .shape = PlaneShape{}, .friction = friction});
    return scene;
}

SceneDescription on_ground(const ParameterValues& values) {
    return on_ground(values.number("friction"));
}

BodyDescription& add_body(SceneDescription& scene, const std::string& name, const BodyShape& shape, double mass,
                          const Vector3& position) {
    const double friction = scene.bodies.front().friction;
    return scene.bodies.emplace_back(
        BodyDescription{.name = name, .shape = shape, .mass = mass, .position = position, .friction = friction});
}

Quaternion turned(double angle) {
    return exponential(angle * Vector3::UnitY());
}

Quaternion inclined(double angle) {
    return exponential(angle * Vector3::UnitZ());
}

void look_at_all(SceneDescription& scene) {
    Eigen::AlignedBox3d around;
    for (const BodyDescription& body : scene.bodies) {
        const Vector3 reach = Vector3::Constant(bounding_radius(body));
        if (body.mass) around.extend(Eigen::AlignedBox3d(body.position - reach, body.position + reach));
    }
    const Vector3 extent = around.sizes();
    scene.view = scenes::view_of(around.center(), std::max({extent.y(), 0.6 * extent.x(), 0.6 * extent.z()}));
}

}  // namespace pushfactor::demos::families
