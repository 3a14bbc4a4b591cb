// Forces and pushes of a block of frames as bytes. They appear and vanish from frame to frame, so each frame has a
// list of its own; what is at the same place in both lists is stored as a difference.
#pragma once

#include "demos/pictures/overlays/acting.h"

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace pushfactor::demos::pictures::replay {

// A vector as three integers of at most 2^10 in size and an exponent: number x 2^(exponent - 10). Each number is
// wrong by at most 1/1024 of the largest of the three.
struct Scaled {
    std::int64_t exponent = 0;
    std::array<std::int64_t, 3> numbers{};
};

// `last_exponent` is that of a vector without length.
Scaled scaled(const engine::Vector3& vector, std::int64_t last_exponent);

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
