// The bodies of a scene file.
#include "demos/scenes/reading/parts.h"

#include <fmt/format.h>

#include <numbers>

namespace pushfactor::demos {

namespace {

using engine::Vector3;

constexpr std::size_t most_bodies = 100000;

double read_length(const JsonReader& json) {
    return json.number(engine::least_length, engine::greatest_length);
}

BodyShape read_shape(const JsonReader& body) {
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
    static const std::array<std::pair<Keys, const char*>, std::variant_size_v<BodyShape>> by_shape{{
        {{"radius_m", "points_m", "obj_file"}, "left out: a box has size_m"},
        {{"size_m", "points_m", "obj_file"}, "left out: a sphere has radius_m"},
        {{"size_m", "radius_m", "points_m", "obj_file"}, "left out: a plane has no size"},
        {{"size_m", "radius_m"}, "left out: a polyhedron has points_m or obj_file"},
    }};
    const auto& [foreign, why] = by_shape[body.shape.index()];
    refuse_if_given(json, foreign, why);
    const bool plane = std::holds_alternative<PlaneShape>(body.shape);
    if (plane) refuse_if_given(json, {"mass_kg", "density_kg_per_m3"}, "left out: a plane is static");
    if (json.has("mass_kg")) refuse_if_given(json, {"density_kg_per_m3"}, "left out where mass_kg is given");
    if (plane || fixed) {
        refuse_if_given(
            json,
            {"mass_kg", "density_kg_per_m3", "moments_of_inertia_kg_m2", "velocity_m_per_s",
             "angular_velocity_rad_per_s", "linear_momentum_kg_m_per_s", "angular_momentum_kg_m2_per_s"},
            "left out of a static body");
    }
    for (const auto& [momentum, speed] : {std::pair{"linear_momentum_kg_m_per_s", "velocity_m_per_s"},
                                          {"angular_momentum_kg_m2_per_s", "angular_velocity_rad_per_s"}}) {
        if (json.has(momentum)) refuse_if_given(json, {speed}, "left out where the momentum is given");
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
    Fields fields(json);
    describe(fields, body);
    if (is_polyhedron) {
        give_polyhedron(body, polyhedron);
        polyhedra.by_body[body.name] = polyhedron;
    }
    return body;
}

}  // namespace

void describe(Fields& fields, BodyDescription& body) {
    const auto vector = &JsonReader::vector;
    const auto moments = [&](const JsonReader& json) { return read_moments(json, body); };
    const auto motion = [&](const JsonReader& json) {
        if (body.mass) json.refuse("left out of a body with a mass; \"static\": true makes it one without");
        return read_motion(json);
    };
    fields.if_any("moments_of_inertia_kg_m2", body.moments, moments);
    fields.may("position_m", body.position, vector);
    fields.may("orientation_wxyz", body.orientation, &JsonReader::rotation);
    fields.if_any("velocity_m_per_s", body.velocity, vector);
    fields.if_any("angular_velocity_rad_per_s", body.angular_velocity, vector);
    fields.if_any("linear_momentum_kg_m_per_s", body.linear_momentum, vector);
    fields.if_any("angular_momentum_kg_m2_per_s", body.angular_momentum, vector);
    fields.may("friction", body.friction, between(0.0, 100.0));
    fields.if_any("motion", body.motion, motion);
    fields.if_any("restitution", body.restitution, between(0.0, 1.0));
    fields.if_any("material", body.material, read_name);
    fields.if_any("group", body.group, read_name);
    fields.if_any("surface_velocity_m_per_s", body.surface_velocity, vector);
    fields.if_any("surface_from_s", body.surface_from, between(0.0, 1e9));
    fields.if_any("measured_of", body.measured_of, read_name);
}

std::vector<BodyDescription> read_bodies(const JsonReader& json, BodyNames& names, Polyhedra& polyhedra) {
    const std::vector<JsonReader> entries = json.elements();
    if (entries.size() > most_bodies) json.refuse(fmt::format("at most {} bodies", most_bodies));
    std::vector<BodyDescription> bodies;
    for (const JsonReader& entry : entries) {
        bodies.push_back(read_body(entry, polyhedra));
        const std::string& name = bodies.back().name;
        if (name.empty() || name == "world") entry.at("name").refuse("a name other than world");
        if (!names.emplace(name, !bodies.back().mass).second)
            entry.at("name").refuse("a name that no other body has");
    }
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const BodyDescription& body = bodies[i];
        if (body.measured_of.empty()) continue;
        if (!body.motion) entries[i].at("measured_of").refuse("left out of a body without a motion");
        const auto measured = names.find(body.measured_of);
        if (measured == names.end() || measured->second) {
            entries[i].at("measured_of").refuse("the name of a body with a mass");
        }
    }
    return bodies;
}

Json to_json(const BodyDescription& body) {
    Json json{{"name", body.name}};
    std::visit(engine::Overloaded{[&](const BoxShape& box) {
                                      json["shape"] = "box";
                                      json["size_m"] = to_json(box.size);
                                  },
                                  [&](const SphereShape& sphere) {
                                      json["shape"] = "sphere";
                                      json["radius_m"] = sphere.radius;
                                  },
                                  [&](const PlaneShape&) { json["shape"] = "plane"; },
                                  [&](const PolyhedronShape& polyhedron) {
                                      json["shape"] = "polyhedron";
                                      for (const Vector3& point : polyhedron.points()) {
                                          json["points_m"].push_back(to_json(point));
                                      }
                                  }},
               body.shape);
    if (body.mass) {
        json["mass_kg"] = *body.mass;
    } else if (!std::holds_alternative<PlaneShape>(body.shape)) {
        json["static"] = true;
    }
    Fields fields(json);
    BodyDescription rest = body;
    describe(fields, rest);
    return json;
}

const Keys& body_keys() {
    static const Keys keys = joined(
        {{"name", "shape", "size_m", "radius_m", "points_m", "obj_file", "mass_kg", "density_kg_per_m3", "static"},
         keys_of<BodyDescription>()});
    return keys;
}

}  // namespace pushfactor::demos
