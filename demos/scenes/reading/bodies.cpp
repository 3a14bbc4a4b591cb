#include "demos/scenes/reading/bodies.h"

#include "demos/scenes/motions/motion_file.h"
#include "demos/scenes/reading/fields.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace pushfactor::demos {

namespace {

using engine::Vector3;

constexpr std::size_t most_bodies = 100000;

double read_length(const JsonReader& json) {
    return json.number(engine::least_length, engine::greatest_length);
}

decltype(BodyDescription::shape) read_shape(const JsonReader& body) {
    const JsonReader shape = body.at("shape");
    const std::string name = shape.string();
    if (name == "plane") return PlaneShape{};
    if (name == "polyhedron") return PolyhedronShape{};  // read_body() gives it its points
    if (name == "sphere") return SphereShape{read_length(body.at("radius_m"))};
    if (name != "box") shape.refuse("one of box, sphere, plane, polyhedron");
    const JsonReader size = body.at("size_m");
    const std::vector<JsonReader> edges = size.elements();
    if (edges.size() != 3) size.refuse("three numbers [x, y, z]");
    return BoxShape{{read_length(edges[0]), read_length(edges[1]), read_length(edges[2])}};
}

// A key that would be ignored is refused: it was meant for something.
void refuse_foreign_keys(const JsonReader& json, const BodyDescription& body, bool fixed) {
    const bool plane = std::holds_alternative<PlaneShape>(body.shape);
    std::visit(
        engine::Overloaded{
            [&](const BoxShape&) {
                refuse_if_given(json, {"radius_m", "points_m", "obj_file"}, "left out: a box has size_m");
            },
            [&](const SphereShape&) {
                refuse_if_given(json, {"size_m", "points_m", "obj_file"}, "left out: a sphere has radius_m");
            },
            [&](const PlaneShape&) {
                refuse_if_given(json, {"size_m", "radius_m", "points_m", "obj_file"},
                                "left out: a plane has no size");
            },
            [&](const PolyhedronShape&) {
                refuse_if_given(json, {"size_m", "radius_m"}, "left out: a polyhedron has points_m or obj_file");
            }},
        body.shape);
    if (plane) refuse_if_given(json, {"mass_kg", "density_kg_per_m3"}, "left out: a plane is static");
    if (json.has("mass_kg")) {
        refuse_if_given(json, {"density_kg_per_m3"}, "left out where mass_kg is given");
    }
    if (plane || fixed) {
        refuse_if_given(
            json,
            {"mass_kg", "density_kg_per_m3", "moments_of_inertia_kg_m2", "velocity_m_per_s",
             "angular_velocity_rad_per_s", "linear_momentum_kg_m_per_s", "angular_momentum_kg_m2_per_s"},
            "left out of a static body");
    }
    if (json.has("linear_momentum_kg_m_per_s")) {
        refuse_if_given(json, {"velocity_m_per_s"}, "left out where the momentum is given");
    }
    if (json.has("angular_momentum_kg_m2_per_s")) {
        refuse_if_given(json, {"angular_velocity_rad_per_s"}, "left out where the momentum is given");
    }
}

double read_mass(const JsonReader& json, const BodyDescription& body) {
    if (!json.has("density_kg_per_m3")) return json.at("mass_kg").number(engine::least_mass, engine::greatest_mass);
    const JsonReader density = json.at("density_kg_per_m3");
    const double volume =
        std::visit(engine::Overloaded{[](const BoxShape& box) { return box.size.prod(); },
                                      [](const SphereShape& sphere) {
                                          return 4.0 / 3.0 * std::numbers::pi *
                                                 (sphere.radius * sphere.radius * sphere.radius);
                                      },
                                      [](const PlaneShape&) { return 0.0; },
                                      [](const PolyhedronShape& polyhedron) { return polyhedron.volume; }},
                   body.shape);
    const double mass = density.positive() * volume;
    if (!(mass >= engine::least_mass && mass <= engine::greatest_mass)) {
        density.refuse(
            fmt::format("such that the mass is from {:g} to {:g} kg", engine::least_mass, engine::greatest_mass));
    }
    return mass;
}

// Of a box or a ball, whose axes are principal ones.
Vector3 read_moments(const JsonReader& json, const BodyDescription& body) {
    if (std::holds_alternative<PolyhedronShape>(body.shape)) {
        json.refuse("left out of a polyhedron, which is uniform");
    }
    const Vector3 moments = json.vector();
    const double smallest = engine::least_length * engine::least_length * *body.mass,
                 largest = engine::greatest_length * engine::greatest_length * *body.mass;
    const bool is_of_a_body = moments.maxCoeff() <= 0.5 * moments.sum() * (1.0 + 1e-9);
    if (!(moments.minCoeff() >= smallest && moments.maxCoeff() <= largest && is_of_a_body)) {
        json.refuse("three numbers above 0, none larger than the sum of the others");
    }
    return moments;
}

BodyDescription read_body(const JsonReader& json, Polyhedra& polyhedra) {
    json.require_object(body_keys());
    BodyDescription body{.name = json.at("name").string(), .shape = read_shape(json)};
    const bool fixed = json.has("static") && json.at("static").boolean();
    refuse_foreign_keys(json, body, fixed);
    const bool is_polyhedron = std::holds_alternative<PolyhedronShape>(body.shape);
    FramedPolyhedron polyhedron;
    if (is_polyhedron) {
        polyhedron = read_polyhedron(json, polyhedra);
        body.shape = polyhedron.shape;
    }
    if (!fixed && !std::holds_alternative<PlaneShape>(body.shape)) body.mass = read_mass(json, body);

    if (json.has("moments_of_inertia_kg_m2")) {
        body.moments = read_moments(json.at("moments_of_inertia_kg_m2"), body);
    }
    if (json.has("motion")) {
        if (body.mass)
            json.at("motion").refuse("left out of a body with a mass; \"static\": true makes it one without");
        body.motion = read_motion(json.at("motion"));
    }

    const auto vector = [&json](const char* key, Vector3& into) {
        if (json.has(key)) into = json.at(key).vector();
    };
    vector("position_m", body.position);
    if (json.has("orientation_wxyz")) body.orientation = json.at("orientation_wxyz").rotation();
    vector("velocity_m_per_s", body.velocity);
    vector("angular_velocity_rad_per_s", body.angular_velocity);
    vector("surface_velocity_m_per_s", body.surface_velocity);
    if (json.has("surface_from_s")) body.surface_from = json.at("surface_from_s").number(0.0, 1e9);
    if (json.has("linear_momentum_kg_m_per_s"))
        body.linear_momentum = json.at("linear_momentum_kg_m_per_s").vector();
    if (json.has("angular_momentum_kg_m2_per_s"))
        body.angular_momentum = json.at("angular_momentum_kg_m2_per_s").vector();
    if (json.has("friction")) body.friction = json.at("friction").number(0.0, 100.0);
    if (json.has("restitution")) body.restitution = json.at("restitution").number(0.0, 1.0);
    if (json.has("material")) body.material = read_name(json.at("material"));
    if (json.has("group")) body.group = read_name(json.at("group"));
    if (json.has("measured_of")) body.measured_of = read_name(json.at("measured_of"));
    if (is_polyhedron) {
        give_polyhedron(body, polyhedron);
        polyhedra.by_body[body.name] = polyhedron;
    }
    return body;
}

}  // namespace

