// Hard members of the families (demos/scenes/families): what should stand must not move, what should slide or
// topple must do so.
#include "demos/reports/stability/cases.h"
#include "demos/scenes/families/family.h"

namespace pushfactor::demos::reports::stability {

namespace {

using families::GivenValues;

const Check no_energy{"energy_gain_j", 1e-6};  // is gained

Check penetration(double most) {
    return {"max_penetration_m", most};
}

// Checks of structures that stand: moved by at most `moved` sideways [m], no creep.
Checks standing(double deep, double moved) {
    return {penetration(deep), {"max_off_axis_m", moved}, no_energy, {"drift_after_10_s_m", 1e-4}};
}

// Checks of bodies that slide or topple, sideways by at least `left` [m].
Checks leaving(double left) {
    return {penetration(0.01), {.measure = "max_off_axis_m", .bar = left, .at_least = true}, no_energy};
}

const Checks piled{penetration(0.1), no_energy};

// Standing structures, solved to rounding.
const Checks exactly = standing(1e-9, 1e-6);

// A member with friction 0.5 and gap 0 unless `given` differs.
SceneDescription member(const std::string& family_name, const GivenValues& given) {
    families::Choice choice{.given = given};
    const families::Family& family = *families::find_family(family_name);
    for (const families::FamilyParameter& parameter : family.parameters) {
        if (parameter.range.name == "friction") choice.given.emplace_back("friction", "0.5");
        if (parameter.range.name == "gap") choice.given.emplace_back("gap", "0");
    }
    SceneDescription scene = draw_member(family, choice).prospect.scene;
    scene.options.clear();
    return scene;
}

const Expected stands{"default", "rest"};

class Structures {
  public:
    // Adds a case for `default`, and one for `exact` if there are checks for it.
    void add(const std::string& name, const std::string& family, const GivenValues& values, const Checks& checks,
             const Checks& exact_checks = exactly, const Expected& of_default = stands, bool quick = false,
             const Reached& of_exact = {}) {
        SceneDescription scene = member(family, values);
        const auto add_case = [&](const std::string& case_name, const std::string& wanted, const Checks& all,
                                  const Expected& expected) {
            scene.name = case_name;
            chapter.add(case_name, scene, {{"seconds", "12"}}, wanted, all, {expected}, quick);
        };
        const bool moves = of_default.outcome == "moving" && exact_checks.empty();
        add_case(name, moves ? "moving" : "rest", checks, of_default);
        if (!exact_checks.empty()) add_case(name + "-exact", "rest", exact_checks, {"exact", "rest", of_exact});
    }

    Chapter chapter{"structures", "Towers, walls, cards and piles: stand, leave or come to rest as they must"};
};

void add_what_stands(Structures& all) {
    const Checks tower = standing(0.002, 0.003), wall = standing(0.002, 0.01);
    all.add("round-tower-of-400", "round-tower", {{"planks", "10"}, {"rings", "40"}}, tower);
    all.add("round-tower-of-100", "round-tower", {{"planks", "10"}, {"rings", "10"}}, tower);
    all.add("square-tower-of-80", "square-tower", {{"storeys", "20"}}, tower);
    all.add("crossed-tower-of-90", "crossed", {{"layers", "30"}, {"gap", "0.05"}}, tower, exactly,
            {"default", "rest", {{}, {}, 0.1, {}}});
    all.add("wall-20-by-20", "wall", {{"rows", "20"}, {"columns", "20"}}, wall);
    all.add("wall-20-by-20-gaps", "wall", {{"rows", "20"}, {"columns", "20"}, {"gap", "0.02"}}, wall);
    all.add("pyramid-100-kg-on-top", "pyramid", {{"rows", "10"}, {"mass-ratio", "100"}}, tower);
    for (const std::string storeys : {"3", "4", "5"}) {
        all.add("cards-" + storeys + "-storeys", "card-house",
                {{"storeys", storeys}, {"slenderness", "50"}, {"friction", "0.7"}}, standing(0.0005, 0.002),
                exactly, stands, storeys == "3");
    }
    for (const std::string mass : {"50", "500", "5000"}) {
        all.add("ball-of-" + mass + "-kg-on-27-cubes", "ball-on-cubes", {{"side", "3"}, {"mass", mass}}, tower);
    }
    all.add("100-small-stacks", "stacks", {{"stacks", "100"}}, standing(0.001, 0.001));
}

void add_what_is_at_the_limit(Structures& all) {
    for (const bool inside : {true, false}) {
        const std::string side = inside ? "inside" : "outside", given = inside ? "1" : "0";
        const Checks checks = inside ? standing(0.0005, 0.001) : leaving(0.3);
        const Checks exact_checks = inside ? exactly : leaving(0.3);
        all.add("overhang-" + side + "-by-2-percent", "overhang",
                {{"blocks", "8"}, {"inside", given}, {"beyond", "0.02"}}, checks, exact_checks, stands, true);
        all.add("leaning-slab-" + side + "-by-5-percent", "leaning-slab",
                {{"lean", "0.5"},
                 {"thickness", "0.1"},
                 {"wall-friction", "0.3"},
                 {"inside", given},
                 {"beyond", "0.05"}},
                checks, exact_checks, stands, true);
    }
    all.add("20-dominoes", "dominoes", {{"count", "20"}, {"spacing", "0.5"}, {"thickness", "0.1"}}, leaving(0.5),
            leaving(0.5), {"default", "rest", {{}, {}, 1e-4}}, false, {0.02, {}, 1e-4});
}

// Solving large piles exactly takes minutes. Balls that roll away give the outcome `moving`.
void add_piles(Structures& all) {
    all.add("200-cubes", "cubes", {{"count", "200"}, {"layers", "4"}}, piled, piled, {"default", "creep"}, false,
            {0.25, {}});
    all.add("200-mixed", "mixed", {{"count", "200"}, {"layers", "4"}}, piled, {},
            {"default", "moving", {0.25, {}}});
    all.add("20-rods-on-50-cubes", "rods", {{"count", "50"}, {"layers", "4"}, {"rods", "20"}, {"speed", "5"}},
            piled, {}, {"default", "creep"});
    all.add("wall-hit-by-50-kg", "wall-hit", {{"rows", "10"}, {"columns", "10"}, {"mass", "50"}, {"speed", "10"}},
            piled, {}, {"default", "moving"});
}

}  // namespace

std::vector<Chapter> structure_chapters() {
    Structures all;
    add_what_stands(all);
    add_what_is_at_the_limit(all);
    add_piles(all);
    return {all.chapter};
}

}  // namespace pushfactor::demos::reports::stability
