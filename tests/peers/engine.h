// The interface of an engine in the comparison: builds a scene, steps it, reports the states of the bodies.
#pragma once

#include "tests/peers/scene.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace pushfactor::tests::peers {

class World {
  public:
    virtual ~World() = default;

    virtual void step() = 0;  // by the step of the scene, divided as the setting says

    // Of the movable bodies, in the scene's order; NaN where the engine gave up.
    virtual std::vector<State> states() const = 0;
};

// The model of a link: a distance between two points, or an arm that is fixed to body b and turns with it.
enum class Joint { distance, rigid_arm };

struct Setting {
    std::string engine;  // with its version
    std::string name;
    std::vector<std::string> cases;  // the cases and groups that this setting is for; none: all without a group
    Joint joint = Joint::distance;
    int substeps = 1;
    // By how much of an engine's own step the velocities lie before the positions: a half for x += dt v with the
    // new v, none for a Runge-Kutta method.
    double velocity_lag = 0.5;
    std::function<std::unique_ptr<World>(const Scene&)> build;
    std::string reference = {};  // its short name where the others are given as ratios to it
};

// An engine over a knob, for the plots of error against CPU time.
struct Series {
    std::string name;  // begins with the engine's
    std::string knob;
    std::vector<int> values;
    std::vector<std::string> cases;  // of error_cases() in sweeps.cpp
    std::function<Setting(int)> at;
};

// The result of a run: states at 0, 1, ... steps, and the CPU time of each step, us.
struct Run {
    std::vector<std::vector<State>> states;
    std::vector<double> step_us;
    Joint joint = Joint::distance;
    std::vector<double> velocity_lag;  // of each state, in whole steps
};

std::vector<Setting> bullet_settings();
std::vector<Setting> ode_settings();
std::vector<Setting> mujoco_settings();
std::vector<Setting> box3d_settings();
std::vector<Setting> jolt_settings();

std::vector<Series> bullet_series();
std::vector<Series> ode_series();
std::vector<Series> mujoco_series();
std::vector<Series> box3d_series();
std::vector<Series> jolt_series();

}  // namespace pushfactor::tests::peers
