// A campaign over random pairs (meetings.h), judged on all cores.
#pragma once

#include "tests/fuzz/meetings.h"
#include "tests/fuzz/workers.h"

namespace pushfactor::tests {

struct MeetingRequest {
    long count = 0;  // that pass, and as many that touch; the kinds of pairs in turn
    std::uint64_t first_seed = 1;
    std::vector<std::string> presets{"default"};
    std::optional<Prediction::Kind> only{};  // those that pass, or those that touch
};

struct JudgedMeeting {
    Meeting meeting;
    std::string preset;
    MeetingVerdict verdict;

    bool holds() const { return verdict.fault == MeetingFault::none; }
    bool passes() const { return meeting.prediction.kind == Prediction::Kind::passes; }
};

std::vector<JudgedMeeting> judge_meetings(const MeetingRequest& request, const GoOn& go_on);

// One line per kind of pair: how many pass, with the largest change of a momentum, and how many of them are
// disturbed. How many touch, and how many of them have a force too early or none in time. How many normals are
// compared, and how many of them are wrong or without force. Last, how many draws were left out.
std::string meeting_table(const std::vector<JudgedMeeting>& judged);

}  // namespace pushfactor::tests
