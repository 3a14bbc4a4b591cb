// Members of the families (demos/families) that are hard: what stands must stand still, what leaves must leave.
#include "demos/reports/stability/chapters.h"
#include "demos/scenes/families/family.h"

#include <fmt/format.h>

namespace pushfactor::demos::reports::stability {

namespace {

using families::GivenValues;

struct Bars {
    double penetration = 0.0;  // m
    double moved = 0.0;        // m, sideways from the start
    double left = 0.0;         // m, sideways at least
};

// What answers to rounding leave of what stands.
constexpr Bars rounding{.penetration = 1e-9, .moved = 1e-6};

// What stands: also no energy is gained [J] and it does not creep on.
std::vector<Check> standing(const Bars& bars) {
    return {{.measure = "max_penetration_m", .bar = bars.penetration},
            {.measure = "max_off_axis_m", .bar = bars.moved},
            {.measure = "energy_gain_j", .bar = 1e-6},
            {.measure = "drift_after_10_s_m", .bar = 1e-4}};
}

std::vector<Check> leaving(const Bars& bars) {
    return {{.measure = "max_penetration_m", .bar = bars.penetration},
            {.measure = "max_off_axis_m", .bar = bars.left, .at_least = true},
            {.measure = "energy_gain_j", .bar = 1e-6}};
}

std::vector<Check> piled(const Bars& bars) {
    return {{.measure = "max_penetration_m", .bar = bars.penetration}, {.measure = "energy_gain_j", .bar = 1e-6}};
}

using Reached = std::vector<std::optional<double>>;

struct Structure {
    std::string name, family;
    GivenValues values;
    std::vector<Check> checks, exact_checks;  // no case under `exact` without these
    Expected expected{.preset = "default", .outcome = "rest"};
    bool quick = false;
    const char* seconds = "12";
    Reached exact_reached{};
};

Expected reaches(const std::string& outcome, Reached reached = {}) {
    return {.preset = "default", .outcome = outcome, .reached = std::move(reached)};
}

// Parameters that all families call the same have the same values where a structure does not say otherwise.
SceneDescription scene_of(const Structure& structure) {
    families::Choice choice{.given = structure.values};
    const families::Family& family = *families::find_family(structure.family);
    for (const families::FamilyParameter& parameter : family.parameters) {
        if (parameter.range.name == "friction") choice.given.emplace_back("friction", "0.5");
        if (parameter.range.name == "gap") choice.given.emplace_back("gap", "0");
    }
    SceneDescription scene = draw_member(family, choice).prospect.scene;
    scene.options.clear();
    return scene;
}

void add_cases(const Structure& structure, Chapter& chapter) {
    Case one{.name = structure.name,
             .own = scene_of(structure),
             .options = {{"seconds", structure.seconds}},
             .wanted = structure.expected.outcome == "moving" && structure.exact_checks.empty() ? "moving" : "rest",
             .checks = structure.checks,
             .expected = {structure.expected},
             .quick = structure.quick};
    one.own->name = one.name;
    chapter.cases.push_back(one);
    if (structure.exact_checks.empty()) return;
    one.name += "-exact";
    one.own->name = one.name;
    one.checks = structure.exact_checks;
    one.expected = {{.preset = "exact", .outcome = "rest", .reached = structure.exact_reached}};
    chapter.cases.push_back(one);
}

std::vector<Structure> towers_and_walls() {
    const std::vector<Check> tower = standing({.penetration = 0.002, .moved = 0.003});
    const std::vector<Check> wall = standing({.penetration = 0.002, .moved = 0.01});
    const std::vector<Check> exact = standing(rounding);
    return {
        {"round-tower-of-400", "round-tower", {{"planks", "10"}, {"rings", "40"}}, tower, exact},
        {"round-tower-of-100", "round-tower", {{"planks", "10"}, {"rings", "10"}}, tower, exact},
        {"square-tower-of-80", "square-tower", {{"storeys", "20"}}, tower, exact},
        {"crossed-tower-of-90",
         "crossed",
         {{"layers", "30"}, {"gap", "0.05"}},
         tower,
         exact,
         reaches("rest", {{}, {}, 0.1, {}})},
        {"wall-20-by-20", "wall", {{"rows", "20"}, {"columns", "20"}}, wall, exact},
        {"wall-20-by-20-gaps", "wall", {{"rows", "20"}, {"columns", "20"}, {"gap", "0.02"}}, wall, exact},
        {"pyramid-100-kg-on-top",
         "pyramid",
         {{"rows", "10"}, {"mass-ratio", "100"}},
         standing({.penetration = 0.002, .moved = 0.003}),
         exact},
    };
}

std::vector<Structure> cards() {
    std::vector<Structure> all;
    for (const char* const storeys : {"3", "4", "5"}) {
        all.push_back({.name = fmt::format("cards-{}-storeys", storeys),
                       .family = "card-house",
                       .values = {{"storeys", storeys}, {"slenderness", "50"}, {"friction", "0.7"}},
                       .checks = standing({.penetration = 0.0005, .moved = 0.002}),
                       .exact_checks = standing(rounding),
                       .quick = std::string(storeys) == "3"});
    }
    return all;
}

std::vector<Structure> loads() {
    const auto loaded = [](const char* mass) {
        return Structure{.name = fmt::format("ball-of-{}-kg-on-27-cubes", mass),
                         .family = "ball-on-cubes",
                         .values = {{"side", "3"}, {"mass", mass}},
                         .checks = standing({.penetration = 0.002, .moved = 0.003}),
                         .exact_checks = standing(rounding)};
    };
    return {loaded("50"),
            loaded("500"),
            loaded("5000"),
            {.name = "100-small-stacks",
             .family = "stacks",
             .values = {{"stacks", "100"}},
             .checks = standing({.penetration = 0.001, .moved = 0.001}),
             .exact_checks = standing(rounding)}};
}

std::vector<Structure> at_the_limit() {
    const std::vector<Check> stands = standing({.penetration = 0.0005, .moved = 0.001}), exact = standing(rounding);
    std::vector<Structure> all;
    for (const bool inside : {true, false}) {
        const char* const side = inside ? "inside" : "outside";
        const char* const given = inside ? "1" : "0";
        const std::vector<Check> leaves = leaving({.penetration = 0.01, .left = 0.3});
        all.push_back({.name = fmt::format("overhang-{}-by-2-percent", side),
                       .family = "overhang",
                       .values = {{"blocks", "8"}, {"inside", given}, {"beyond", "0.02"}},
                       .checks = inside ? stands : leaves,
                       .exact_checks = inside ? exact : leaves,
                       .quick = true});
        all.push_back({.name = fmt::format("leaning-slab-{}-by-5-percent", side),
                       .family = "leaning-slab",
                       .values = {{"lean", "0.5"},
                                  {"thickness", "0.1"},
                                  {"wall-friction", "0.3"},
                                  {"inside", given},
                                  {"beyond", "0.05"}},
                       .checks = inside ? stands : leaves,
                       .exact_checks = inside ? exact : leaves,
                       .quick = true});
    }
    const std::vector<Check> fall = leaving({.penetration = 0.01, .left = 0.5});
    all.push_back({.name = "20-dominoes",
                   .family = "dominoes",
                   .values = {{"count", "20"}, {"spacing", "0.5"}, {"thickness", "0.1"}},
                   .checks = fall,
                   .exact_checks = fall,
                   .expected = reaches("rest", {{}, {}, 1e-4}),
                   .exact_reached = {0.02, {}, 1e-4}});
    return all;
}

// Exact answers of large piles take minutes. Where balls roll away, that is an outcome `moving`.
std::vector<Structure> piles() {
    const std::vector<Check> checks = piled({.penetration = 0.1});
    return {{.name = "200-cubes",
             .family = "cubes",
             .values = {{"count", "200"}, {"layers", "4"}},
             .checks = checks,
             .exact_checks = checks,
             .expected = reaches("creep"),
             .exact_reached = {0.25, {}}},
            {.name = "200-mixed",
             .family = "mixed",
             .values = {{"count", "200"}, {"layers", "4"}},
             .checks = checks,
             .exact_checks = {},
             .expected = reaches("moving", {0.25, {}})},
            {.name = "20-rods-on-50-cubes",
             .family = "rods",
             .values = {{"count", "50"}, {"layers", "4"}, {"rods", "20"}, {"speed", "5"}},
             .checks = checks,
             .exact_checks = {},
             .expected = reaches("moving", {0.6, {}})},
            {.name = "wall-hit-by-50-kg",
             .family = "wall-hit",
             .values = {{"rows", "10"}, {"columns", "10"}, {"mass", "50"}, {"speed", "10"}},
             .checks = checks,
             .exact_checks = {},
             .expected = reaches("moving")}};
}

}  // namespace

Chapter structures() {
    Chapter chapter{"structures", "Towers, walls, cards and piles: stand, leave or come to rest as they must", {}};
    for (const auto& part : {towers_and_walls(), cards(), loads(), at_the_limit(), piles()}) {
        for (const Structure& structure : part) add_cases(structure, chapter);
    }
    return chapter;
}

}  // namespace pushfactor::demos::reports::stability
