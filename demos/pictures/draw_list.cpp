#include "demos/pictures/draw_list.h"

#include "demos/base/text/errors.h"
#include "demos/pictures/camera/framing.h"
#include "demos/pictures/to_glm.h"
#include "engine/base/index.h"
#include "engine/collision/polyhedron.h"

#include <algorithm>
#include <limits>
#include <map>

namespace pushfactor::demos::pictures {

namespace {

using engine::Vector3;

void add_plane(const BuiltScene& scene, const engine::Body& body, renderer::Picture& picture) {
    if (is_level(body)) return;
    renderer::Panel panel;
    for (const Vector3& corner : plane_outline(scene, body)) panel.corners.push_back(to_glm(corner));
    if (!panel.corners.empty()) picture.panels.push_back(panel);
}

// Of the bodies with a mass that hang on it; infinite without.
template <typename Held>
double smallest_radius(const Held& held, const BuiltScene& scene) {
    double radius = std::numeric_limits<double>::infinity();
    for (const int end : {held.body_a, held.body_b}) {
        const std::size_t i = engine::at(end);
        if (i < scene.bodies.size() && scene.bodies[i].mass) {
            radius = std::min(radius, bounding_radius(scene.bodies[i]));
        }
    }
    return radius;
}

// Slender compared with its length and with the bodies that hang on it; a ball joint is drawn as a ball.
double bar_radius(const engine::Distance& distance, const BuiltScene& scene) {
    const double radius = is_ball_joint(distance) ? 0.04 : std::min(0.015 * distance.length, 0.04);
    return std::min(radius, 0.13 * smallest_radius(distance, scene));
}

void add_bar(const Vector3& from, const Vector3& to, double radius, renderer::Picture& picture) {
    picture.bars.push_back({.from = to_glm(from), .to = to_glm(to), .radius = static_cast<float>(radius)});
}

// A zigzag that closes as the spring is compressed.
void add_spring(const Vector3& from, const Vector3& to, double length, double radius, renderer::Picture& picture) {
    constexpr int bends = 10;
    const Vector3 along = to - from;
    const Vector3 aside = 0.06 * length * (along.norm() > 0.0 ? along.unitOrthogonal() : Vector3(Vector3::UnitX()));
    Vector3 last = from;
    for (int bend = 1; bend <= bends; ++bend) {
        const double share = (bend - 0.5) / bends;
        const Vector3 next = from + share * along + (bend % 2 == 0 ? aside : Vector3(-aside));
        add_bar(last, next, radius, picture);
        last = next;
    }
    add_bar(last, to, radius, picture);
}

void add_link(const BuiltScene& scene, const Link& link, renderer::Picture& picture) {
    const auto& bodies = scene.world.bodies;
    const auto [from, to] = engine::span_of(link, bodies);
    if (link.spring_length) {
        add_spring(from, to, *link.spring_length, link.radius, picture);
    } else {
        const Vector3 half = bodies[engine::at(link.body_a)].orientation * link.half_pin;
        add_bar(from - half, to + half, link.radius, picture);
    }
}

using Shapes = std::map<const engine::collision::PolyhedronMesh*, renderer::Polyhedron>;

// The shape of a polyhedron; bodies that share a mesh share it.
renderer::Polyhedron shape_of(const PolyhedronShape& polyhedron, Shapes& shapes) {
    renderer::Polyhedron& known = shapes[polyhedron.mesh.get()];
    if (known) return known;
    renderer::ConvexShape shape;
    const engine::collision::Hull& hull = polyhedron.mesh->hull();
    for (const Vector3& vertex : hull.vertices) shape.corners.push_back(to_glm(vertex));
    for (const engine::collision::HullFace& face : hull.faces) {
        std::vector<int>& loop = shape.faces.emplace_back();
        for (const auto& corner : hull.corners_of(face)) loop.push_back(corner.vertex);
    }
    return known = std::make_shared<const renderer::ConvexShape>(std::move(shape));
}

using Polygon = std::vector<Vector3>;

// Sutherland-Hodgman clipping: keeps the part on the side of `normal` of the plane through `point`.
Polygon clip(const Polygon& polygon, const Vector3& normal, const Vector3& point) {
    Polygon result;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vector3& from = polygon[i];
        const Vector3& to = polygon[(i + 1) % polygon.size()];
        const double in_from = normal.dot(from - point);
        const double in_to = normal.dot(to - point);
        if (in_from >= 0.0) result.push_back(from);
        if ((in_from >= 0.0) != (in_to >= 0.0))
            result.push_back(from + (to - from) * (in_from / (in_from - in_to)));
    }
    return result;
}

}  // namespace

Vector3 area_of(const Polygon& polygon) {
    Vector3 twice = Vector3::Zero();
    for (std::size_t i = 2; i < polygon.size(); ++i) {
        twice += (polygon[i - 1] - polygon[0]).cross(polygon[i] - polygon[0]);
    }
    return 0.5 * twice;
}

bool is_level(const engine::Body& plane) {
    return (plane.orientation * Vector3::UnitY()).y() > 0.9999;
}

