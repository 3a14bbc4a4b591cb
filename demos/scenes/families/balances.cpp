// What stands or falls by where its centre of mass is.
#include "demos/scenes/families/pieces.h"

namespace pushfactor::demos::families {

namespace {

using engine::Vector3;

// The harmonic overhang: the common centre of the k topmost blocks is over the edge of the block below if the k-th
// of them is L / (2 k) farther out than that block. All blocks are at their limit together.
Prospect describe_overhang(const ParameterValues& values, Random&) {
    const Vector3 block(1.0, 0.25, 0.5);  // m
    const double share = less_than_limit(values);
    const int n = values.whole("blocks");
    SceneDescription scene = on_ground(values);
    double x = 0.0;
    for (int i = 0; i < n; ++i) {
        if (i > 0) x += share * block.x() / (2.0 * (n - i));
        add_body(scene, "block " + std::to_string(i + 1), BoxShape{block}, 1.0, {x, (i + 0.5) * block.y(), 0});
    }
    return ends_by_limit(values, std::move(scene), Ends::topples, 8.0, "block " + std::to_string(n));
}

// The plank is shifted so that the common centre of it and of the two weights is off the middle of the block by a
// share of half its width.
Prospect describe_seesaw(const ParameterValues& values, Random&) {
    const Vector3 board(2.0, 0.1, 0.5);                      // m
    constexpr double edge = 0.3, height = 0.4, mass = 10.0;  // m, m, kg: of a weight, the block, the board
    const double share = less_than_limit(values), width = values.number("width");
    const double light = 1.0, heavy = values.number("ratio");  // kg
    const double arm = 0.5 * (board.x() - edge);
    const double centre = (heavy - light) * arm / (mass + light + heavy);
    const double shift = 0.5 * share * width - centre;
    SceneDescription scene = on_ground(values);
    add_body(scene, "block", BoxShape{{width, height, board.z()}}, mass, {0, 0.5 * height, 0});
    add_body(scene, "board", BoxShape{board}, mass, {shift, height + 0.5 * board.y(), 0});
    const double top = height + board.y() + 0.5 * edge;
    add_body(scene, "light", BoxShape{Vector3::Constant(edge)}, light, {shift - arm, top, 0});
    add_body(scene, "heavy", BoxShape{Vector3::Constant(edge)}, heavy, {shift + arm, top, 0});
    return ends_by_limit(values, std::move(scene), Ends::slides, 12.0, "heavy");
}

}  // namespace

const Family overhang{
    "overhang",
    "Blocks that overhang by a share less or more than the maximum.",
    "Inside the harmonic limit L / (2 k) of the k-th block from above it stands, outside it topples.",
    {{{"blocks", "N", "number of blocks", 0, 2, 12, true}},
     inside_of("1: inside the limit, 0: outside"),
     beyond_of(0.02, 0.2, "share of the limit that is left or exceeded"),
     friction_of(0.3, 1.0)},
    describe_overhang};

const Family seesaw{
    "seesaw",
    "A board across a narrow block, with a light and a heavy cube on its ends.",
    "Stands while the common centre of board and cubes is over the block, else the heavy cube goes down.",
    {{{"ratio", "R", "mass of the heavy cube over that of the light one", 0, 1, 300}, Draw::by_decades},
     {{"width", "M", "of the block, m", 0, 0.05, 0.4}},
     inside_of("1: over the block, 0: beside it"),
     beyond_of(0.02, 0.2, "share of half the width that is left or exceeded"),
     friction_of(0.3, 1.0)},
    describe_seesaw};

}  // namespace pushfactor::demos::families
