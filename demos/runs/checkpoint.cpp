#include "demos/runs/checkpoint.h"

namespace pushfactor::demos {

void take_checkpoint(const BuiltScene& scene, double parts, Checkpoint& into) {
    into.bodies = scene.world.bodies;
    into.state.time = scene.world.time();
    into.state.parts = parts;
    if (scene.distances) into.state.distance_forces = scene.distances->forces();
    if (scene.joints) {
        into.state.joint_forces = scene.joints->forces();
        into.state.joint_angles = scene.joints->angles();
    }
    if (scene.contacts) scene.contacts->all_forces(into.state.contact_forces);
    if (scene.world.rest) {
        const auto rest = scene.world.rest->memory();
        into.state.rest.assign(rest.begin(), rest.end());
    }
}

void restore(BuiltScene& scene, const RunState& state) {
    if (scene.distances) scene.distances->set_forces(state.distance_forces);
    if (scene.joints) {
        scene.joints->set_forces(state.joint_forces);
        if (!state.joint_angles.empty()) scene.joints->set_angles(state.joint_angles);
    }
    if (scene.contacts) scene.contacts->set_forces(state.contact_forces);
    if (scene.world.rest) scene.world.rest->set_memory(state.rest, scene.world.bodies);
    scene.world.resume(state.time);
}

void go_back(BuiltScene& scene, const Checkpoint& checkpoint) {
    scene.world.bodies = checkpoint.bodies;
    restore(scene, checkpoint.state);
}

void take_state(const engine::Body& body, BodyDescription& into) {
    into.position = body.position;
    into.orientation = body.orientation;
    if (body.is_static()) return;
    into.velocity.setZero();
    into.angular_velocity.setZero();
    into.linear_momentum = body.linear_momentum;
    into.angular_momentum = body.angular_momentum;
}

SceneDescription resumed(SceneDescription description, const BuiltScene& scene, const Checkpoint& checkpoint) {
    for (std::size_t i = 0; i < description.bodies.size(); ++i) {
        if (description.bodies[i].motion) continue;  // its pose is where its path begins
        take_state(checkpoint.bodies[i], description.bodies[i]);
    }
    // Lengths and angles that were taken from the start must not be taken from the current state.
    for (std::size_t i = 0; i < description.distances.size(); ++i) {
        description.distances[i].length = scene.distances->distances()[i].length;
    }
    for (std::size_t i = 0; i < description.joints.size(); ++i) {
        if (description.joints[i].hinge) description.joints[i].hinge->zero = scene.joints->joints()[i].hinge->zero;
    }
    description.state = std::make_shared<RunState>(checkpoint.state);
    description.options["start-kick"] = "off";
    return description;
}

}  // namespace pushfactor::demos
