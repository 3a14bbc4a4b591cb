// A campaign over members of the families, judged on all cores.
#pragma once

#include "tests/fuzz/structures.h"

#include <functional>
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
};

// In the order in which they are drawn. `go_on` is called now and then in the calling thread, with the number of
// members judged so far; when it returns false, the running ones are finished and returned.
std::vector<JudgedMember> judge_members(const FamilyRequest& request, const std::function<bool(long)>& go_on);

// One line per family: members, how many hold, the worst of each property, which fail how often. The first is the
// header, the last is that of all families.
std::vector<std::vector<std::string>> family_lines(const std::vector<JudgedMember>& judged);
std::string family_table(const std::vector<JudgedMember>& judged);  // the same as text

// The failing properties of a member with their values and limits.
std::string failures_of(const Judgement& judgement);

}  // namespace pushfactor::tests
