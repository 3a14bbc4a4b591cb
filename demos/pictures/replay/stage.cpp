#include "demos/pictures/replay/stage.h"

#include "demos/options/simulation_options.h"
#include "demos/pictures/camera/plane_outline.h"
#include "demos/pictures/draw_list.h"
#include "demos/pictures/overlays/legend.h"
#include "demos/pictures/replay/bytes.h"
#include "renderer/meshes/meshes.h"

#include <algorithm>
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
class Shapes {
  public:
    explicit Shapes(const renderer::Picture& picture) {
        for (const renderer::Polyhedron& polyhedron : picture.polyhedra) {
            if (numbers_.try_emplace(polyhedron.shape.get(), shapes_.size()).second) {
                shapes_.push_back(polyhedron.shape.get());
            }
        }
    }
    const std::vector<const renderer::ConvexShape*>& all() const { return shapes_; }
    std::size_t number_of(const renderer::ConvexShape* shape) const { return numbers_.at(shape); }

  private:
    std::map<const renderer::ConvexShape*, std::size_t> numbers_;
    std::vector<const renderer::ConvexShape*> shapes_;
};

Json options_of(const Choices& choices) {
    Json options = Json::object();
    options["preset"] = choices.settings.preset;
    for (const SimulationOption& option : simulation_options()) {
        const std::string text = option.get(choices.settings);
        if (!text.empty()) options[std::string(option.name)] = text;
    }
    for (const auto& [name, text] : choices.parameters) options[name] = text;
    return options;
}

// Shapes and colours come from the picture that the renderer would draw, which has the bodies in order.
Json bodies_of(const BuiltScene& scene, const renderer::Picture& picture) {
    const Shapes shapes(picture);
    auto box = picture.boxes.begin();
    auto sphere = picture.spheres.begin();
    auto polyhedron = picture.polyhedra.begin();
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
        if (i >= scene.bodies.size()) {
            json["name"] = "world";
            bodies.push_back(std::move(json));
            continue;
        }
        json["name"] = scene.bodies[i].name;
        std::visit(engine::Overloaded{[&](const BoxShape&) {
                                          json["box"] = three(box->half_extents);
                                          json["colour"] = three((box++)->colour);
                                      },
                                      [&](const SphereShape&) {
                                          json["sphere"] = sphere->radius;
                                          json["colour"] = three((sphere++)->colour);
                                      },
                                      [&](const PlaneShape&) {
                                          Json corners = Json::array();
                                          for (const Vector3& corner : plane_outline(scene, body)) {
                                              corners.push_back(three(corner));
                                          }
                                          json["plane"] = corners;
                                      },
                                      [&](const PolyhedronShape&) {
                                          json["polyhedron"] = shapes.number_of(polyhedron->shape.get());
                                          json["half_extents"] = three(renderer::half_extents(*polyhedron->shape));
                                          json["roundness"] = renderer::roundness(*polyhedron->shape);
                                          json["colour"] = three((polyhedron++)->colour);
                                      }},
                   scene.bodies[i].shape);
        bodies.push_back(std::move(json));
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
            {"across", reach_of(start, view).across}};
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
    const Shapes shapes(picture);
    std::string bytes;
    for (const renderer::ConvexShape* const shape : shapes.all()) append_mesh(bytes, convex_mesh(*shape));
    return bytes;
}

std::string common_meshes() {
    std::string bytes;
    append_mesh(bytes, renderer::box_mesh());
    append_mesh(bytes, renderer::square_mesh());
    return bytes;
}

}  // namespace pushfactor::demos::pictures::replay
