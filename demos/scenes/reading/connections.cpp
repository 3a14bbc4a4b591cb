// What acts on the bodies of a scene file: distances and springs, joints, forces.
#include "demos/scenes/reading/parts.h"

#include <cmath>
#include <numbers>

namespace pushfactor::demos {

using engine::Distance;
using engine::Poke;
using End = DistanceDescription::End;

void describe(Fields& fields, engine::Spring& spring) {
    fields.may("stiffness_n_per_m", spring.stiffness, between(0.0, 1e100));
    fields.may("damping_n_s_per_m", spring.damping, between(0.0, 1e100));
}

void describe(Fields& fields, engine::Servo& servo) {
    fields.must("target_angle_rad", servo.angle, between(-1e6, 1e6));
    fields.may("stiffness_n_m_per_rad", servo.stiffness, between(0.0, 1e100));
    fields.may("damping_n_m_s_per_rad", servo.damping, between(0.0, 1e100));
}

void describe(Fields& fields, engine::Motor& motor) {
    if (motor.servo) return describe(fields, *motor.servo);
    fields.must("speed_rad_per_s", motor.speed, between(-1e9, 1e9));
    fields.may("max_torque_n_m", motor.max_torque, &JsonReader::positive, std::isfinite(motor.max_torque));
    if (fields.are_listed()) describe(fields, motor.servo.emplace());
}

void describe(Fields& fields, End& end) {
    fields.must("body", end.body, &JsonReader::string);
    fields.may("point_m", end.point, &JsonReader::vector);
}

namespace {

constexpr std::array<std::pair<const char*, Distance::Acts>, 3> act_names{
    {{"both", Distance::Acts::both}, {"pulls", Distance::Acts::pulls}, {"pushes", Distance::Acts::pushes}}};
constexpr std::array<std::pair<const char*, Poke::Frame>, 2> frame_names{
    {{"world", Poke::Frame::world}, {"body", Poke::Frame::body}}};

engine::Vector3 read_axis(const JsonReader& json) {
    const engine::Vector3 axis = json.vector();
    if (!(axis.norm() >= 1e-100 && axis.norm() <= 1e100)) json.refuse("a vector from 1e-100 to 1e+100 long");
    return axis;
}

engine::AngleLimits read_limits(const JsonReader& json) {
    const std::string allowed = "two angles from -6.2832 to 6.2832, the second from the first to a turn above it";
    const std::vector<double> limits = json.numbers(2, allowed);
    constexpr double turn = 2.0 * std::numbers::pi;
    const bool in_range = std::abs(limits[0]) <= turn && std::abs(limits[1]) <= turn;
    if (!in_range || limits[1] < limits[0] || limits[1] > limits[0] + turn) json.refuse(allowed);
    return {limits[0], limits[1]};
}

// Of a spring or a servo, which gives way; stiffness or damping must be above zero.
template <typename Made>
Made read_yielding(const JsonReader& json) {
    const auto made = read_object<Made>(json);
    if (std::max(made.stiffness, made.damping) < 1e-100) {
        json.refuse("given a stiffness or a damping from 1e-100 to 1e+100");
    }
    return made;
}

engine::Motor read_motor(const JsonReader& json) {
    json.require_object(keys_of<engine::Motor>());
    if (json.has("target_angle_rad")) {
        refuse_if_given(json, {"speed_rad_per_s", "max_torque_n_m"}, "left out with target_angle_rad");
        return {.servo = read_yielding<engine::Servo>(json)};
    }
    refuse_if_given(json, {"stiffness_n_m_per_rad", "damping_n_m_s_per_rad"}, "given with target_angle_rad");
    return read_object<engine::Motor>(json);
}

// At least one of the two ends must be on a movable body.
void require_ends(const JsonReader& json, const BodyNames& names) {
    const std::string a = read_body_name(json.at("a").at("body"), names, true);
    const std::string b = read_body_name(json.at("b").at("body"), names, true);
    if (a == b) json.at("b").at("body").refuse("another body than a");
    const auto is_static = [&](const std::string& name) { return name == "world" || names.at(name); };
    if (is_static(a) && is_static(b)) json.at("b").at("body").refuse("a movable body, as a is static");
}

void to_body_frame(End& end, const Polyhedra& polyhedra) {
    if (const FramedPolyhedron* const polyhedron = polyhedra.of(end.body))
        end.point = polyhedron->to_body(end.point);
}

}  // namespace

void describe(Fields& fields, DistanceDescription& distance) {
    fields.must("a", distance.a, read_object<End>);
    fields.must("b", distance.b, read_object<End>);
    fields.if_any("length_m", distance.length, &JsonReader::not_negative);
    fields.word("acts", distance.acts, act_names);
    fields.if_any("max_force_n", distance.max_force, &JsonReader::positive);
    fields.if_any("spring", distance.spring, read_yielding<engine::Spring>);
}

void describe(Fields& fields, HingeDescription& hinge) {
    fields.must("axis", hinge.axis, read_axis);
    fields.if_any("zero_wxyz", hinge.zero, &JsonReader::rotation);
    fields.if_any("motor", hinge.motor, read_motor);
    fields.if_any("limits_rad", hinge.limits, read_limits);
}

void describe(Fields& fields, JointDescription& joint) {
    std::string type = joint.hinge ? "hinge" : "ball";
    fields.must("type", type, &JsonReader::string);
    fields.must("a", joint.a, read_object<End>);
    fields.must("b", joint.b, read_object<End>);
    fields.if_any("collide", joint.collide, &JsonReader::boolean);
    if (type == "hinge" || fields.are_listed())
        describe(fields, joint.hinge ? *joint.hinge : joint.hinge.emplace());
}

void describe(Fields& fields, ForceDescription& force) {
    fields.must("body", force.body, &JsonReader::string);
    fields.may("force_n", force.force, &JsonReader::vector);
    fields.may("from_s", force.from, between(0.0, 1e9));
    fields.if_any("torque_n_m", force.torque, &JsonReader::vector);
    fields.if_any("point_m", force.point, &JsonReader::vector);
    fields.word("frame", force.frame, frame_names);
    fields.if_any("until_s", force.until, between(force.from, 1e9));
}

std::string read_body_name(const JsonReader& json, const BodyNames& names, bool or_world) {
    std::string name = json.string();
    if (!names.contains(name) && !(or_world && name == "world")) {
        json.refuse(or_world ? "the name of a body, or world" : "the name of a body");
    }
    return name;
}

DistanceDescription read_distance(const JsonReader& json, const BodyNames& names, const Polyhedra& polyhedra) {
    auto distance = read_object<DistanceDescription>(json);
    require_ends(json, names);
    if (distance.spring) {
        refuse_if_given(json, {"acts", "max_force_n"}, "left out of a spring");
        if (distance.length == 0.0)
            json.at("length_m").refuse("above 0, as a spring of no length has no direction");
    }
    if (distance.length == 0.0 && (distance.acts != Distance::Acts::both || distance.max_force)) {
        json.at("length_m").refuse("above 0, or it is a ball joint, which acts both ways and without max_force_n");
    }
    to_body_frame(distance.a, polyhedra);
    to_body_frame(distance.b, polyhedra);
    return distance;
}

JointDescription read_joint(const JsonReader& json, const BodyNames& names, const Polyhedra& polyhedra) {
    auto joint = read_object<JointDescription>(json);
    require_ends(json, names);
    const std::string type = json.at("type").string();
    if (type == "ball") {
        refuse_if_given(json, {"axis", "zero_wxyz", "motor", "limits_rad"}, "left out: a ball joint has no axis");
    } else if (type != "hinge") {
        json.at("type").refuse("one of hinge, ball");
    }
    to_body_frame(joint.a, polyhedra);
    to_body_frame(joint.b, polyhedra);
    if (!joint.hinge) return joint;
    auto& [axis, zero, motor, limits] = *joint.hinge;
    if (const FramedPolyhedron* const a = polyhedra.of(joint.a.body)) {
        axis = a->axes.conjugate() * axis;
        if (zero) zero = a->axes.conjugate() * *zero;
    }
    const FramedPolyhedron* const b = polyhedra.of(joint.b.body);
    if (b && zero) zero = *zero * b->axes;
    return joint;
}

ForceDescription read_force(const JsonReader& json, const BodyNames& names, const Polyhedra& polyhedra) {
    auto force = read_object<ForceDescription>(json);
    if (names.at(read_body_name(json.at("body"), names, false))) {
        json.at("body").refuse("a body with a mass: no force moves a static one");
    }
    if (!json.has("torque_n_m")) json.at("force_n");  // one of both must be there
    if (json.has("point_m") && !json.has("force_n")) {
        json.at("point_m").refuse("left out without force_n: a torque acts at no point");
    }
    const FramedPolyhedron* const polyhedron = polyhedra.of(force.body);
    if (!polyhedron) return force;
    // Without a point a force acts at the centre of mass.
    if (json.has("point_m")) force.point = polyhedron->to_body(force.point);
    if (force.frame == Poke::Frame::body) {
        force.force = polyhedron->axes.conjugate() * force.force;
        force.torque = polyhedron->axes.conjugate() * force.torque;
    }
    return force;
}

KeysByObject connection_keys() {
    return {{"distance_constraint", keys_of<DistanceDescription>()},
            {"spring", keys_of<engine::Spring>()},
            {"joint", keys_of<JointDescription>()},
            {"motor", keys_of<engine::Motor>()},
            {"end", keys_of<End>()},
            {"force", keys_of<ForceDescription>()}};
}

}  // namespace pushfactor::demos
