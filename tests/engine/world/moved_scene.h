// Static bodies that are moved, and what stands on them.
#pragma once

#include "engine/bodies/path.h"
#include "tests/engine/contact_scene.h"

#include <array>
#include <memory>
#include <numbers>

namespace pushfactor::tests {

using namespace engine;

inline constexpr double g = 10.0;
using std::numbers::pi;

inline Place place_of(const Body& body) {
    return {body.position, body.orientation};
}

inline void move(ContactScene& scene, int body, const Motion& motion, const PathTimes& times = {}) {
    const Body& own = scene.world.bodies[static_cast<std::size_t>(body)];
    scene.world.move(body, std::make_unique<SteadyPath>(place_of(own), motion, times));
}

inline void shake(ContactScene& scene, int body, const Vector3& amplitude, double frequency, double phase) {
    const Body& own = scene.world.bodies[static_cast<std::size_t>(body)];
    scene.world.move(body, std::make_unique<Oscillation>(place_of(own), amplitude, frequency, phase, PathTimes{}));
}

inline Quaternion turned(double angle, const Vector3& axis = Vector3::UnitY()) {
    return Quaternion(Eigen::AngleAxisd(angle, axis));
}

enum class Under { plate, plane, ball };

// What moves is body 0, its surface at height 0.
inline void add_under(ContactScene& scene, Under what, const Surface& surface = {}) {
    switch (what) {
        case Under::plate:
            scene.add_plate({4, 1, 4}, {0, -0.5, 0}, surface);
            break;
        case Under::plane:
            scene.add_ground(surface);
            break;
        case Under::ball:
            scene.add(static_body({0, -2, 0}), collision::Sphere{2.0}, surface);
    }
}

inline constexpr std::array all_under{Under::plate, Under::plane, Under::ball};

}  // namespace pushfactor::tests
