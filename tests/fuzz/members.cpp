#include "tests/fuzz/members.h"

#include <algorithm>
#include <array>

namespace pushfactor::tests {

namespace {

using namespace demos::families;

constexpr int most_draws = 1000;  // attempts to draw a member that is small enough

struct Limit {
    std::string_view family, parameter;
    double high;
};
constexpr std::array limits{
    Limit{"cubes", "count", 24},         Limit{"cubes", "layers", 4},        Limit{"boxes", "count", 24},
    Limit{"boxes", "layers", 4},         Limit{"mixed", "count", 24},        Limit{"mixed", "layers", 4},
    Limit{"rods", "count", 12},          Limit{"rods", "layers", 4},         Limit{"rods", "rods", 8},
    Limit{"rods", "speed", 10},          Limit{"plates", "count", 16},       Limit{"plates", "layers", 4},
    Limit{"funnel", "count", 12},        Limit{"round-tower", "planks", 10}, Limit{"round-tower", "rings", 5},
    Limit{"square-tower", "storeys", 8}, Limit{"crossed", "layers", 10},     Limit{"wall", "rows", 6},
    Limit{"wall", "columns", 5},         Limit{"wall-hit", "rows", 6},       Limit{"wall-hit", "columns", 5},
    Limit{"pyramid", "rows", 5},         Limit{"stacks", "stacks", 9},       Limit{"ball-on-cubes", "side", 3},
    Limit{"overhang", "blocks", 6},      Limit{"taken-out", "storeys", 8},   Limit{"card-house", "storeys", 3},
    Limit{"dominoes", "count", 10},      Limit{"cut-column", "cubes", 5},    Limit{"arch", "voussoirs", 21},
    Limit{"net", "meshes", 6},
};

}  // namespace

demos::Parameter small_range(const Family& family, const demos::Parameter& range) {
    const auto is_of = [&](const Limit& each) {
        return each.family == family.name && each.parameter == range.name;
    };
    const auto* const limit = std::find_if(limits.begin(), limits.end(), is_of);
    demos::Parameter small = range;
    if (limit != limits.end()) small.high = limit->high;
    return small;
}

Member draw_bounded_member(const Family& family, const MemberChoice& choice) {
    for (int attempt = 0;; ++attempt) {
        GivenValues values = choice.given;
        for (FamilyParameter parameter : family.parameters) {
            const auto given =
                std::ranges::find(choice.given, parameter.range.name, &GivenValues::value_type::first);
            if (given != choice.given.end()) continue;
            if (choice.small) parameter.range = small_range(family, parameter.range);
            values.emplace_back(parameter.range.name, drawn_value(family, parameter, choice.seed, attempt));
        }
        Member member = draw_member(family, Choice{.seed = choice.seed, .given = values});
        const std::size_t bodies = member.prospect.scene.bodies.size();
        if (!choice.most_bodies || bodies <= *choice.most_bodies || attempt == most_draws) return member;
    }
}

}  // namespace pushfactor::tests
