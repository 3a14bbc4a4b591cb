#include "demos/pictures/replay/stage.h"

#include "demos/options/simulation_options.h"
#include "demos/pictures/draw_list.h"
#include "demos/pictures/overlays/overlay.h"
#include "demos/pictures/replay/bytes.h"
#include "renderer/meshes/meshes.h"

#include <map>

namespace pushfactor::demos::pictures::replay {

namespace {

using engine::Vector3;

template <typename Vector>
Json three(const Vector& v) {
    return {v[0], v[1], v[2]};
}

void append_mesh(std::string& bytes, renderer::Mesh mesh) {
    if (mesh.indices.size() % 2 != 0) mesh.indices.push_back(0);  // an index alone draws nothing
    append_raw(bytes, static_cast<std::uint32_t>(mesh.vertices.size()));
    append_raw(bytes, static_cast<std::uint32_t>(mesh.indices.size()));
    for (const renderer::Vertex& vertex : mesh.vertices) {
        for (const auto& part : {vertex.corner, vertex.normal}) {
            for (int axis = 0; axis < 3; ++axis) append_raw(bytes, part[axis]);
        }
    }
    for (const std::uint16_t index : mesh.indices) append_raw(bytes, index);
}

// The shapes of a picture's polyhedra, numbered as they first occur.
std::map<renderer::Polyhedron, std::size_t> numbered_shapes(const renderer::Picture& picture) {
    std::map<renderer::Polyhedron, std::size_t> numbers;
    for (const renderer::Body& body : picture.bodies) {
        const auto* shape = std::get_if<renderer::Polyhedron>(&body.shape);
        if (shape) numbers.try_emplace(*shape, numbers.size());
    }
    return numbers;
}

Json options_of(const Choices& choices) {
    Json options = Json::object();
    options["preset"] = choices.settings.preset;
    for (const auto& [name, text] : texts_of(choices.settings)) options[name] = text;
    for (const auto& [name, text] : choices.parameters) options[name] = text;
    return options;
}

// Shapes and colours are those of the picture that the renderer would draw.
Json bodies_of(const BuiltScene& scene, const renderer::Picture& picture) {
    Json bodies = Json::array();
    for (std::size_t i = 0; i < scene.world.bodies.size(); ++i) {
        const engine::Body& body = scene.world.bodies[i];
        const engine::Quaternion& q = body.orientation;
        Json json{{"position", three(body.position)},
                  {"orientation", {q.w(), q.x(), q.y(), q.z()}},
                  {"unit", size_of(scene, i)}};
        if (!body.is_static()) {
            json["mass"] = body.mass();
            json["moments"] = three(Vector3(body.inverse_inertia.cwiseInverse()));
        }
        json["name"] = i < scene.bodies.size() ? scene.bodies[i].name : "world";
        if (i < scene.bodies.size() && std::holds_alternative<PlaneShape>(scene.bodies[i].shape)) {
            json["plane"] = Json::array();
            for (const Vector3& corner : plane_outline(scene, body)) json["plane"].push_back(three(corner));
        }
        bodies.push_back(std::move(json));
    }
    const auto numbers = numbered_shapes(picture);
    for (const renderer::Body& body : picture.bodies) {
        Json& json = bodies[body.index];
        std::visit(engine::Overloaded{[&](const renderer::Box& box) { json["box"] = three(box.half_extents); },
                                      [&](const renderer::Sphere& sphere) { json["sphere"] = sphere.radius; },
                                      [&](const renderer::Polyhedron& shape) {
                                          json["polyhedron"] = numbers.at(shape);
                                          json["half_extents"] = three(renderer::half_extents(*shape));
                                          json["roundness"] = renderer::roundness(*shape);
                                      }},
                   body.shape);
        json["colour"] = three(body.colour);
    }
    return bodies;
}

Json links_json(const BuiltScene& scene) {
    Json links = Json::array();
    for (const Link& link : links_of(scene)) {
        Json json{{"a", link.body_a},
                  {"b", link.body_b},
                  {"point_a", three(link.point_a)},
                  {"point_b", three(link.point_b)},
                  {"radius", link.radius}};
        if (!link.half_pin.isZero(0.0)) json["half_pin"] = three(link.half_pin);
        if (link.spring_length) json["spring_length"] = *link.spring_length;
        links.push_back(std::move(json));
    }
    return links;
}

}  // namespace

std::vector<std::size_t> recorded_bodies(const BuiltScene& scene) {
    std::vector<std::size_t> bodies;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        if (scene.bodies[i].mass || scene.bodies[i].motion) bodies.push_back(i);
    }
    return bodies;
}

double size_of(const BuiltScene& scene, std::size_t body) {
    const double radius = body < scene.bodies.size() ? bounding_radius(scene.bodies[body]) : 0.0;
    return radius > 0.0 ? radius : 1.0;
}

Json camera_of(const View& view, std::span<const Ball> start) {
    return {{"eye", three(view.eye)},
            {"target", three(view.target)},
            {"field_of_view", view.field_of_view},
            {"across", reach_across(start, view)}};
}

Json stage_of(const ComparedRun& panel, const Simulation& simulation) {
    const BuiltScene& scene = simulation.scene();
    const renderer::Picture picture = draw_list(scene, panel.choices.frames.camera.view.value_or(scene.view));
    Json stage;
    stage["label"] = panel.label;
    stage["options"] = options_of(panel.choices);
    stage["gravity"] = three(scene.gravity);
    stage["bodies"] = bodies_of(scene, picture);
    stage["recorded"] = recorded_bodies(scene);
    stage["links"] = links_json(scene);
    stage["has_outside_forces"] = !scene.pokes.empty();
    if (picture.ground) stage["ground"] = picture.ground->height;
    stage["towards_sun"] = three(picture.towards_sun);
    return stage;
}

Json legend_of_arrows() {
    Json legend;
    for (const OverlayKind kind :
         {OverlayKind::contacts, OverlayKind::forces, OverlayKind::push, OverlayKind::velocities}) {
        for (const LegendEntry& entry : entries_of(kind)) {
            legend[std::string(name_of(kind))].push_back(
                {{"name", entry.name},
                 {"colour", {entry.colour.red, entry.colour.green, entry.colour.blue}},
                 {"unit", entry.unit}});
        }
    }
    return legend;
}

std::string polyhedra_of(const Simulation& simulation) {
    const renderer::Picture picture = draw_list(simulation.scene(), simulation.scene().view);
    const auto numbers = numbered_shapes(picture);
    std::vector<renderer::Polyhedron> shapes(numbers.size());
    for (const auto& [shape, number] : numbers) shapes[number] = shape;
    std::string bytes;
    for (const renderer::Polyhedron& shape : shapes) append_mesh(bytes, convex_mesh(*shape));
    return bytes;
}

std::string common_meshes() {
    std::string bytes;
    append_mesh(bytes, renderer::box_mesh());
    append_mesh(bytes, renderer::square_mesh());
    return bytes;
}

}  // namespace pushfactor::demos::pictures::replay
