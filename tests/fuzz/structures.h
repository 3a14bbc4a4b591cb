// The claims about every member of the families (demos/families).
//
//   finite    the run reaches its end with finite numbers
//   ground    no centre is below a static plane
//   energy    never more than the start's and the work done from outside (engine/energy_account.h), up to the
//   energy
//             that lifts everything by a thousandth of a body
//   overlap   the deepest of any step
//   rest      the fastest body in the last second, which begins when the member rests by mechanics; without balls
//             among boxes, which may roll for ever; not claimed where they stir the boxes
//   ends      the largest displacement where all stand; where some slide, the smallest displacement of these; where
//             some topple, the smallest rotation of these [rad]
//   step      the work of the worst step over that of the median one, or over that of some sweeps where the median
//             one has nothing to do; more where all stand, because their exact solutions are found once and kept
//
// Values are dimensionless. The unit of length is L, the edge of a cube with the volume of the smallest movable
// body, but the shortest edge of all for overlaps; that of speed is sqrt(g L).
#pragma once

#include "demos/scenes/families/family.h"

#include <array>
#include <string>
#include <string_view>

namespace pushfactor::tests {

enum class Property { finite, ground, energy, overlap, rest, ends, step };
inline constexpr std::array<std::string_view, 7> property_names{"finite", "ground", "energy", "overlap",
                                                                "rest",   "ends",   "step"};

struct Measured {
    double value = 0.0, bar = 0.0;
    bool at_least = false;  // the limit is a lower one
    bool asked = true;      // of this member

    bool holds() const { return !asked || (at_least ? value >= bar : value <= bar); }
};

struct Judgement {
    std::array<Measured, property_names.size()> of{};
    std::string error{};  // of a run that did not reach its end

    Measured& operator[](Property p) { return of[static_cast<std::size_t>(p)]; }
    const Measured& operator[](Property p) const { return of[static_cast<std::size_t>(p)]; }
    bool holds() const;
};

// The member's scene with the options under which it is judged.
demos::SceneDescription as_judged(const demos::families::Member& member, const std::string& preset);

// Runs `scene` with its own options and compares it with `prospect`. Never throws.
Judgement judge_run(const demos::families::Prospect& prospect, const demos::SceneDescription& scene);

// The verdict on a member. Under the preset `paper` only `finite` is claimed.
Judgement judge_member(const demos::families::Member& member, const std::string& preset);

}  // namespace pushfactor::tests
