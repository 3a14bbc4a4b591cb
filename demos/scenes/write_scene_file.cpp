#include "demos/scenes/camera_file.h"
#include "demos/scenes/motions/motion_file.h"
#include "demos/scenes/scene_file.h"
#include "demos/scenes/scene_file_words.h"
#include "demos/scenes/state_file.h"
#include "demos/scenes/vector_json.h"

#include <cmath>

namespace pushfactor::demos {

namespace {

using engine::Distance;
using engine::Vector3;

using demos::to_json;  // of a vector

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
        if (body.moments) json["moments_of_inertia_kg_m2"] = to_json(*body.moments);
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
    if (body.motion) json["motion"] = motion_json(*body.motion);
    if (body.restitution != 0.0) json["restitution"] = body.restitution;
    if (!body.material.empty()) json["material"] = body.material;
    if (!body.group.empty()) json["group"] = body.group;
    if (!body.surface_velocity.isZero(0.0)) json["surface_velocity_m_per_s"] = to_json(body.surface_velocity);
    if (body.surface_from != 0.0) json["surface_from_s"] = body.surface_from;
    if (!body.measured_of.empty()) json["measured_of"] = body.measured_of;
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
    if (const auto& spring = distance.spring) {
        json["spring"] = {{"stiffness_n_per_m", spring->stiffness}, {"damping_n_s_per_m", spring->damping}};
    }
    return json;
}

Json to_json(const engine::Motor& motor) {
    if (const auto& servo = motor.servo) {
        return {{"target_angle_rad", servo->angle},
                {"stiffness_n_m_per_rad", servo->stiffness},
                {"damping_n_m_s_per_rad", servo->damping}};
    }
    Json json{{"speed_rad_per_s", motor.speed}};
    if (std::isfinite(motor.max_torque)) json["max_torque_n_m"] = motor.max_torque;
    return json;
}

Json to_json(const JointDescription& joint) {
    Json json{{"type", joint.hinge ? "hinge" : "ball"}, {"a", to_json(joint.a)}, {"b", to_json(joint.b)}};
    if (joint.collide) json["collide"] = true;
    if (!joint.hinge) return json;
    json["axis"] = to_json(joint.hinge->axis);
    if (const auto& q = joint.hinge->zero) json["zero_wxyz"] = Json::array({q->w(), q->x(), q->y(), q->z()});
    if (joint.hinge->motor) json["motor"] = to_json(*joint.hinge->motor);
    if (const auto& limits = joint.hinge->limits) json["limits_rad"] = Json::array({limits->low, limits->high});
    return json;
}

Json to_json(const ForceDescription& force) {
    Json json{{"body", force.body}, {"force_n", to_json(force.force)}, {"from_s", force.from}};
    if (!force.torque.isZero(0.0)) json["torque_n_m"] = to_json(force.torque);
    if (!force.point.isZero(0.0)) json["point_m"] = to_json(force.point);
    for (const auto& [name, frame] : frame_names) {
        if (frame == force.frame && frame != engine::Poke::Frame::world) json["frame"] = name;
    }
    if (force.until) json["until_s"] = *force.until;
    return json;
}

Json to_json(const std::pair<std::string, std::string>& bodies) {
    return Json::array({bodies.first, bodies.second});
}

Json to_json(const MaterialPairDescription& pair) {
    Json json{{"a", pair.a}, {"b", pair.b}};
    if (pair.friction) json["friction"] = *pair.friction;
    if (pair.restitution) json["restitution"] = *pair.restitution;
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
    put_list(json, "joints", scene.joints);
    put_list(json, "forces", scene.forces);
    if (scene.contacts) json["contacts"] = true;
    put_list(json, "no_contacts", scene.no_contacts);
    put_list(json, "material_pairs", scene.materials);
    if (scene.state) json["state"] = state_json(*scene.state, scene);
    for (const auto& [name, text] : scene.options) json["options"][name] = json_of(text);
    if (scene.has_camera) json["camera"] = camera_json(scene.view);
    for (const BodyDescription& body : scene.bodies) {
        if (body.colour) json["colours"][body.name] = *body.colour;
    }
    return json_text(json);
}

}  // namespace pushfactor::demos
