#include "tests/fuzz/family_campaign.h"

#include "tests/fuzz/members.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <span>

namespace pushfactor::tests {

namespace {

using demos::families::Family;

std::vector<const Family*> wanted_families(const std::string& only) {
    std::vector<const Family*> wanted;
    for (const Family& family : demos::families::families()) {
        if (only.empty() || family.name == only) wanted.push_back(&family);
    }
    return wanted;
}

struct Line {
    long members = 0, hold = 0;
    std::array<long, property_names.size()> fail{};
    std::array<std::optional<double>, property_names.size()> worst{};

    void add(const Judgement& judgement) {
        ++members;
        if (judgement.holds()) ++hold;
        for (std::size_t p = 0; p < property_names.size(); ++p) {
            const Measured& measured = judgement.of[p];
            if (!measured.holds()) ++fail[p];
            if (!judgement.error.empty() || static_cast<Property>(p) == Property::finite) continue;
            // Least and most do not mix: where a family has both, the worst of the members that stand is shown.
            if (!measured.asked || measured.at_least) continue;
            worst[p] = std::max(worst[p].value_or(0.0), measured.value);
        }
    }

    std::vector<std::string> fields(std::string_view name) const {
        std::vector<std::string> all{std::string(name), std::to_string(members), std::to_string(hold)};
        for (std::size_t p = 1; p < property_names.size(); ++p) {
            all.push_back(worst[p] ? fmt::format("{:.3g}", *worst[p]) : "-");
        }
        std::string failing;
        for (std::size_t p = 0; p < property_names.size(); ++p) {
            if (fail[p] == 0) continue;
            failing += fmt::format("{}{} {}", failing.empty() ? "" : " ", property_names[p], fail[p]);
        }
        all.push_back(failing);
        return all;
    }
};

}  // namespace

demos::families::Member member_of(const FamilyRequest& request, long number) {
    const std::vector<const Family*> families = wanted_families(request.only);
    const auto count = static_cast<long>(families.size());
    return draw_bounded_member(*families[static_cast<std::size_t>(number % count)],
                               {.seed = request.first_seed + static_cast<int>(number / count),
                                .small = request.small,
                                .most_bodies = request.most_bodies});
}

std::vector<JudgedMember> judge_members(const FamilyRequest& request, const GoOn& go_on) {
    return results_of<JudgedMember>(
        request.members,
        [&](long i) {
            JudgedMember judged{.member = member_of(request, i), .judgement = {}};
            judged.judgement = judge_member(judged.member, request.preset);
            return judged;
        },
        go_on);
}

std::vector<std::vector<std::string>> family_lines(const std::vector<JudgedMember>& judged) {
    std::vector<std::vector<std::string>> lines(1, {"family", "members", "hold"});
    for (const std::string_view name : std::span(property_names).subspan(1)) lines[0].emplace_back(name);
    lines[0].emplace_back("fail");
    Line all;
    for (const Family& family : demos::families::families()) {
        Line line;
        for (const JudgedMember& one : judged) {
            if (one.member.family != &family) continue;
            line.add(one.judgement);
            all.add(one.judgement);
        }
        if (line.members > 0) lines.push_back(line.fields(family.name));
    }
    lines.push_back(all.fields("all"));
    return lines;
}

std::string family_table(const std::vector<JudgedMember>& judged) {
    std::string text;
    for (const std::vector<std::string>& fields : family_lines(judged)) {
        text += fmt::format("{:<14}{:>8}{:>6}", fields[0], fields[1], fields[2]);
        for (std::size_t p = 3; p + 1 < fields.size(); ++p) text += fmt::format("{:>10}", fields[p]);
        text += fmt::format("   {}\n", fields.back());
    }
    return text;
}

std::string failures_of(const Judgement& judgement) {
    if (!judgement.error.empty()) return judgement.error;
    std::string text;
    for (std::size_t p = 0; p < property_names.size(); ++p) {
        const Measured& measured = judgement.of[p];
        if (measured.holds()) continue;
        text += fmt::format("{}{} {:.3g}, must be {} {}", text.empty() ? "" : "; ", property_names[p],
                            measured.value, measured.at_least ? "at least" : "at most", measured.bar);
    }
    return text;
}

}  // namespace pushfactor::tests
