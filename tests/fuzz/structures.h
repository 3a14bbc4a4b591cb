// What has to hold of every member of the families (demos/families), whatever it is made of.
//
//   finite    the run goes to its end with finite numbers
//   ground    no centre is below a static plane
//   energy    never more than was there at the start or came from outside (engine/energy_account.h), but for what
//             lifting everything by a thousandth of a body would take
//   overlap   the deepest of any step
//   rest      the fastest body in the last second, which begins when mechanics says that the member rests; balls
//             among boxes do not count, as they may roll for ever; not asked where they stir the boxes
//   ends      how far the body moved that moved most where all stand; where some slide, how far the one of them
//   moved
//             that moved least; where some topple, how far the one of them turned that turned least [rad]
//   step      the work of the worst step over that of the median one, or over that of some sweeps where the median
//             one has nothing to do; more where all stand, whose exact answers are found once and kept
//
// Values are without unit. The length is L, the edge of a cube with the volume of the smallest movable body, but
// for overlaps, which are measured by the shortest edge that there is; the speed is sqrt(g L).
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
    bool at_least = false;  // the bar is the least that it may be
    bool asked = true;      // of this member

    bool holds() const { return !asked || (at_least ? value >= bar : value <= bar); }
};

struct Judgement {
    std::array<Measured, property_names.size()> of{};
    std::string error{};  // of a run that did not go to its end

    Measured& operator[](Property p) { return of[static_cast<std::size_t>(p)]; }
    const Measured& operator[](Property p) const { return of[static_cast<std::size_t>(p)]; }
    bool holds() const;
};

// The member's scene with the options under which it is judged.
demos::SceneDescription as_judged(const demos::families::Member& member, const std::string& preset);

// Runs `scene` with its own options and holds it against what `prospect` says. Never throws.
Judgement judge_run(const demos::families::Prospect& prospect, const demos::SceneDescription& scene);

// The member as it is judged. Under the preset `paper` nothing but `finite` is asked.
Judgement judge_member(const demos::families::Member& member, const std::string& preset);

}  // namespace pushfactor::tests
