// Structures of cubes and blocks.
#include "demos/scenes/families/pieces.h"

#include <cmath>
#include <numbers>

namespace pushfactor::demos::families {

namespace {

using engine::Vector3;

Prospect describe_pyramid(const ParameterValues& values, Random&) {
    const int rows = values.whole("rows");
    SceneDescription scene = on_ground(values);
    for (int row = 0; row < rows; ++row) {
        for (int i = 0; i < rows - row; ++i) {
            add_body(scene, "row " + std::to_string(row + 1) + " cube " + std::to_string(i + 1),
                     BoxShape{Vector3::Ones()}, row == rows - 1 ? values.number("mass-ratio") : 1.0,
                     {i - 0.5 * (rows - 1 - row), row + 0.5, 0});
        }
    }
    return standing(std::move(scene));
}

Prospect describe_stacks(const ParameterValues& values, Random& random) {
    const int stacks = values.whole("stacks");
    SceneDescription scene = on_ground(values);
    const int across = static_cast<int>(std::ceil(std::sqrt(stacks)));
    for (int k = 0; k < stacks; ++k) {
        const double side = random.in(0.3, 1.0);
        const double cubes = std::floor(random.in(2.0, 6.0));
        const int line = k / across;
        const Vector3 corner(2.0 * (k % across), 0, 2.0 * line);
        for (int i = 0; i < static_cast<int>(cubes); ++i) {
            const double x = side * random.in(-0.1, 0.1);
            const double z = side * random.in(-0.1, 0.1);
            const double angle = random.in(-0.2, 0.2);
            add_body(scene, "stack " + std::to_string(k + 1) + " cube " + std::to_string(i + 1),
                     BoxShape{Vector3::Constant(side)}, 1.0, corner + Vector3(x, (i + 0.5) * side, z))
                .orientation = turned(angle);
        }
    }
    return standing(std::move(scene));
}

// With an even number of cubes per side the ball sinks between the four middle ones by their gap.
Prospect describe_ball_on_cubes(const ParameterValues& values, Random&) {
    constexpr double side = 0.3, radius = 0.4;  // m
    const double gap = values.number("gap"), step = side + gap;
    const int n = values.whole("side");
    SceneDescription scene = on_ground(values);
    const double middle = 0.5 * (n - 1);
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            for (int k = 0; k < n; ++k) {
                add_body(scene, "cube " + std::to_string(scene.bodies.size()), BoxShape{Vector3::Constant(side)},
                         1.0, {(i - middle) * step, 0.5 * side + j * step, (k - middle) * step});
            }
        }
    }
    const double top = side + (n - 1) * step;
    const double beside = n % 2 == 0 ? 0.5 * gap * std::numbers::sqrt2 : 0.0;
    add_body(scene, "ball", SphereShape{radius}, values.number("mass"),
             {0, top + std::sqrt(radius * radius - beside * beside), 0});
    return standing(std::move(scene));
}

}  // namespace

const Family pyramid{"pyramid",
                     "A pyramid of cubes of 1 m and 1 kg in one plane, the topmost heavier.",
                     "Stands: every cube lies on two others under its own middle, whatever it weighs.",
                     {{{"rows", "N", "number of rows", 0, 2, 20, true}},
                      {{"mass-ratio", "R", "mass of the topmost, kg", 0, 1, 1000}, Draw::by_decades},
                      friction_of(0.3, 1.0)},
                     describe_pyramid};

const Family stacks{
    "stacks",
    "Independent stacks of two to five cubes, each a little off its axis.",
    "Stands: what is above a cube has its centre over it, as no cube is off by more than a tenth of its side.",
    {{{"stacks", "N", "number of stacks", 0, 4, 100, true}, Draw::by_decades}, friction_of(0.3, 1.0)},
    describe_stacks};

const Family ball_on_cubes{"ball-on-cubes",
                           "A heavy ball on n x n x n cubes of 0.3 m and 1 kg.",
                           "Stands: the ball presses straight down on columns of cubes.",
                           {{{"side", "N", "cubes per side", 0, 2, 4, true}},
                            {{"mass", "KG", "of the ball, kg", 0, 50, 5000}, Draw::by_decades},
                            {{"gap", "M", "space between the cubes, m", 0, 0, 0.001}},
                            friction_of(0.3, 1.0)},
                           describe_ball_on_cubes};

}  // namespace pushfactor::demos::families
