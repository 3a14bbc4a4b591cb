// Runs whose glTF files are tested.
#pragma once

#include "demos/options/choices.h"
#include "demos/runs/simulation.h"
#include "tests/demos/pictures/gltf/glb.h"
#include "tests/demos/program.h"

#include <array>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace pushfactor::tests {

// The file of a run in this process; `observe` is called with each state that has a key.
Glb recorded(const demos::Choices& choices, const std::function<void(const demos::Simulation&)>& observe = {});

// The lines of a trajectory by body and then by key: x, y, z, qw, qx, qy, qz.
using Trajectory = std::map<int, std::vector<std::array<double, 7>>>;

// How far two poses are apart: the largest difference of any coordinate, or of any part of the quaternions, whose
// sign has no meaning.
double apart(const std::array<double, 7>& a, const Vector3& position, const Quaternion& rotation);

// Half a second of a named scene, run as a user does.
struct Written {
    Folder folder;
    Trajectory trajectory;

    explicit Written(const std::string& scene);
};

std::vector<std::string> named_scenes();

}  // namespace pushfactor::tests
