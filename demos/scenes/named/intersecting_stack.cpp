// Paper section 10.2: the cubes of 10.1 with their centres 2 m apart, an overlap of 0.4 m; the lowest overlaps the
// ground by 1.2 m. The original method throws them up, the single-frame push sets them down (Figure 7).
#include "demos/scenes/named/cube_tower.h"
#include "demos/scenes/named/named_scenes.h"

#include <array>

namespace pushfactor::demos::scenes {

std::span<const Parameter> intersecting_stack_parameters() {
    static constexpr std::array table{
        Parameter{"count", "N", "number of cubes [5]", 5, 1, 1000, true},
        Parameter{"gap", "M", "space between the cubes in m, below zero is overlap [-0.4]", -0.4, -2.3, 100},
    };
    return table;
}

SceneDescription intersecting_stack(const ParameterValues& parameters) {
    Tower tower;
    tower.count = parameters.whole("count");
    tower.gap = parameters.number("gap");
    tower.ground_gap = -0.5 * tower.side;

    SceneDescription scene = cube_tower(tower);
    scene.name = "intersecting-stack";
    // The same view for every push, so that pictures are comparable: a little more than the stack at rest. Cubes
    // that are thrown up leave it, unless --camera fit follows them.
    scene.view = view_of_height(1.25 * tower.count * tower.side);
    return scene;
}

}  // namespace pushfactor::demos::scenes
