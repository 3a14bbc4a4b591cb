#include "renderer/picture/picture.h"

#include "renderer/base/renderer_error.h"
#include "renderer/picture/panels.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <cstddef>
#include <set>
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

bool not_negative(float length) {
    return finite(length) && length >= 0.0f;
}

std::string fault_of(const Box& box) {
    return finite(box.half_extents) ? "" : ".half_extents are not finite";
}
std::string fault_of(const Sphere& sphere) {
    return not_negative(sphere.radius) ? "" : ".radius is not a length";
}
std::string fault_of(const Polyhedron& polyhedron) {
    return polyhedron ? fault_of(*polyhedron) : " is missing";
}

void check(const std::vector<Body>& bodies) {
    std::set<const ConvexShape*> checked;  // each once: many bodies may have it
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const Body& body = bodies[i];
        const std::string name = "bodies[" + std::to_string(i) + "]";
        require(finite(body.position) && finite(body.orientation) && finite(body.colour), name + " is not finite");
        const auto* polyhedron = std::get_if<Polyhedron>(&body.shape);
        if (polyhedron && !checked.insert(polyhedron->get()).second) continue;
        const std::string fault = std::visit([](const auto& shape) { return fault_of(shape); }, body.shape);
        require(fault.empty(), name + ".shape" + fault);
    }
}

void check(const Bar& bar, const std::string& name) {
    require(finite(bar.from) && finite(bar.to) && finite(bar.colour), name + " is not finite");
    require(not_negative(bar.radius), name + ".radius is not a length");
}

void check(const Panel& panel, const std::string& name) {
    for (const glm::vec3& corner : panel.corners) require(finite(corner), name + ".corners are not finite");
    require(flat_and_convex(panel.corners), name + ".corners are not those of a flat convex polygon");
    require(finite(panel.colour), name + ".colour is not finite");
    require(panel.opacity >= 0.0f && panel.opacity <= 1.0f, name + ".opacity is not between 0 and 1");
}

void check(const Arrow& arrow, const std::string& name) {
    require(finite(arrow.from) && finite(arrow.to) && finite(arrow.colour), name + " is not finite");
}

void check(const Dot& dot, const std::string& name) {
    require(finite(dot.position) && finite(dot.colour), name + " is not finite");
}

template <typename Thing>
void check_each(const std::vector<Thing>& things, const std::string& name) {
    for (std::size_t i = 0; i < things.size(); ++i) check(things[i], name + "[" + std::to_string(i) + "]");
}

}  // namespace

void check(const Picture& picture) {
    check(picture.camera);
    require(finite(picture.towards_sun) && picture.towards_sun != glm::vec3(0.0f), "towards_sun has no direction");
    const auto is_colour = [](float part) { return part >= 0.0f && part < 1.0f; };
    const glm::vec3& behind = picture.background.colour;
    require(is_colour(behind.r) && is_colour(behind.g) && is_colour(behind.b),
            "background.colour is not from 0 to below 1");
    if (picture.ground) require(finite(picture.ground->height), "ground.height is not finite");
    require(finite(picture.mark_scale) && picture.mark_scale > 0.0f, "mark_scale is not above 0");
    check(picture.bodies);
    check_each(picture.bars, "bars");
    check_each(picture.panels, "panels");
    check_each(picture.arrows, "arrows");
    check_each(picture.dots, "dots");
}

}  // namespace pushfactor::renderer