std::optional<double> ground_height(const BuiltScene& scene) {
    std::optional<double> height = scene.view.floor;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        const engine::Body& body = scene.world.bodies[i];
        if (std::holds_alternative<PlaneShape>(scene.bodies[i].shape) && is_level(body)) height = body.position.y();
    }
    return height;
}

std::vector<Vector3> plane_outline(const BuiltScene& scene, const engine::Body& plane) {
    const engine::Matrix3 frame = plane.orientation.toRotationMatrix();
    const Vector3 up = frame.col(1);
    const double reach = distance_of(scene.view);
    const Vector3 middle = scene.view.target - up * up.dot(scene.view.target - plane.position);

    const Vector3 u = reach * frame.col(0);
    const Vector3 v = reach * frame.col(2);
    Polygon polygon{middle + u + v, middle + u - v, middle - u - v, middle - u + v};
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        const engine::Body& other = scene.world.bodies[i];
        if (&other == &plane || !std::holds_alternative<PlaneShape>(scene.bodies[i].shape)) continue;
        polygon = clip(polygon, other.orientation * Vector3::UnitY(), other.position);
    }
    // Cut at a rim that is inside the picture.
    polygon = clip(polygon, -Vector3::UnitY(), scene.view.target + Vector3(0, 0.09 * reach, 0));
    return area_of(polygon).norm() > 1e-4 * reach * reach ? polygon : Polygon{};
}

renderer::Picture draw_list(const BuiltScene& scene, const View& view) {
    renderer::Picture picture;
    picture.camera.eye = to_glm(view.eye);
    picture.camera.target = to_glm(view.target);
    picture.camera.vertical_field_of_view_degrees = static_cast<float>(view.field_of_view);
    std::optional<double> ground = ground_height(scene);
    if (!ground) ground = view.floor;
    if (ground) picture.ground = renderer::Ground{.height = static_cast<float>(*ground)};
    const std::vector<glm::vec3> colours = colours_of(scene);
    Shapes shapes;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        const BodyDescription& described = scene.bodies[i];
        const engine::Body& body = scene.world.bodies[i];
        const auto add = [&](decltype(renderer::Body::shape) shape) {
            picture.bodies.push_back({.position = to_glm(body.position),
                                      .orientation = to_glm(body.orientation),
                                      .shape = std::move(shape),
                                      .colour = colours[i],
                                      .index = i});
        };
        std::visit(engine::Overloaded{
                       [&](const BoxShape& box) { add(renderer::Box{to_glm(0.5 * box.size)}); },
                       [&](const SphereShape& sphere) { add(renderer::Sphere{static_cast<float>(sphere.radius)}); },
                       [&](const PlaneShape&) { add_plane(scene, body, picture); },
                       [&](const PolyhedronShape& polyhedron) { add(shape_of(polyhedron, shapes)); }},
                   described.shape);
    }
    for (const Link& link : links_of(scene)) add_link(scene, link, picture);
    return picture;
}

std::vector<glm::vec3> colours_of(const BuiltScene& scene) {
    std::vector<glm::vec3> colours;
    std::size_t movable = 0;  // without a colour of their own
    for (const BodyDescription& body : scene.bodies) {
        colours.push_back(to_glm(body.colour ? *find_colour(*body.colour)
                                 : body.mass ? palette[movable++ % palette.size()]
                                             : palette.back()));
    }
    return colours;
}

void require_drawable(const BuiltScene& scene) {
    constexpr double most = 1e12, least = 1e-12;  // m; squares of lengths are floats too
    for (const BodyDescription& body : scene.bodies) {
        const double size = bounding_radius(body);
        const bool is_plane = std::holds_alternative<PlaneShape>(body.shape);
        if (body.position.cwiseAbs().maxCoeff() <= most && (is_plane || (size >= least && size <= most))) continue;
        throw UsageError("{}: body {}: must be within 1e12 m of the origin, and of 1e-12 to 1e12 m, to be drawn",
                         scene.name, body.name);
    }
}

std::vector<Link> links_of(const BuiltScene& scene) {
    std::vector<Link> links;
    const double least = 0.0015 * distance_of(scene.view);  // m, visible from the scene's usual view
    if (scene.distances) {
        for (const engine::Distance& distance : scene.distances->distances()) {
            Link link{.body_a = distance.body_a,
                      .body_b = distance.body_b,
                      .point_a = distance.point_a,
                      .point_b = distance.point_b,
                      .radius = std::max(least, bar_radius(distance, scene))};
            if (distance.spring) link.spring_length = distance.length;
            links.push_back(link);
        }
    }
    if (!scene.joints) return links;
    for (const engine::Joint& joint : scene.joints->joints()) {
        const double size = smallest_radius(joint, scene);
        links.push_back({.body_a = joint.body_a,
                         .body_b = joint.body_b,
                         .point_a = joint.point_a,
                         .point_b = joint.point_b,
                         .half_pin = joint.hinge ? Vector3(0.5 * size * joint.hinge->axis) : Vector3::Zero(),
                         .radius = std::max(least, std::min(0.1 * size, 0.04))});
    }
    return links;
}

}  // namespace pushfactor::demos::pictures
