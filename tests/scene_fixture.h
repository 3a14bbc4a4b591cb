// The project's own scenes for tests, with a few settings changed, and stepped.
#pragma once

#include "demos/runs/measurements.h"
#include "demos/runs/simulation.h"
#include "demos/scenes/catalogue.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <string_view>

namespace pushfactor::tests {

inline demos::Simulation simulate(
    std::string_view scene, const demos::Settings& settings,
    std::initializer_list<std::pair<std::string_view, std::string_view>> parameters = {}) {
    const demos::SceneEntry& entry = *demos::find_scene(scene);
    demos::ParameterValues values(entry.parameters);
    for (const auto& [name, text] : parameters) {
        for (const demos::Parameter& parameter : entry.parameters) {
            if (parameter.name == name) values.set(parameter, text);
        }
    }
    return demos::Simulation(demos::build_scene(entry.describe(values), settings), settings);
}

inline void advance(demos::Simulation& simulation, double seconds) {
    const long steps = std::lround(seconds / simulation.settings().dt.value());
    for (long i = 0; i < steps; ++i) simulation.advance();
}

// As good as an exact solver on these scenes: the sweep until nothing changes.
inline demos::Settings solved_exactly(demos::Settings settings) {
    settings.solver = "pgs";  // whole steps: what small steps leave is left to the next one
    settings.iterations = 20000;
    settings.tolerance_high = 1e-13;
    settings.tolerance_low = 1e-13;
    settings.warm_start = true;
    return settings;
}

// Of the last step [N].
inline double largest_joint_force(const engine::JointConstraints& joints) {
    double largest = 0.0;
    for (const engine::JointForce& force : joints.forces()) {
        largest = std::max(largest, engine::Vector3(force[0].last, force[1].last, force[2].last).norm());
    }
    return largest;
}

// A simulation with its measurements, as the program runs it.
struct Run {
    demos::Simulation simulation;
    demos::Measurements measurements;

    explicit Run(demos::Simulation&& start) : simulation(std::move(start)), measurements(simulation) {}
    void advance(double seconds) {
        const long steps = std::lround(seconds / simulation.settings().dt.value());
        for (long i = 0; i < steps; ++i) {
            simulation.advance();
            measurements.observe(simulation);
        }
    }
    double measured(const std::string& name) const {
        for (const auto& [known, value] : measurements.of_scene()) {
            if (known == name) return value.value();
        }
        throw std::out_of_range("no measure " + name);
    }
};

}  // namespace pushfactor::tests
