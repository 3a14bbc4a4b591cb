#include "demos/scenes/reading/connections.h"

#include "demos/scenes/reading/fields.h"
#include "demos/scenes/scene_file_words.h"

#include <cmath>
#include <numbers>

namespace pushfactor::demos {

namespace {

const Keys distance_keys{"a", "b", "length_m", "acts", "max_force_n", "spring"};
const Keys spring_keys{"stiffness_n_per_m", "damping_n_s_per_m"};
const Keys joint_keys{"type", "a", "b", "axis", "zero_wxyz", "motor", "limits_rad", "collide"};
const Keys motor_keys{"speed_rad_per_s", "max_torque_n_m", "target_angle_rad", "stiffness_n_m_per_rad",
                      "damping_n_m_s_per_rad"};
const Keys end_keys{"body", "point_m"};
const Keys force_keys{"body", "force_n", "torque_n_m", "point_m", "frame", "from_s", "until_s"};

DistanceDescription::End read_end(const JsonReader& json, const BodyNames& names) {
    json.require_object(end_keys);
    DistanceDescription::End end{.body = read_body_name(json.at("body"), names, true)};
    if (json.has("point_m")) end.point = json.at("point_m").vector();
    return end;
}

// Two ends of something, at least one of them on a movable body.
template <typename Described>
Described read_ends(const JsonReader& json, const BodyNames& names) {
    Described described{.a = read_end(json.at("a"), names), .b = read_end(json.at("b"), names)};
    if (described.a.body == described.b.body) json.at("b").at("body").refuse("another body than a");
    const auto is_static = [&](const std::string& name) { return name == "world" || names.at(name); };
    if (is_static(described.a.body) && is_static(described.b.body)) {
        json.at("b").at("body").refuse("a movable body, as a is static");
    }
    return described;
}

// Stiffness and damping; one of them must be above zero.
template <typename Made>
Made read_yielding(const JsonReader& json, const char* stiffness_key, const char* damping_key) {
    const auto number = [&](const char* key) { return json.has(key) ? json.at(key).number(0.0, 1e100) : 0.0; };
    Made made;
    made.stiffness = number(stiffness_key);
    made.damping = number(damping_key);
    if (std::max(made.stiffness, made.damping) < 1e-100) {
        json.refuse("given a stiffness or a damping from 1e-100 to 1e+100");
    }
    return made;
}

engine::Motor read_motor(const JsonReader& json) {
    json.require_object(motor_keys);
    if (json.has("target_angle_rad")) {
        refuse_if_given(json, {"speed_rad_per_s", "max_torque_n_m"}, "left out with target_angle_rad");
        auto servo = read_yielding<engine::Servo>(json, "stiffness_n_m_per_rad", "damping_n_m_s_per_rad");
        servo.angle = json.at("target_angle_rad").number(-1e6, 1e6);
        return {.servo = servo};
    }
    refuse_if_given(json, {"stiffness_n_m_per_rad", "damping_n_m_s_per_rad"}, "given with target_angle_rad");
    engine::Motor motor{.speed = json.at("speed_rad_per_s").number(-1e9, 1e9)};
    if (json.has("max_torque_n_m")) motor.max_torque = json.at("max_torque_n_m").positive();
    return motor;
}

engine::AngleLimits read_limits(const JsonReader& json) {
    const std::string allowed = "two angles from -6.2832 to 6.2832, the second from the first to a turn above it";
    const std::vector<double> limits = json.numbers(2, allowed);
    constexpr double turn = 2.0 * std::numbers::pi;
    const bool in_range = std::abs(limits[0]) <= turn && std::abs(limits[1]) <= turn;
    if (!in_range || limits[1] < limits[0] || limits[1] > limits[0] + turn) json.refuse(allowed);
    return {limits[0], limits[1]};
}

engine::Spring read_spring(const JsonReader& json) {
    json.require_object(spring_keys);
    return read_yielding<engine::Spring>(json, "stiffness_n_per_m", "damping_n_s_per_m");
}

}  // namespace

std::string read_body_name(const JsonReader& json, const BodyNames& names, bool or_world) {
    std::string name = json.string();
    if (!names.contains(name) && !(or_world && name == "world")) {
        json.refuse(or_world ? "the name of a body, or world" : "the name of a body");
    }
    return name;
}

JointDescription read_joint(const JsonReader& json, const BodyNames& names) {
    json.require_object(joint_keys);
    auto joint = read_ends<JointDescription>(json, names);
    const std::string type = json.at("type").string();
    if (json.has("collide")) joint.collide = json.at("collide").boolean();
    if (type == "ball") {
        refuse_if_given(json, {"axis", "zero_wxyz", "motor", "limits_rad"}, "left out: a ball joint has no axis");
        return joint;
    }
    if (type != "hinge") json.at("type").refuse("one of hinge, ball");
    HingeDescription& hinge = joint.hinge.emplace();
    hinge.axis = json.at("axis").vector();
    if (const double length = hinge.axis.norm(); !(length >= 1e-100 && length <= 1e100)) {
        json.at("axis").refuse("a vector from 1e-100 to 1e+100 long");
    }
    if (json.has("zero_wxyz")) hinge.zero = json.at("zero_wxyz").rotation();
    if (json.has("motor")) hinge.motor = read_motor(json.at("motor"));
    if (json.has("limits_rad")) hinge.limits = read_limits(json.at("limits_rad"));
    return joint;
}

DistanceDescription read_distance(const JsonReader& json, const BodyNames& names) {
    json.require_object(distance_keys);
    auto distance = read_ends<DistanceDescription>(json, names);
    if (json.has("length_m")) distance.length = json.at("length_m").not_negative();
    if (json.has("max_force_n")) distance.max_force = json.at("max_force_n").positive();
    if (json.has("acts")) distance.acts = read_word(json.at("acts"), act_names);
    if (json.has("spring")) {
        refuse_if_given(json, {"acts", "max_force_n"}, "left out of a spring");
        distance.spring = read_spring(json.at("spring"));
        if (distance.length == 0.0)
            json.at("length_m").refuse("above 0, as a spring of no length has no direction");
    }
    if (distance.length == 0.0 && (distance.acts != engine::Distance::Acts::both || distance.max_force)) {
        json.at("length_m").refuse("above 0, or it is a ball joint, which acts both ways and without max_force_n");
    }
    return distance;
}

ForceDescription read_force(const JsonReader& json, const BodyNames& names) {
    json.require_object(force_keys);
    ForceDescription force{.body = read_body_name(json.at("body"), names, false)};
    if (json.has("torque_n_m")) force.torque = json.at("torque_n_m").vector();
    if (json.has("force_n") || !json.has("torque_n_m")) force.force = json.at("force_n").vector();
    if (json.has("point_m")) {
        if (!json.has("force_n")) json.at("point_m").refuse("left out without force_n: a torque acts at no point");
        force.point = json.at("point_m").vector();
    }
    if (json.has("frame")) force.frame = read_word(json.at("frame"), frame_names);
    if (json.has("from_s")) force.from = json.at("from_s").number(0.0, 1e9);
    if (json.has("until_s")) force.until = json.at("until_s").number(force.from, 1e9);
    return force;
}

std::map<std::string, std::vector<std::string>> connection_keys() {
    return {{"distance_constraint", distance_keys},
            {"spring", spring_keys},
            {"joint", joint_keys},
            {"motor", motor_keys},
            {"end", end_keys},
            {"force", force_keys}};
}

}  // namespace pushfactor::demos
