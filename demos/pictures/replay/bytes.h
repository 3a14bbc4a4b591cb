// Poses, velocities and forces of bodies as integers, with bounds of their errors, and sequences of integers as few
// bytes that compress well, as a page can hold them. The page's decoder is assets/replay/decode.js.
#pragma once

#include "demos/pictures/overlays/acting.h"

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

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

// Units relative to the radius of a body's bounding sphere. A coordinate is wrong by at most half a unit, so a
// position by at most sqrt(3) / 2 units = 1e-4 of that radius.
inline constexpr double position_unit = 1.15e-4;

// The four numbers of a quaternion are each wrong by at most half a unit, the four together by at most one, and the
// rotation by at most twice that: 1e-4 rad.
inline constexpr double orientation_unit = 1.0 / 20100.0;

// Per second: velocities are wrong by at most sqrt(3) / 2 of this share of the radius, angular velocities of this
// number of radians.
inline constexpr double velocity_unit = 1e-3;

// In units, x, y and z: the nearest whole numbers, at most 2^48 in size.
std::array<std::int64_t, 3> vector_in_units(const engine::Vector3& vector, double unit);

// In units, w, x, y and z: of the two quaternions of a rotation the one that is nearer to `last`.
std::array<std::int64_t, 4> orientation_in_units(const engine::Quaternion& orientation,
                                                 const std::array<std::int64_t, 4>& last);

// Appends a number's own bytes, lowest first on all machines that we build for.
template <typename Number>
void append_raw(std::string& bytes, Number number) {
    bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

// A vector as three integers of at most 2^10 in size and an exponent: number x 2^(exponent - 10). Each number is
// wrong by at most 1/1024 of the largest of the three.
struct Scaled {
    std::int64_t exponent = 0;
    std::array<std::int64_t, 3> numbers{};
};

// Forces and pushes of a block of frames. They appear and vanish from frame to frame, so each frame has a list of
// its own; what is at the same place in both lists is stored as a difference.
class ForceBlock {
  public:
    // `position_units` [m] of all bodies of the world.
    explicit ForceBlock(std::vector<double> position_units) : position_units_(std::move(position_units)) {}

    // Adds the list of a frame. Forces below `least_force` [N] and pushes below `least_push` [m/s] count as zero.
    void add(std::span<const Acting> acting, double least_force, double least_push);

    // The bytes of all frames since the last call: the lengths of four parts, and the parts. Per frame, as
    // integers:
    //
    //   who     0 if kinds and bodies are those of the list before, else its length + 1, and per item the
    //           kind (0 touching, 1 within the margin, 2 distance, 3 joint, 4 from outside), the body less that of
    //           the item before, and the other body less the body
    //   where   per item x, y, z in position units of the body
    //   force   per item the exponent and three numbers of a Scaled
    //   push    per item the same twice: for this step only, and lasting
    //
    // All but `who` less those of the same item in the frame before, if there is one: the n-th with this kind and
    // these bodies.
    std::string take();

  private:
    using Who = std::array<std::int64_t, 3>;  // kind, body, other
    struct Item {
        std::array<std::int64_t, 3> place{};
        std::array<Scaled, 3> vectors{};  // force, correcting, lasting
    };

    void add_who(const std::vector<Who>& who);

    std::vector<double> position_units_;
    std::array<std::string, 4> parts_;
    std::vector<Who> last_who_;
    std::map<std::array<std::int64_t, 4>, Item> last_;  // by who, and the number of such items before
};

}  // namespace pushfactor::demos::pictures::replay
