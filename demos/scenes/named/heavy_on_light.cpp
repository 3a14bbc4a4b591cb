// A tower of touching cubes of 1 m and 1 kg, the topmost R times heavier. Each iteration carries a share of the
// weight down, so the number of iterations needed grows with R.
#include "demos/scenes/named/cube_tower.h"
#include "demos/scenes/named/named_scenes.h"

#include <array>

namespace pushfactor::demos::scenes {

std::span<const Parameter> heavy_on_light_parameters() {
    static constexpr std::array table{
        Parameter{"count", "N", "number of cubes [2]", 2, 1, 1000, true},
        Parameter{"mass-ratio", "R", "how much heavier the topmost cube is [100]", 100, 1e-6, 1e9},
    };
    return table;
}

SceneDescription heavy_on_light(const ParameterValues& parameters) {
    const Tower tower{
        .count = parameters.whole("count"), .side = 1.0, .mass = 1.0, .gap = -1e-4, .ground_gap = -1e-4};
    SceneDescription scene = cube_tower(tower);
    scene.name = "heavy-on-light";
    scene.bodies.back().mass = parameters.number("mass-ratio");
    scene.view = view_of_height(tower.count);
    return scene;
}

}  // namespace pushfactor::demos::scenes