void read_bodies(const JsonReader& json, SceneDescription& scene, BodyNames& names, Polyhedra& polyhedra) {
    const std::vector<JsonReader> bodies = json.elements();
    if (bodies.size() > most_bodies) json.refuse(fmt::format("at most {} bodies", most_bodies));
    for (const JsonReader& body : bodies) {
        scene.bodies.push_back(read_body(body, polyhedra));
        const std::string& name = scene.bodies.back().name;
        if (name.empty() || name == "world") body.at("name").refuse("a name other than world");
        if (!names.emplace(name, !scene.bodies.back().mass).second)
            body.at("name").refuse("a name that no other body has");
    }
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const BodyDescription& body = scene.bodies[i];
        if (body.measured_of.empty()) continue;
        if (!body.motion) bodies[i].at("measured_of").refuse("left out of a body without a motion");
        const auto measured = names.find(body.measured_of);
        if (measured == names.end() || measured->second) {
            bodies[i].at("measured_of").refuse("the name of a body with a mass");
        }
    }
}

const std::vector<std::string>& body_keys() {
    static const Keys keys{"name",
                           "shape",
                           "size_m",
                           "radius_m",
                           "points_m",
                           "obj_file",
                           "mass_kg",
                           "density_kg_per_m3",
                           "moments_of_inertia_kg_m2",
                           "static",
                           "motion",
                           "position_m",
                           "orientation_wxyz",
                           "velocity_m_per_s",
                           "angular_velocity_rad_per_s",
                           "linear_momentum_kg_m_per_s",
                           "angular_momentum_kg_m2_per_s",
                           "friction",
                           "restitution",
                           "material",
                           "group",
                           "surface_velocity_m_per_s",
                           "surface_from_s",
                           "measured_of"};
    return keys;
}

}  // namespace pushfactor::demos
