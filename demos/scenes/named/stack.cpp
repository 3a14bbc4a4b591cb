// Paper section 10.1: cubes of 2.4 m and 1.2 kg, gravity 10 m/s^2, centres 3 m apart, the lowest 2 m above the
// ground.
#include "demos/scenes/named/cube_tower.h"
#include "demos/scenes/named/named_scenes.h"

#include <array>

namespace pushfactor::demos::scenes {

std::span<const Parameter> stack_parameters() {
    static constexpr std::array table{
        Parameter{"count", "N", "number of cubes [5]", 5, 1, 1000, true},
        Parameter{"gap", "M", "space between the cubes in m, and when given under the lowest too [0.6; 0.8 there]",
                  0.6, -2.3, 100},
        Parameter{"jitter", "M", "each cube starts up to M m sideways and turned by up to 0.02 rad [0]", 0, 0, 10},
        Parameter{"seed", "N", "seed of the jitter [1]", 1, 0, 1e9, true},
    };
    return table;
}

SceneDescription stack(const ParameterValues& parameters) {
    Tower tower;
    tower.count = parameters.whole("count");
    tower.gap = parameters.number("gap");
    if (parameters.given("gap")) tower.ground_gap = tower.gap;
    tower.jitter = parameters.number("jitter");
    tower.seed = parameters.whole("seed");

    SceneDescription scene = cube_tower(tower);
    scene.name = "stack";
    scene.view = view_of_height(tower.ground_gap + tower.count * tower.side + (tower.count - 1) * tower.gap);
    return scene;
}

}  // namespace pushfactor::demos::scenes
