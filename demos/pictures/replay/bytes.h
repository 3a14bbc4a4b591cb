// Poses and velocities of bodies as integers, with bounds of their errors, and sequences of integers as few bytes
// that compress well, as a page can hold them. The page's decoder is assets/replay/decode.js.
#pragma once

#include "engine/base/math.h"

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace pushfactor::demos::pictures::replay {

// Appends an integer as a variable number of bytes, seven bits each, the lowest first; the sign is the lowest bit
// (0, -1, 1, -2, ... become 0, 1, 2, 3, ...).
void append_integer(std::string& bytes, std::int64_t value);

// Appends the values of one quantity in consecutive frames: a byte k, then
//
//   k = 0            the value, which all frames have
//   k = 1, 2 or 3    per frame the difference from the polynomial of degree k - 1 through the k values before (of a
//                    lower degree while there are fewer, and from 0 at first)
//
// with the k that needs the least bits. At least one value, each at most 2^48 in size.
void append_quantity(std::string& bytes, std::span<const std::int64_t> values);

// The nearest whole number of units, at most 2^48 in size.
std::int64_t in_units(double value, double unit);

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

// Compressed as a zlib stream (RFC 1950), which browsers inflate by themselves (DecompressionStream "deflate").
std::string deflated(std::string_view bytes);

// RFC 4648, section 4.
std::string base64(std::string_view bytes);

// Appends a number's own bytes, lowest first on all machines that we build for.
template <typename Number>
void append_raw(std::string& bytes, Number number) {
    bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

}  // namespace pushfactor::demos::pictures::replay
