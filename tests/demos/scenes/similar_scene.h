// Similar scenes: shifted, turned, mirrored, or with other units of length, time and mass. Their motion is that of
// the original under the same map.
#pragma once

#include "demos/options/settings.h"
#include "demos/scenes/scene_description.h"
#include "engine/bodies/body.h"

namespace pushfactor::tests {

// Maps a scene to a similar one: x -> turn mirror x * length + shift. Factors 1 and no movement map it to itself.
// Gravity is an acceleration, so it is unchanged where length = time^2.
struct Similarity {
    engine::Quaternion turn = engine::Quaternion::Identity();
    engine::Vector3 shift = engine::Vector3::Zero();  // m
    bool mirrored = false;                            // in the plane x = 0, before anything else
    double length = 1.0, mass = 1.0;                  // factors [1]
    demos::Rational time{1, 1};

    // Vectors: `unit` is the factor of their unit.
    engine::Vector3 direction(const engine::Vector3& v, double unit) const { return turn * in_body(v, unit); }
    engine::Vector3 position(const engine::Vector3& x) const { return direction(x, length) + shift; }
    // In the frame of a body, which is mirrored but not turned.
    engine::Vector3 in_body(const engine::Vector3& v, double unit) const {
        return unit * (mirrored ? engine::Vector3(-v.x(), v.y(), v.z()) : v);
    }
    // Of rotation; a mirror reverses it except for the part normal to the mirror.
    engine::Vector3 axial(const engine::Vector3& v, double unit) const { return turn * axial_in_body(v, unit); }
    engine::Vector3 axial_in_body(const engine::Vector3& v, double unit) const {
        return unit * (mirrored ? engine::Vector3(v.x(), -v.y(), -v.z()) : v);
    }
    engine::Quaternion orientation(const engine::Quaternion& q) const { return turn * mirrored_only(q); }
    engine::Quaternion mirrored_only(const engine::Quaternion& q) const {
        return mirrored ? engine::Quaternion(q.w(), q.x(), -q.y(), -q.z()) : q;
    }

    double speed() const { return length / time.value(); }
    double force() const { return mass * length / (time.value() * time.value()); }
    double angular_momentum() const { return mass * length * speed(); }

    engine::Body map(engine::Body body) const {
        body.position = position(body.position);
        body.orientation = orientation(body.orientation);
        body.linear_momentum = direction(body.linear_momentum, mass * speed());
        body.angular_momentum = axial(body.angular_momentum, angular_momentum());
        return body;
    }

    demos::Settings map(demos::Settings settings) const {
        settings.dt = settings.dt * time;
        settings.seconds *= time.value();
        settings.tolerance_high *= speed();
        settings.tolerance_low *= speed();
        return settings;
    }

    // Without view and measure, which do not affect the physics.
    demos::SceneDescription map(const demos::SceneDescription& scene) const {
        demos::SceneDescription other;
        other.name = scene.name;
        other.gravity = direction(scene.gravity, length / (time.value() * time.value()));
        other.contacts = scene.contacts;
        for (const auto& body : scene.bodies) other.bodies.push_back(map(body));
        for (const auto& distance : scene.distances) other.distances.push_back(map(distance));
        for (const auto& joint : scene.joints) other.joints.push_back(map(joint));
        for (const auto& force : scene.forces) other.forces.push_back(map(force));
        other.no_contacts = scene.no_contacts;
        other.materials = scene.materials;
        return other;
    }

  private:
    demos::BodyDescription map(demos::BodyDescription body) const {
        if (auto* box = std::get_if<demos::BoxShape>(&body.shape)) box->size *= length;
        if (auto* sphere = std::get_if<demos::SphereShape>(&body.shape)) sphere->radius *= length;
        if (body.mass) *body.mass *= mass;
        body.position = position(body.position);
        body.orientation = orientation(body.orientation);
        body.velocity = direction(body.velocity, speed());
        body.angular_velocity = axial(body.angular_velocity, 1.0 / time.value());
        if (body.linear_momentum) body.linear_momentum = direction(*body.linear_momentum, mass * speed());
        if (body.angular_momentum) body.angular_momentum = axial(*body.angular_momentum, angular_momentum());
        body.surface_velocity = in_body(body.surface_velocity, speed());
        body.surface_from *= time.value();
        return body;
    }

    template <typename Described>
    void map_ends(Described& described) const {
        for (demos::DistanceDescription::End* end : {&described.a, &described.b}) {
            end->point = end->body == "world" ? position(end->point) : in_body(end->point, length);
        }
    }

    demos::JointDescription map(demos::JointDescription joint) const {
        map_ends(joint);
        if (!joint.hinge) return joint;
        demos::HingeDescription& hinge = *joint.hinge;
        const bool to_world = joint.a.body == "world";
        hinge.axis = to_world ? axial(hinge.axis, 1.0) : axial_in_body(hinge.axis, 1.0);
        if (hinge.zero) {
            const engine::Quaternion q = mirrored_only(*hinge.zero);
            hinge.zero = to_world ? turn * q : joint.b.body == "world" ? q * turn.conjugate() : q;
        }
        if (hinge.motor) {
            hinge.motor->speed /= time.value();
            hinge.motor->max_torque *= force() * length;
        }
        return joint;
    }

    demos::DistanceDescription map(demos::DistanceDescription distance) const {
        map_ends(distance);
        if (distance.length) *distance.length *= length;
        if (distance.max_force) *distance.max_force *= force();
        if (distance.spring) {
            distance.spring->stiffness *= force() / length;
            distance.spring->damping *= force() / speed();
        }
        return distance;
    }

    demos::ForceDescription map(demos::ForceDescription poke) const {
        const bool turns = poke.frame == engine::Poke::Frame::body;
        poke.force = turns ? in_body(poke.force, force()) : direction(poke.force, force());
        poke.torque = turns ? axial_in_body(poke.torque, force() * length) : axial(poke.torque, force() * length);
        poke.point = in_body(poke.point, length);
        poke.from *= time.value();
        if (poke.until) *poke.until *= time.value();
        return poke;
    }
};

}  // namespace pushfactor::tests
