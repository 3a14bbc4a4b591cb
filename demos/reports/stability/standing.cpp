// Cases that should stand: towers, cubes of all sizes, overlaps, thin bodies.
#include "demos/reports/stability/cases.h"
#include "demos/reports/stability/scenes/scenes.h"

#include <fmt/format.h>

#include <cmath>

namespace pushfactor::demos::reports::stability {

namespace {

Chapter heavy_on_light() {
    Chapter chapter{"heavy-on-light", "A cube of up to 1e6 kg on a cube of 1 kg, 10 s: stands"};
    const Check deep{"max_penetration_m", 0.002};
    for (const std::string ratio : {"100", "1000", "1e4", "1e6"}) {
        const std::string name = "heavy-on-light-" + ratio;
        const OptionTexts options{{"mass-ratio", ratio}};
        chapter.add(name, "heavy-on-light", options, "rest", {deep}, {{"default", "rest"}, {"paper", "fall"}},
                    ratio == "1000");
        // To rounding, as there is no slop.
        chapter.add(name + "-to-rounding", "heavy-on-light", options, "rest", {{"penetration_at_end_m", 1e-9}},
                    {{"exact", "rest"}}, ratio == "1000");
    }
    chapter.add("light-on-heavy-1e6", "heavy-on-light", {{"mass-ratio", "1e-6"}}, "rest", {deep},
                with_paper("rest", "creep"));
    return chapter;
}

Chapter heights() {
    Chapter chapter{"heights", "Stacks of 2 to 40 cubes that touch, 60 s: stand on their axis"};
    for (const std::string count : {"2", "5", "10", "20", "40"}) {
        chapter.add("stack-of-" + count, "stack", {{"count", count}, {"gap", "-0.0001"}, {"seconds", "60"}}, "rest",
                    {{"max_off_axis_m", 1e-3}}, with_paper("rest", count.size() == 1 ? "creep" : "fly"));
    }
    return chapter;
}

Chapter steps() {
    Chapter chapter{"steps", "The stack of five at other steps than 1/60 s, 60 s: stands"};
    // m, a fiftieth of the edge: it lands in small steps, which do not solve every point of the impact.
    constexpr double off_axis = 0.048;
    struct Step {
        const char *name, *dt, *substeps;
    };
    for (const Step& step :
         {Step{"stack-dt-1-10", "1/10", "auto"}, Step{"stack-dt-1-30", "1/30", "auto"},
          Step{"stack-dt-1-1000", "1/1000", "auto"}, Step{"stack-dt-1-10-undivided", "1/10", "1"},
          Step{"stack-dt-1-30-undivided", "1/30", "1"}, Step{"stack-dt-1", "1", "auto"}}) {
        const std::string name = step.name;
        chapter.add(name, "stack", {{"dt", step.dt}, {"substeps", step.substeps}, {"seconds", "60"}}, "rest",
                    {{"max_off_axis_m", off_axis}},
                    with_paper("rest", name == "stack-dt-1-1000" ? "creep" : "fall"), name == "stack-dt-1-10");
    }
    return chapter;
}

Chapter sizes_and_places() {
    Chapter chapter{"sizes-and-places",
                    "Piles of five cubes of 1 mm to 1 km, far from the origin, under other gravity: rest"};
    // So many substeps that in one from rest a cube falls by at most a fiftieth of its edge.
    const auto add = [&chapter](const std::string& name, const Pile& wanted, const char* paper,
                                bool quick = false) {
        const int parts = static_cast<int>(std::ceil(std::sqrt(50.0 * wanted.gravity / wanted.side) / 60.0));
        chapter.add(name, pile(wanted), {{"substeps", std::to_string(std::max(1, parts))}}, "rest",
                    {{"max_penetration_m", 0.002, 0.0, wanted.side}, {"max_off_axis_m", 1e-3, 0.0, wanted.side}},
                    with_paper("rest", paper), quick);
    };
    const auto at = [](double place) { return Pile{.origin = engine::Vector3::Constant(place)}; };
    add("cubes-of-1-mm", {.side = 1e-3}, "moving", true);
    add("cubes-of-1-cm", {.side = 1e-2}, "moving");
    add("cubes-of-1-km", {.side = 1e3}, "creep");
    add("at-1e3-m", at(1e3), "creep");
    add("at-1e5-m", at(1e5), "creep");
    add("at-1e6-m", at(1e6), "creep", true);
    add("at-1e7-m", at(1e7), "creep");
    add("gravity-1000", {.gravity = 1000.0}, "moving");
    return chapter;
}

Chapter overlaps() {
    Chapter chapter{"overlaps", "Cubes that start in each other: separate without a velocity left"};
    const auto add = [&chapter](double overlap, const char* beta, const char* paper, bool quick = false) {
        chapter.add(fmt::format("overlap-{}-beta-{}", overlap, beta), overlapping(overlap),
                    {{"beta", beta}, {"seconds", "5"}}, "rest",
                    {{"max_upward_speed_m_per_s", 1e-6}, {"penetration_at_end_m", 0.0021}},
                    with_paper("rest", paper), quick);
        // With eight contact points and a push of a metre the cones are not always solved to tolerance.
        if (overlap == 1.0) chapter.cases.back().expected.front().reached = {1e-5};
    };
    for (const double overlap : {0.01, 0.1, 0.25, 0.5, 0.9, 1.0}) add(overlap, "0.2", "creep", overlap == 0.5);
    add(0.5, "0.05", "creep");
    add(1.0, "0.05", "creep");
    add(0.5, "1", "moving");
    add(1.0, "1", "moving");
    return chapter;
}

Chapter thin() {
    Chapter chapter{"thin", "Cards, a plank and a rod that lie, stand and lean, 20 s: stand"};
    const auto add = [&chapter](const SceneDescription& scene, double thickness, bool quick = false) {
        // Energy bar: a body of 1 kg lowered by a hundredth of its thickness.
        const Checks checks{{"max_penetration_m", 0.002, 0.0, thickness},
                            {"max_off_axis_m", 1e-3},
                            {"energy_change_at_end_j", 0.01, 0.0, usual_gravity * thickness}};
        chapter.add_at_both_steps(
            scene.name, scene, "20", "rest", [&](double) { return checks; }, [](double) { return of_both("rest"); },
            quick);
    };
    add(card_lying(), card_thickness);
    add(card_upright(), card_thickness);
    add(card_leaning(0.25), card_thickness);
    add(card_house(0.3), card_thickness, true);
    add(plank_on_supports(), plank_thickness);
    add(rod_lying(), card_thickness);
    return chapter;
}

}  // namespace

std::vector<Chapter> standing_chapters() {
    return {heavy_on_light(), heights(), steps(), sizes_and_places(), overlaps(), thin()};
}

std::vector<Chapter> chapters(bool quick) {
    std::vector<Chapter> all;
    for (const auto& some :
         {standing_chapters(), structure_chapters(), motion_chapters(), sliding_chapters(), bar_chapters()})
        all.insert(all.end(), some.begin(), some.end());
    if (!quick) return all;
    for (Chapter& chapter : all) std::erase_if(chapter.cases, [](const Case& one) { return !one.quick; });
    std::erase_if(all, [](const Chapter& chapter) { return chapter.cases.empty(); });
    return all;
}

}  // namespace pushfactor::demos::reports::stability
