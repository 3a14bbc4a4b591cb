// Measured quantities of a state: pure functions.
#pragma once

#include "engine/bodies/body.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace pushfactor::engine {

double kinetic_energy(std::span<const Body> bodies);                            // J
double potential_energy(std::span<const Body> bodies, const Vector3& gravity);  // J, zero at the origin
Vector3 linear_momentum(std::span<const Body> bodies);                          // kg m/s
Vector3 angular_momentum(std::span<const Body> bodies);                         // kg m^2/s, about the origin
double max_speed(std::span<const Body> bodies);  // m/s, from the momenta; prescribed ones count

// 64-bit FNV-1a over the bits of position, orientation and momenta of all bodies, in order.
std::uint64_t state_hash(std::span<const Body> bodies);

// The first body with a non-finite number, and the name of that quantity.
struct NonFinite {
    std::size_t body = 0;
    std::string quantity;
};
std::optional<NonFinite> find_non_finite(std::span<const Body> bodies);

}  // namespace pushfactor::engine
