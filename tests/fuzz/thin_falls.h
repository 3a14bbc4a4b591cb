// One thin body falls on the ground, or on another body above it: a rod, a plate or a coin with a rim of 8 to 128
// corners, 2 to 10 cm thick and about a metre long, from up to 3 m, at any angle, in half of the cases within 20
// degrees of flat. The other body is static at any angle, or movable and lies on the ground; a box or a prism.
//
// At the end of no step may it overlap anything by more than a tenth of its thickness. Measured from its corners
// above the ground, and by solid_distance.h.
#pragma once

#include "demos/scenes/scene_description.h"
#include "tests/fuzz/workers.h"

#include <cstdint>
#include <string>
#include <vector>

namespace pushfactor::tests {

inline constexpr double most_thin_overlap = 0.1;  // thicknesses

std::vector<std::string> thin_fall_kinds();

struct ThinFall {
    std::size_t kind = 0;
    demos::SceneDescription scene;  // bodies ground, piece, and maybe target
    double thickness = 0.0;         // m
};

ThinFall draw_thin_fall(std::size_t kind, std::uint64_t seed);

struct JudgedFall {
    ThinFall fall;
    double deepest = 0.0;  // thicknesses
    long step = 0;         // of that overlap
    std::string error{};   // of a run that did not reach its end

    bool holds() const { return error.empty() && deepest <= most_thin_overlap; }
};

// Never throws.
JudgedFall judge_thin_fall(const ThinFall& fall, const std::string& preset);

// `count` of them, the kinds in turn.
std::vector<JudgedFall> judge_thin_falls(long count, std::uint64_t first_seed, const std::string& preset,
                                         const GoOn& go_on);

// One line per kind: how many, how many fail, median and worst overlap in thicknesses.
std::string thin_fall_table(const std::vector<JudgedFall>& judged);

}  // namespace pushfactor::tests
