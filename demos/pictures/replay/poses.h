// Poses and velocities of bodies as integers, with bounds of their errors.
#pragma once

#include "engine/base/math.h"

#include <array>
#include <cstdint>

namespace pushfactor::demos::pictures::replay {

// Units relative to the radius of a body's bounding sphere. A coordinate is wrong by at most half a unit, so a
// position by at most sqrt(3) / 2 units = 1e-4 of that radius.
inline constexpr double position_unit = 1.15e-4;

// The four numbers of a quaternion are each wrong by at most half a unit, the four together by at most one, and the
// rotation by at most twice that: 1e-4 rad.
inline constexpr double orientation_unit = 1.0 / 20100.0;

// Per second: velocities are wrong by at most sqrt(3) / 2 of this share of the radius, angular velocities of this
// number of radians.
inline constexpr double velocity_unit = 1e-3;

// In units, x, y and z.
std::array<std::int64_t, 3> vector_in_units(const engine::Vector3& vector, double unit);

// In units, w, x, y and z: of the two quaternions of a rotation the one that is nearer to `last`.
std::array<std::int64_t, 4> orientation_in_units(const engine::Quaternion& orientation,
                                                 const std::array<std::int64_t, 4>& last);

}  // namespace pushfactor::demos::pictures::replay
