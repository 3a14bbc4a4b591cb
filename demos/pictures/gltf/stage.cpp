#include "demos/pictures/gltf/stage.h"

#include "demos/pictures/camera/framing.h"
#include "demos/pictures/draw_list.h"

#include <array>
#include <cmath>
#include <numbers>

namespace pushfactor::demos::pictures::gltf {

namespace {

using engine::Quaternion;
using engine::Vector3;

// Half a side of the ground, in distances from eye to target: all of the picture up to its horizon would make a
// viewer that fits the scene into its window show little else.
constexpr double ground_reach = 2.0;

const Paint ground_paint{.colour = {0.68f, 0.69f, 0.69f}, .roughness = 1.0f};  // the renderer's
constexpr float darkening = 0.30f;  // of the dark octants of a ball, as in assets/shaders/sphere.frag

// Darker by the same share of light: sRGB is close to a power of 2.2.
Paint darker(const Paint& paint) {
    Paint dark = paint;
    dark.colour = paint.colour * std::pow(1.0f - darkening, 1.0f / 2.2f);
    return dark;
}

// Corners of the ground around the point of `plane` that the camera looks at, counter-clockwise from above [m].
std::vector<Vector3> ground_outline(const View& view, const Vector3& point, const Vector3& u, const Vector3& v) {
    const Vector3 up = v.cross(u);
    const Vector3 middle = view.target - up * up.dot(view.target - point);
    const double reach = ground_reach * distance_of(view);
    return {middle + reach * (u + v), middle + reach * (u - v), middle - reach * (u + v), middle - reach * (u - v)};
}

// Meshes of bodies, each shape once.
class Meshes {
  public:
    explicit Meshes(Document& document) : document_(document) {}

    int of(const renderer::Body& body) {
        const Paint paint{.colour = body.colour};
        return std::visit(
            engine::Overloaded{[&](const renderer::Box& box) {
                                   const glm::vec3& half = box.half_extents;
                                   const auto [known, is_new] = boxes_.try_emplace({half.x, half.y, half.z}, 0);
                                   if (is_new) known->second = document_.add_geometry(gltf::box(half));
                                   return document_.mesh(known->second, "box", {paint});
                               },
                               [&](const renderer::Sphere&) {
                                   if (ball_ < 0) ball_ = document_.add_geometry(ball());
                                   return document_.mesh(ball_, "ball", {paint, darker(paint)});
                               },
                               [&](const renderer::Polyhedron& shape) {
                                   const auto [known, is_new] = polyhedra_.try_emplace(*shape, 0);
                                   if (is_new) known->second = document_.add_geometry(polyhedron(*shape));
                                   return document_.mesh(known->second, "polyhedron", {paint});
                               }},
            body.shape);
    }

    // -1 if nothing of the plane is within view.
    int of_plane(const BuiltScene& scene, const engine::Body& plane) {
        const bool ground = is_level(plane);
        const engine::Matrix3 frame = plane.orientation.toRotationMatrix();
        std::vector<Vector3> corners = ground
                                           ? ground_outline(scene.view, plane.position, frame.col(0), frame.col(2))
                                           : plane_outline(scene, plane);
        if (corners.empty()) return -1;
        for (Vector3& corner : corners) corner = plane.orientation.conjugate() * (corner - plane.position);
        const renderer::Panel panel;
        const Paint translucent{.colour = panel.colour, .roughness = 1.0f, .opacity = panel.opacity};
        return document_.mesh(document_.add_geometry(polygon(corners)), "plane",
                              {ground ? ground_paint : translucent});
    }

