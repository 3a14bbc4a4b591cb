// The line of thrust: where the contact forces of pairs act as a whole.
#pragma once

#include "demos/runs/scene.h"

#include <utility>
#include <vector>

namespace pushfactor::demos::pictures {

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
