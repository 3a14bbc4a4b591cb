// Forces and pushes at points of a scene, with the bodies between which they act, and the line of thrust: where the
// contact forces of pairs act as a whole.
#pragma once

#include "demos/runs/scene.h"

#include <utility>
#include <vector>

namespace pushfactor::demos::pictures {

// A contact point, an end of a distance or joint, or a force from outside, in the world's last step. Everything is
// as it acts on `body`.
struct Acting {
    enum class Kind { touching, within_margin, distance, joint, outside };

    Kind kind = Kind::touching;
    int body = 0;  // of a contact the movable one of the pair, else the upper one; of an end the body that it is on
    int other = 0;                                         // the other of the two; of a force from outside the same
    engine::Vector3 place = engine::Vector3::Zero();       // m, world frame, at the start of the step
    engine::Vector3 force = engine::Vector3::Zero();       // N, with friction, as it enters the momenta
    engine::Vector3 correcting = engine::Vector3::Zero();  // m/s, push for this step only
    engine::Vector3 lasting = engine::Vector3::Zero();     // m/s, push that enters the momenta
};

// Solution of a row of the last step [N], as it enters the momenta.
double lasting_force(const engine::World& world, std::size_t row);

// Forces of the scene on single bodies as they are now, at the points where they act.
std::vector<Acting> applied_in(const BuiltScene& scene);

// Whether the last step, if there was one, has left forces in rows or between bodies at rest.
bool any_forces(const BuiltScene& scene);

// Contacts, then the movable ends of distances, then those of joints. None before the first step.
std::vector<Acting> acting_in(const BuiltScene& scene);
// And then those of applied_in().
std::vector<Acting> all_acting_in(const BuiltScene& scene);

// Centre of pressure of two bodies that push each other in the world's last step: the mean of their contact points,
// weighted by the normal forces.
struct PressureCentre {
    int body_a = 0, body_b = 0;
    engine::Vector3 place = engine::Vector3::Zero();  // m
};
std::vector<PressureCentre> pressure_centres(const BuiltScene& scene);

// A segment within each movable body that two others push: from one centre to the other [m].
std::vector<std::pair<engine::Vector3, engine::Vector3>> line_of_thrust(const std::vector<PressureCentre>& centres,
                                                                        const BuiltScene& scene);

}  // namespace pushfactor::demos::pictures
