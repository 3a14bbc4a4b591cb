// What sleeps would stay if it were awake: a member of the families runs for a random time with sleeping; then its
// state runs on for ten seconds twice, as it is and without sleeping. What sleeps at the beginning and until the
// end of the one has to stay within a thousandth of its size in the other.
#pragma once

#include "tests/fuzz/family_campaign.h"

namespace pushfactor::tests {

inline constexpr double most_drift = 1e-3;  // sizes

struct JudgedSleepers {
    demos::families::Member member;
    int movable = 0, asleep = 0;  // bodies; asleep in both
    double drift = 0.0;           // of one asleep, in sizes
    std::string error{};          // of a run that did not reach its end

    bool holds() const { return error.empty() && drift <= most_drift; }
};

// Never throws.
JudgedSleepers judge_sleepers(const demos::families::Member& member);

std::vector<JudgedSleepers> judge_sleepers(const FamilyRequest& request, const GoOn& go_on);

// One line per family: members, how many fail, bodies, how many sleep, and the worst drift.
std::string sleepers_table(const std::vector<JudgedSleepers>& judged);

}  // namespace pushfactor::tests
