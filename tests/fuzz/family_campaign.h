// A campaign over members of the families, judged on all cores.
#pragma once

#include "tests/fuzz/structures.h"
#include "tests/fuzz/workers.h"

#include <string>
#include <vector>

namespace pushfactor::tests {

struct FamilyRequest {
    long members = 0;  // the families in turn
    int first_seed = 1;
    std::string preset = "default";
    std::string only{};  // a family; all without
    bool small = false;
    std::size_t most_bodies = 150;
};

struct JudgedMember {
    demos::families::Member member;
    Judgement judgement;

    bool holds() const { return judgement.holds(); }
};

// The member of this number, from 0.
demos::families::Member member_of(const FamilyRequest& request, long number);

// In the order in which they are drawn.
std::vector<JudgedMember> judge_members(const FamilyRequest& request, const GoOn& go_on);

// One line per family: members, how many hold, the worst of each property, which fail how often. The first is the
// header, the last is that of all families.
std::vector<std::vector<std::string>> family_lines(const std::vector<JudgedMember>& judged);
std::string family_table(const std::vector<JudgedMember>& judged);  // the same as text

// The failing properties of a member with their values and limits.
std::string failures_of(const Judgement& judgement);

}  // namespace pushfactor::tests