  private:
    Document& document_;
    std::map<std::array<float, 3>, int> boxes_;
    std::map<renderer::ConvexShape, int, decltype(&renderer::before)> polyhedra_{renderer::before};
    int ball_ = -1;
};

}  // namespace

std::vector<int> add_bodies(const BuiltScene& scene, const renderer::Picture& picture, Document& document) {
    Meshes meshes(document);
    std::vector<int> nodes;
    auto drawn = picture.bodies.begin();  // has no planes
    bool has_ground = false;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        const BodyDescription& described = scene.bodies[i];
        const engine::Body& body = scene.world.bodies[i];
        Json node{{"name", described.name}};
        const bool plane = std::holds_alternative<PlaneShape>(described.shape);
        const int mesh = plane ? meshes.of_plane(scene, body) : meshes.of(*drawn++);
        if (mesh >= 0) node["mesh"] = mesh;
        node["translation"] = json_of_vector(body.position);
        node["rotation"] = json_of_quaternion(body.orientation);
        if (const auto* ball = std::get_if<SphereShape>(&described.shape)) {
            node["scale"] = json_of_vector(Vector3::Constant(ball->radius));
        }
        nodes.push_back(document.add_node(node));
        has_ground |= plane && is_level(body);
    }
    if (picture.ground && !has_ground) {
        const Vector3 point(0.0, picture.ground->height, 0.0);
        const std::vector<Vector3> corners = ground_outline(scene.view, point, Vector3::UnitX(), Vector3::UnitZ());
        const int mesh = document.mesh(document.add_geometry(polygon(corners)), "floor", {ground_paint});
        document.add_node({{"name", "floor"}, {"mesh", mesh}});
    }
    return nodes;
}

Segment segment_of(const renderer::Bar& bar) {
    return {to_eigen(bar.from), to_eigen(bar.to)};
}

Stretch stretch_of(const renderer::Bar& bar) {
    return {.origin = Stretch::Origin::middle,
            .per_length = Vector3(0.0, 0.5, 0.0),
            .fixed = Vector3::Constant(bar.radius)};
}

std::vector<int> add_bars(const renderer::Picture& picture, Document& document) {
    std::vector<int> nodes;
    if (picture.bars.empty()) return nodes;
    const int parent = document.add_node({{"name", "bars"}});
    int round = -1, straight = -1;  // geometries
    for (const renderer::Bar& bar : picture.bars) {
        const Segment at = segment_of(bar);
        const bool is_ball = (at.to - at.from).norm() < 2.0 * bar.radius;
        int& geometry = is_ball ? round : straight;
        if (geometry < 0) geometry = document.add_geometry(is_ball ? ball() : rod());
        const Paint paint{.colour = bar.colour};
        const int mesh = is_ball ? document.mesh(geometry, "bar, round", {paint, paint})
                                 : document.mesh(geometry, "bar", {paint});
        const std::string name = "bar " + std::to_string(nodes.size() + 1);
        const std::optional<Segment> key = at;
        nodes.push_back(
            document.add_node(node_at(name, mesh, stretched(std::span(&key, 1), stretch_of(bar))), parent));
    }
    return nodes;
}

Pose pose_of(const View& view) {
    const auto [right, up, forward] = axes_of(view);
    engine::Matrix3 axes;
    axes << right, up, -forward;
    return {view.eye, Quaternion(axes).normalized()};
}

int add_camera(const View& view, double aspect, Document& document) {
    const Pose pose = pose_of(view);
    const int node = document.add_node({{"name", "camera"},
                                        {"translation", json_of_vector(pose.position)},
                                        {"rotation", json_of_quaternion(pose.orientation)}});
    // As near as the renderer's, and beyond the ground's farthest corner.
    const double distance = distance_of(view);
    document.add_camera(node, view.field_of_view * std::numbers::pi / 180.0, aspect, 0.01 * distance,
                        8.0 * ground_reach * distance);
    return node;
}

void add_sun(const renderer::Picture& picture, Document& document) {
    const Vector3 towards = to_eigen(picture.towards_sun).normalized();
    const Vector3 target = to_eigen(picture.camera.target);
    const double distance = (target - to_eigen(picture.camera.eye)).norm();
    const int node =
        document.add_node({{"name", "sun"},
                           {"translation", json_of_vector(target + distance * towards)},
                           {"rotation", json_of_quaternion(rotation_between(Vector3::UnitZ(), towards))}});
    // sun_light of assets/shaders/light.frag is what a white surface that faces the sun sends back; a diffuse one
    // sends back a pi-th of what it gets.
    document.add_sun(node, {1.0f, 0.94f, 0.84f}, 1.25 * std::numbers::pi);
}

Json node_at(const std::string& name, int mesh, const Stretched& placed) {
    return {{"name", name},
            {"mesh", mesh},
            {"translation", json_of_floats(std::span(placed.translations).first(3))},
            {"rotation", json_of_floats(std::span(placed.rotations).first(4))},
            {"scale", json_of_floats(std::span(placed.scales).first(3))}};
}

}  // namespace pushfactor::demos::pictures::gltf
