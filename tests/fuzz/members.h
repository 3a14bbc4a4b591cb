// Members of the families that are small enough for tests.
#pragma once

#include "demos/scenes/families/family.h"

#include <optional>

namespace pushfactor::tests {

struct MemberChoice {
    int seed = 1;
    demos::families::GivenValues given{};
    bool small = false;                        // drawn from small_range()
    std::optional<std::size_t> most_bodies{};  // redrawn until there are no more
};

// The range of a parameter of small members, within that of all.
demos::Parameter small_range(const demos::families::Family& family, const demos::Parameter& range);

// As families::draw_member() does, which it is for a choice with a seed and given values only.
demos::families::Member draw_bounded_member(const demos::families::Family& family, const MemberChoice& choice);

}  // namespace pushfactor::tests
