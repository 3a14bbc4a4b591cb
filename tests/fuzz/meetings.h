// Random pairs of boxes, balls, polyhedra and rods that fly freely, and what has to happen to them: nothing to
// those that pass each other, and a contact in the right step and direction to those that touch (free_pair.h).
//
//   passes   every body keeps its momentum to 1e-9 of m v and its angular momentum to 1e-9 of m v r in every step;
//            v is the relative speed of the pair, r the radius of the body
//   touches  the same before the step of the touch. In that step a normal row has a force, and one that has is
//            along the predicted normal, where that is unique
//
// The normal may be off by 5e-3 rad: a meeting that is found when there is still a distance d shows a ball of
// radius R that grazes with an overlap of D turned by d / sqrt(2 R D), which is below 1e-3 for d = 1e-6 m and R, D
// of 5 cm and 0.1 mm. If the step starts within the margin, the row may have the normal of that moment: how far it
// turns until the touch is added.
#pragma once

#include "tests/fuzz/free_pair.h"

#include <cstdint>
#include <string>

namespace pushfactor::tests {

// Names of the kinds of pairs.
std::vector<std::string> meeting_kinds();

struct Meeting {
    std::size_t kind = 0;
    demos::SceneDescription scene;  // bodies a and b
    double speed = 0.0;             // m/s, relative
    long steps = 0;                 // of the run; those of a touch end with it
    Prediction prediction;
    int left_out = 0;  // draws before it that were unclear, or came out the other way
};

// Relative speeds of 0.3 to 200 m/s, at most 10 m/s of turning at the surface; clearances of 0.1 mm to 5 cm,
// overlaps of 0.1 mm on. Steps of 1/60 s; the closest approach is in any of the first eight. In every fourth pair
// one body is static.
Meeting draw_meeting(Prediction::Kind wanted, std::size_t kind, std::uint64_t seed);

// The two bodies at the start.
std::array<engine::Body, 2> bodies_of(const Meeting& meeting);

// m, how deep a pair that touches would overlap in the step of its touch, within a tenth.
double overlap_of(const Meeting& meeting);

// Of a pair that passes: disturbed. Of one that touches: a force before that, none in that step, none along the
// normal, although there is a row along it (unused) or not (wrong). Of both: an error.
enum class MeetingFault { none, disturbed, early, missed, wrong_normal, unused_normal, refused };

struct MeetingVerdict {
    MeetingFault fault = MeetingFault::none;
    std::string failure{};  // in numbers
    long step = 0;          // of the failure
    double worst = 0.0;  // passes: largest change of momentum, in m v or m v r. touches: angle of the normal, rad
};

// Never throws.
MeetingVerdict judge_meeting(const Meeting& meeting, const std::string& preset);

}  // namespace pushfactor::tests
