#include "engine/bodies/diagnostics.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace pushfactor::engine {

double kinetic_energy(std::span<const Body> bodies) {
    double energy = 0.0;
    for (const Body& body : bodies) {
        energy += 0.5 * body.linear_momentum.dot(velocity(body));
        energy += 0.5 * body.angular_momentum.dot(angular_velocity(body));
    }
    return energy;
}

double potential_energy(std::span<const Body> bodies, const Vector3& gravity) {
    double energy = 0.0;
    for (const Body& body : bodies) {
        if (!body.is_static()) energy -= body.mass() * gravity.dot(body.position);
    }
    return energy;
}

Vector3 linear_momentum(std::span<const Body> bodies) {
    Vector3 sum = Vector3::Zero();
    for (const Body& body : bodies) sum += body.linear_momentum;
    return sum;
}

Vector3 angular_momentum(std::span<const Body> bodies) {
    Vector3 sum = Vector3::Zero();
    for (const Body& body : bodies) sum += body.angular_momentum + body.position.cross(body.linear_momentum);
    return sum;
}

double max_speed(std::span<const Body> bodies) {
    double largest = 0.0;
    for (const Body& body : bodies) largest = std::max(largest, velocity(body).norm());
    return largest;
}

namespace {

// Calls `visit(quantity, value)` for every number of the state of a body.
template <typename Visit>
void visit_state(const Body& body, Visit visit) {
    for (const double value : body.position) visit("position", value);
    for (const double value : body.orientation.coeffs()) visit("orientation", value);
    for (const double value : body.linear_momentum) visit("linear momentum", value);
    for (const double value : body.angular_momentum) visit("angular momentum", value);
}

}  // namespace

std::uint64_t state_hash(std::span<const Body> bodies) {
    std::uint64_t hash = 14695981039346656037u;
    for (const Body& body : bodies) {
        visit_state(body, [&hash](const char*, double value) {
            const auto bits = std::bit_cast<std::uint64_t>(value);
            for (int shift = 0; shift < 64; shift += 8) {
                hash = (hash ^ ((bits >> shift) & 0xffu)) * 1099511628211u;
            }
        });
    }
    return hash;
}

std::optional<NonFinite> find_non_finite(std::span<const Body> bodies) {
    std::optional<NonFinite> found;
    for (std::size_t i = 0; i < bodies.size() && !found; ++i) {
        visit_state(bodies[i], [&](const char* quantity, double value) {
            if (!found && !std::isfinite(value)) found = NonFinite{i, quantity};
        });
    }
    return found;
}

}  // namespace pushfactor::engine
