// How the bodies of a run moved, from its trajectory.
//
// Symbols: x position [m], v velocity [m/s], w angular velocity [rad/s], in the world frame.
#pragma once

#include "demos/reports/stability/measures/measures.h"

#include <vector>

namespace pushfactor::demos::reports::stability {

struct State {
    double time = 0.0;  // s
    engine::Vector3 x, v, w;
    engine::Quaternion orientation;
};

// One movable body at every moment of the trajectory.
struct Track {
    const BodyDescription* body = nullptr;
    std::vector<State> states{};

    double step() const { return states[1].time - states[0].time; }  // s
};

// In the order of the scene.
std::vector<Track> tracks(const Evidence& evidence);

}  // namespace pushfactor::demos::reports::stability
