#include "tests/peers/mechanics.h"

#include <algorithm>

namespace pushfactor::tests::peers {

bool finite(const Run& run) {
    return std::all_of(run.states.begin(), run.states.end(), [](const std::vector<State>& states) {
        return std::all_of(states.begin(), states.end(), [](const State& s) {
            return s.position.allFinite() && s.velocity.allFinite() && s.orientation.coeffs().allFinite();
        });
    });
}

Vector3 angular_momentum(const Body& body, const State& s) {
    return s.orientation * inertia(body).cwiseProduct(s.orientation.conjugate() * s.angular_velocity);
}

double kinetic(const Scene& scene, const std::vector<State>& states) {
    double sum = 0.0;
    for (std::size_t i = 0; i < states.size(); ++i) {
        const State& s = states[i];
        sum += 0.5 * scene.movable[i].mass * s.velocity.squaredNorm();
        sum += 0.5 * s.angular_velocity.dot(angular_momentum(scene.movable[i], s));
    }
    return sum;
}

double potential(const Scene& scene, const std::vector<State>& states) {
    double sum = 0.0;
    for (std::size_t i = 0; i < states.size(); ++i)
        sum -= scene.movable[i].mass * scene.gravity.dot(states[i].position);
    return sum;
}

}  // namespace pushfactor::tests::peers
