// What stands or falls by where its centre of mass is.
#include "demos/scenes/families/pieces.h"

#include <array>
#include <cmath>

namespace pushfactor::demos::families {

namespace {

using engine::Vector3;

// Of planks, two thirds of whose places in a storey may stay empty.
const Vector3 slat(1.0, 0.1, 0.3);  // m
constexpr double slat_mass = 10.0;  // kg
constexpr double within = 0.8;      // share of the support in which the centre of what is above it has to be

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

using Storey = std::array<bool, 3>;  // which of three planks side by side are there

// The two outer edges of the planks of a storey, across them [m].
std::array<double, 2> support_of(const Storey& storey) {
    double left = 0.0, right = 0.0;
    for (std::size_t i = 3; i-- > 0;) left = storey[i] ? (static_cast<double>(i) - 1.5) * slat.z() : left;
    for (std::size_t i = 0; i < 3; ++i) right = storey[i] ? (static_cast<double>(i) - 0.5) * slat.z() : right;
    return {left, right};
}

// From the top down, planks are taken out where the centre of all that is above stays over those that remain.
std::vector<Storey> take_out(int storeys, double share, Random& random) {
    std::vector<Storey> all(static_cast<std::size_t>(storeys), Storey{true, true, true});
    double count = 3.0;
    std::array<double, 2> centre{};  // of what is above, times its number; along x, along z
    for (std::size_t k = all.size() - 1; k-- > 0;) {
        Storey storey;
        for (bool& there : storey) there = random.in(0.0, 1.0) >= share;
        const std::size_t across = k % 2 == 0 ? 1 : 0;  // even storeys lie along x
        const auto [left, right] = support_of(storey);
        const double middle = 0.5 * (left + right), above = centre[across] / count;
        if (std::abs(above - middle) < within * 0.5 * (right - left)) all[k] = storey;
        for (std::size_t i = 0; i < 3; ++i) {
            if (!all[k][i]) continue;
            count += 1.0;
            centre[across] += (static_cast<double>(i) - 1.0) * slat.z();
        }
    }
    return all;
}

Prospect describe_taken_out(const ParameterValues& values, Random& random) {
    SceneDescription scene = on_ground(values);
    const std::vector<Storey> all = take_out(values.whole("storeys"), values.number("taken"), random);
    for (std::size_t k = 0; k < all.size(); ++k) {
        const bool along_x = k % 2 == 0;
        for (std::size_t i = 0; i < 3; ++i) {
            if (!all[k][i]) continue;
            const double beside = (static_cast<double>(i) - 1.0) * slat.z();
            const double y = (static_cast<double>(k) + 0.5) * slat.y();
            add_body(scene, "storey " + std::to_string(k + 1) + " plank " + std::to_string(i + 1),
                     BoxShape{along_x ? slat : Vector3(slat.z(), slat.y(), slat.x())}, slat_mass,
                     along_x ? Vector3(0, y, beside) : Vector3(beside, y, 0));
        }
    }
    return standing(std::move(scene));
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

const Family taken_out{"taken-out",
                       "Storeys of three planks, each across the one below, from which planks have been taken.",
                       "Stands: what is above a storey has its centre over the planks that are left of it.",
                       {{{"storeys", "N", "number of storeys", 0, 3, 40, true}, Draw::by_decades},
                        {{"taken", "X", "share of the planks that are tried", 0, 0, 0.7}},
                        friction_of(0.3, 1.0)},
                       describe_taken_out};

}  // namespace pushfactor::demos::families
