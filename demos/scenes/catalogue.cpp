#include "demos/scenes/catalogue.h"

#include "demos/scenes/named/arch.h"
#include "demos/scenes/named/named_scenes.h"
#include "demos/scenes/named/platonic.h"

#include <algorithm>
#include <array>

namespace pushfactor::demos {

std::span<const SceneEntry> catalogue() {
    using namespace scenes;
    static const std::array table{
        SceneEntry{"stack", "Five cubes fall onto the ground and onto each other, and should stand (Figure 6).",
                   stack_parameters(), stack},
        SceneEntry{"intersecting-stack",
                   "Five cubes start inside each other and half in the ground, and should part gently (Figure 7).",
                   intersecting_stack_parameters(), intersecting_stack},
        SceneEntry{"funnel", "Twenty balls fall into a funnel of four infinite planes and come to rest (Figure 8).",
                   funnel_parameters(), funnel},
        SceneEntry{"pendulum-grid",
                   "Twenty-five pendulums side by side hold spheres and boxes up, until one is poked (Figure 9).",
                   pendulum_grid_parameters(), pendulum_grid},
        SceneEntry{"pendulum-wave",
                   "Fifty pendulums of graded length run out of phase and, after two minutes, back in (Figure 10).",
                   pendulum_wave_parameters(), pendulum_wave},
        SceneEntry{"chain", "A chain of bars swings down from the horizontal with a weight at its end.",
                   chain_parameters(), chain},
        SceneEntry{"heavy-on-light",
                   "A heavy cube stands on light ones: a mass ratio that iterations alone do not solve.",
                   heavy_on_light_parameters(), heavy_on_light},
        SceneEntry{"arch", "A semicircular arch of loose voussoirs stands by weight, contact and friction.",
                   arch_parameters(), arch},
        SceneEntry{"dominoes", "A row of dominoes falls, one knocking over the next.", dominoes_parameters(),
                   dominoes},
        SceneEntry{"platonic", "The five regular solids are poured into the funnel and come to rest.",
                   platonic_parameters(), platonic},
    };
    return table;
}

const SceneEntry* find_scene(std::string_view name) {
    const auto scenes = catalogue();
    const auto found = std::ranges::find(scenes, name, &SceneEntry::name);
    return found == scenes.end() ? nullptr : &*found;
}

std::string made_of(const SceneDescription& description) {
    const auto has = [&](double BodyDescription::*what) {
        return std::any_of(description.bodies.begin(), description.bodies.end(),
                           [what](const BodyDescription& body) { return body.*what > 0.0; });
    };
    std::string parts = std::to_string(description.bodies.size()) + " bodies";
    if (!description.gravity.isZero()) parts += ", gravity";
    if (!description.forces.empty()) parts += ", " + std::to_string(description.forces.size()) + " forces";
    if (!description.distances.empty()) parts += ", " + std::to_string(description.distances.size()) + " distances";
    if (!description.joints.empty()) parts += ", " + std::to_string(description.joints.size()) + " joints";
    if (description.contacts) parts += ", contacts";
    if (description.contacts && has(&BodyDescription::friction)) parts += ", friction";
    if (description.contacts && has(&BodyDescription::restitution)) parts += ", restitution";
    if (description.contacts && !description.materials.empty()) parts += ", material pairs";
    return parts;
}

}  // namespace pushfactor::demos
