#include "demos/pictures/overlays/outside.h"

#include "engine/base/overloaded.h"

#include <cmath>
#include <map>

namespace pushfactor::demos::pictures {

using engine::Body;
using engine::Vector3;

namespace {

bool has_row_of(const engine::World& world, std::size_t row, std::size_t joint) {
    const engine::RowLabel& label = world.rows()[row].label;
    return label.kind == engine::RowKind::joint && label.point == static_cast<int>(joint);
}

// Radius at which the velocities of a turning body are shown [m]; planes have none.
double reach_of(const BodyDescription& body) {
    return std::holds_alternative<PlaneShape>(body.shape) ? 1.0 : bounding_radius(body);
}

}  // namespace

void add_applied_torques(const BuiltScene& scene, std::size_t kind, std::vector<Quantity>& found) {
    for (const engine::PokeForce* const source : scene.pokes) {
        if (!source->acts_at(scene.world.time())) continue;
        const Body& body = scene.world.bodies[static_cast<std::size_t>(source->poke().body)];
        const Vector3 torque = source->torque(body.orientation);
        if (!torque.isZero(0.0)) found.push_back({.place = body.position, .value = torque, .kind = kind});
    }
}

void add_motor_torques(const BuiltScene& scene, std::size_t kind, std::vector<Quantity>& found) {
    const engine::World& world = scene.world;
    const auto& lambda = world.lambda();
    std::size_t row = 0;
    for (const std::size_t acting : scene.joints->acting()) {
        const engine::Joint& joint = scene.joints->joints()[acting];
        while (!has_row_of(world, row, acting)) ++row;
        if (!joint.hinge || !joint.hinge->motor) continue;
        // The row of a motor is L [0, -u, 0, u], zero for a static body: its force times that is its torque.
        const std::size_t motor = row + engine::motor_row;
        const double force = lambda(static_cast<Eigen::Index>(motor), lambda.cols() - 1);
        const bool b_turns = !world.bodies[static_cast<std::size_t>(joint.body_b)].is_static();
        const engine::Jacobian& jacobian = world.rows()[motor].jacobian;
        const Vector3 torque = force * (b_turns ? jacobian.b : jacobian.a).tail<3>();
        found.push_back({.place = span_of(joint, world.bodies).to, .value = torque, .kind = kind});
    }
}

void add_moved_velocities(const BuiltScene& scene, std::size_t kind, std::vector<Quantity>& found) {
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        const Body& body = scene.world.bodies[i];
        if (!body.is_moved()) continue;
        const engine::Motion& motion = body.prescribed;
        found.push_back({.place = body.position, .value = motion.velocity, .kind = kind});
        if (motion.angular_velocity.isZero(0.0)) continue;
        const Vector3 u = reach_of(scene.bodies[i]) * motion.angular_velocity.unitOrthogonal();
        const Vector3 v = motion.angular_velocity.normalized().cross(u);
        for (const Vector3& arm : {u, v, Vector3(-u), Vector3(-v)}) {
            const Vector3 velocity = motion.velocity + motion.angular_velocity.cross(arm);
            found.push_back({.place = body.position + arm, .value = velocity, .kind = kind});
        }
    }
}

void add_untouching(const BuiltScene& scene, std::size_t kind_of_pairs, std::size_t kind_of_groups,
                    std::vector<Quantity>& found) {
    const auto& bodies = scene.world.bodies;
    for (const engine::collision::Pair& pair : scene.no_contacts) {
        const Vector3 from = bodies[static_cast<std::size_t>(pair.a)].position;
        const Vector3 to = bodies[static_cast<std::size_t>(pair.b)].position;
        found.push_back({.place = from, .value = to - from, .kind = kind_of_pairs});
    }
    std::map<std::string, std::vector<std::size_t>> groups;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        if (!scene.bodies[i].group.empty()) groups[scene.bodies[i].group].push_back(i);
    }
    for (const auto& [name, members] : groups) {
        Vector3 middle = Vector3::Zero();
        for (const std::size_t member : members) middle += bodies[member].position;
        middle /= static_cast<double>(members.size());
        for (const std::size_t member : members) {
            const Vector3& from = bodies[member].position;
            found.push_back({.place = from, .value = middle - from, .kind = kind_of_groups});
        }
    }
}

}  // namespace pushfactor::demos::pictures
