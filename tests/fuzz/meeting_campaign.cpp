#include "tests/fuzz/meeting_campaign.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace pushfactor::tests {

namespace {

struct KindLine {
    long passes = 0, touches = 0, normals = 0, left_out = 0;
    std::array<long, 7> faults{};  // by MeetingFault
    double worst_change = 0.0;

    void add(const JudgedMeeting& one) {
        left_out += one.meeting.left_out;
        ++faults[static_cast<std::size_t>(one.verdict.fault)];
        ++(one.passes() ? passes : touches);
        if (one.passes()) worst_change = std::max(worst_change, one.verdict.worst);
        if (one.meeting.prediction.normal) ++normals;
    }

    std::string text(const std::string& name) const {
        std::string text =
            fmt::format("{:<22}{:>7}{:>10.2g}{:>10}", name, passes, worst_change, of(MeetingFault::disturbed));
        text += fmt::format("{:>9}{:>8}{:>8}", touches, of(MeetingFault::early), of(MeetingFault::missed));
        text += fmt::format("{:>9}{:>8}{:>8}", normals, of(MeetingFault::wrong_normal),
                            of(MeetingFault::unused_normal));
        return text + fmt::format("{:>9}{:>10}\n", of(MeetingFault::refused), left_out);
    }

  private:
    long of(MeetingFault fault) const { return faults[static_cast<std::size_t>(fault)]; }
};

}  // namespace

std::vector<JudgedMeeting> judge_meetings(const MeetingRequest& request, const GoOn& go_on) {
    const auto kinds = static_cast<long>(meeting_kinds().size());
    const auto wanted = request.only ? std::vector{*request.only}
                                     : std::vector{Prediction::Kind::passes, Prediction::Kind::touches};
    const auto each = static_cast<long>(wanted.size());
    const auto judged = results_of<std::vector<JudgedMeeting>>(
        each * request.count,
        [&](long i) {
            const long pair = i / each;
            const Meeting meeting =
                draw_meeting(wanted[static_cast<std::size_t>(i % each)], static_cast<std::size_t>(pair % kinds),
                             request.first_seed + static_cast<std::uint64_t>(pair / kinds));
            std::vector<JudgedMeeting> results;
            for (const std::string& preset : request.presets) {
                results.push_back({meeting, preset, judge_meeting(meeting, preset)});
            }
            return results;
        },
        go_on);
    std::vector<JudgedMeeting> all;
    for (const std::vector<JudgedMeeting>& some : judged) all.insert(all.end(), some.begin(), some.end());
    return all;
}

std::string meeting_table(const std::vector<JudgedMeeting>& judged) {
    std::string text = fmt::format("{:<22}{:>7}{:>10}{:>10}", "pair", "passes", "worst", "disturbed");
    text +=
        fmt::format("{:>9}{:>8}{:>8}{:>9}{:>8}{:>8}", "touches", "early", "missed", "normals", "wrong", "unused");
    text += fmt::format("{:>9}{:>10}\n", "refused", "left out");
    const std::vector<std::string> names = meeting_kinds();
    KindLine all;
    for (std::size_t kind = 0; kind < names.size(); ++kind) {
        KindLine line;
        for (const JudgedMeeting& one : judged) {
            if (one.meeting.kind == kind) line.add(one);
        }
        if (line.passes + line.touches > 0) text += line.text(names[kind]);
    }
    for (const JudgedMeeting& one : judged) all.add(one);
    return text + all.text("all");
}

}  // namespace pushfactor::tests
