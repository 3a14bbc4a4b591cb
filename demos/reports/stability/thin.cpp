// What is thin and stands or lies.
#include "demos/reports/stability/scenes/thin.h"

#include "demos/reports/stability/chapters.h"
#include "demos/reports/stability/scenes/pieces.h"

namespace pushfactor::demos::reports::stability {

Chapter thin() {
    Chapter chapter{"thin", "Cards, a plank and a rod that lie, stand and lean, 20 s: stand", {}};
    const auto add = [&chapter](const SceneDescription& scene, double thickness, bool quick = false) {
        add_at_both_steps(chapter, [&](double) {
            return Case{
                .name = scene.name,
                .own = scene,
                .options = {{"seconds", "20"}},
                .wanted = "rest",
                .checks = {{.measure = "max_penetration_m", .bar = 0.002, .scale = thickness},
                           {.measure = "max_off_axis_m", .bar = 1e-3},
                           // J: a body of 1 kg that is lowered by a hundredth of its thickness.
                           {.measure = "energy_change_at_end_j", .bar = 0.01, .scale = usual_gravity * thickness}},
                .expected = of_both("rest"),
                .quick = quick};
        });
    };
    add(card_lying(), card_thickness);
    add(card_upright(), card_thickness);
    add(card_leaning(0.25), card_thickness);
    add(card_house(0.3), card_thickness, true);
    add(plank_on_supports(), plank_thickness);
    add(rod_lying(), card_thickness);
    return chapter;
}

}  // namespace pushfactor::demos::reports::stability
