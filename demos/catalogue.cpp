#include "demos/catalogue.h"

#include "demos/scenes/intersecting_stack.h"
#include "demos/scenes/stack.h"

#include <algorithm>
#include <array>

namespace pushfactor::demos {

std::span<const SceneEntry> catalogue() {
    static const std::array table{
        SceneEntry{"stack", "Five cubes fall onto the ground and onto each other, and should stand (section 10.1).",
                   "gravity, contacts, friction", scenes::stack_parameters(), scenes::stack},
        SceneEntry{
            "intersecting-stack",
            "Five cubes start inside each other and inside the ground, and should part gently (section 10.2).",
            "gravity, contacts, friction", scenes::intersecting_stack_parameters(), scenes::intersecting_stack},
    };
    return table;
}

const SceneEntry* find_scene(std::string_view name) {
    const auto scenes = catalogue();
    const auto found =
        std::find_if(scenes.begin(), scenes.end(), [name](const SceneEntry& entry) { return entry.name == name; });
    return found == scenes.end() ? nullptr : &*found;
}

Scene build_scene(const SceneEntry& entry, const Settings& settings) {
    return entry.build(ParameterValues(entry.parameters), settings);
}

}  // namespace pushfactor::demos
