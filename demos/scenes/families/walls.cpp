// Walls of bricks in bond.
#include "demos/scenes/families/pieces.h"

namespace pushfactor::demos::families {

namespace {

using engine::Vector3;

const Vector3 brick(0.5, 0.25, 0.25);  // m
constexpr double kg_per_metre = 2.0;   // of brick; a whole one has 1 kg

const FamilyParameter rows{{"rows", "N", "number of rows", 0, 2, 40, true}, Draw::by_decades};
const FamilyParameter columns{{"columns", "N", "bricks per row", 0, 2, 40, true}, Draw::by_decades};
const FamilyParameter gap{{"gap", "M", "space between neighbours, m", 0, 0, 0.02}};

// Every second row begins and ends with half a brick.
SceneDescription bricks(const ParameterValues& values) {
    const double between = values.number("gap");
    const int n = values.whole("columns");
    const double step = brick.x() + between, width = n * step - between;
    SceneDescription scene = on_ground(values);
    for (int row = 0; row < values.whole("rows"); ++row) {
        double left = -0.5 * width;
        for (int i = 0; i < n + row % 2; ++i) {
            const bool half = row % 2 == 1 && (i == 0 || i == n);
            const double length = half ? 0.5 * (brick.x() - between) : brick.x();
            add_body(scene, "row " + std::to_string(row + 1) + " brick " + std::to_string(i + 1),
                     BoxShape{{length, brick.y(), brick.z()}}, kg_per_metre * length,
                     {left + 0.5 * length, (row + 0.5) * brick.y(), 0});
            left += length + between;
        }
    }
    return scene;
}

Prospect describe_wall(const ParameterValues& values, Random&) {
    return standing(bricks(values));
}

Prospect describe_wall_hit(const ParameterValues& values, Random& random) {
    SceneDescription scene = bricks(values);
    constexpr double radius = 0.3;  // m
    const double height = brick.y() * values.number("rows");
    const double aim = random.in(0.4, 0.9) * height, aside = random.in(-0.2, 0.2);
    add_body(scene, "ball", SphereShape{radius}, values.number("mass"), {aside, std::max(aim, radius + 0.01), 1.0})
        .velocity = Vector3(0, 0, -values.number("speed"));
    return comes_to_rest(values, std::move(scene), height, values.number("speed"));
}

}  // namespace

const Family wall{"wall",
                  "A wall of bricks in bond, with or without gaps between neighbours.",
                  "Stands: every brick lies on two others, or on a half and another, under its own middle.",
                  {rows, columns, gap, friction_of(0.3, 1.0)},
                  describe_wall};

const Family wall_hit{"wall-hit",
                      "A heavy ball flies into a wall of bricks.",
                      "Bricks come to rest; the ball may roll on for ever.",
                      {rows,
                       columns,
                       gap,
                       friction_of(0.3, 1.0),
                       {{"mass", "KG", "of the ball, kg", 0, 5, 500}, Draw::by_decades},
                       {{"speed", "M/S", "of the ball, m/s", 0, 5, 20}}},
                      describe_wall_hit};

}  // namespace pushfactor::demos::families
