#include "demos/scenes/catalogue.h"

#include "demos/scenes/named/named_scenes.h"

#include <algorithm>
#include <array>

namespace pushfactor::demos {

std::span<const SceneEntry> catalogue() {
    using namespace scenes;
    static const std::array table{stack, intersecting_stack, funnel, pendulum_grid, pendulum_wave,
                                  chain, heavy_on_light,     arch,   dominoes,      platonic};
    return table;
}

const SceneEntry* find_scene(std::string_view name) {
    const auto scenes = catalogue();
    const auto found = std::ranges::find(scenes, name, &SceneEntry::name);
    return found == scenes.end() ? nullptr : &*found;
}

std::vector<std::string> parameter_names() {
    std::vector<std::string> names;
    for (const SceneEntry& scene : catalogue()) {
        for (const Parameter& parameter : scene.parameters) {
            if (std::ranges::find(names, parameter.name) == names.end()) names.emplace_back(parameter.name);
        }
    }
    return names;
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
