#include "demos/scenes/camera_file.h"
#include "demos/scenes/scene_file.h"
#include "demos/scenes/scene_file_words.h"
#include "demos/scenes/state_file.h"

namespace pushfactor::demos {

namespace {

using engine::Distance;
using engine::Vector3;

Json to_json(const Vector3& v) {
    return Json::array({v.x(), v.y(), v.z()});
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
    json["position_m"] = to_json(body.position);
    const engine::Quaternion& q = body.orientation;
    json["orientation_wxyz"] = Json::array({q.w(), q.x(), q.y(), q.z()});
    if (!body.velocity.isZero(0.0)) json["velocity_m_per_s"] = to_json(body.velocity);
    if (!body.angular_velocity.isZero(0.0)) json["angular_velocity_rad_per_s"] = to_json(body.angular_velocity);
    if (body.linear_momentum) json["linear_momentum_kg_m_per_s"] = to_json(*body.linear_momentum);
    if (body.angular_momentum) json["angular_momentum_kg_m2_per_s"] = to_json(*body.angular_momentum);
    json["friction"] = body.friction;
    if (body.restitution != 0.0) json["restitution"] = body.restitution;
    if (!body.surface_velocity.isZero(0.0)) json["surface_velocity_m_per_s"] = to_json(body.surface_velocity);
    if (body.surface_from != 0.0) json["surface_from_s"] = body.surface_from;
    return json;
}

Json to_json(const DistanceDescription::End& end) {
    return {{"body", end.body}, {"point_m", to_json(end.point)}};
}

Json to_json(const DistanceDescription& distance) {
    Json json{{"a", to_json(distance.a)}, {"b", to_json(distance.b)}};
    if (distance.length) json["length_m"] = *distance.length;
    for (const auto& [name, acts] : act_names) {
        if (acts == distance.acts && acts != Distance::Acts::both) json["acts"] = name;
    }
    if (distance.max_force) json["max_force_n"] = *distance.max_force;
    return json;
}

Json to_json(const ForceDescription& force) {
    Json json{{"body", force.body}, {"force_n", to_json(force.force)}, {"from_s", force.from}};
    if (force.until) json["until_s"] = *force.until;
    return json;
}

template <typename Described>
void put_list(Json& json, const char* key, const std::vector<Described>& list) {
    if (list.empty()) return;
    json[key] = Json::array();
    for (const Described& described : list) json[key].push_back(to_json(described));
}

}  // namespace

std::string scene_file_text(const SceneDescription& scene) {
    Json json;
    json["version"] = scene_file_version;
    json["name"] = scene.name;
    if (!scene.gravity.isZero(0.0)) json["gravity_m_per_s2"] = to_json(scene.gravity);
    json["bodies"] = Json::array();
    put_list(json, "bodies", scene.bodies);
    put_list(json, "distance_constraints", scene.distances);
    put_list(json, "forces", scene.forces);
    if (scene.contacts) json["contacts"] = true;
    if (scene.state) json["state"] = state_json(*scene.state, scene);
    for (const auto& [name, text] : scene.options) json["options"][name] = json_of(text);
    if (scene.has_camera) json["camera"] = camera_json(scene.view);
    for (const BodyDescription& body : scene.bodies) {
        if (body.colour) json["colours"][body.name] = *body.colour;
    }
    return json.dump(2) + "\n";
}

}  // namespace pushfactor::demos
