// Towers of planks that touch exactly.
#include "demos/scenes/families/pieces.h"

#include <array>
#include <cmath>
#include <numbers>

namespace pushfactor::demos::families {

namespace {

using engine::Vector3;

const Vector3 plank(1.2, 0.08, 0.24);  // m
constexpr double plank_mass = 14.0;    // kg
const Vector3 slat(1.0, 0.1, 0.3);     // m, of three that lie side by side
constexpr double slat_mass = 10.0;     // kg
constexpr double within = 0.8;         // share of the support in which the centre of what is above it has to be
constexpr const char* upright = "Stands: each layer lies flat on the one below, under its own middle.";

std::string name_of_plank(const char* layer, int k, int i) {
    return layer + std::to_string(k + 1) + " plank " + std::to_string(i + 1);
}

// Each ring is turned by half a plank against the one below.
Prospect describe_round(const ParameterValues& values, Random&) {
    const int planks = values.whole("planks");
    SceneDescription scene = on_ground(values);
    // Neighbours do not touch: their inner corners are 3 cm tan(pi / planks) apart.
    const auto [sine, cosine] = elementary::sine_cosine(std::numbers::pi / planks);
    const double radius = 0.015 + 0.5 * plank.z() + 0.5 * plank.x() * cosine / sine;
    for (int ring = 0; ring < values.whole("rings"); ++ring) {
        for (int i = 0; i < planks; ++i) {
            const double angle = 2.0 * std::numbers::pi * (i + 0.5 * (ring % 2)) / planks;
            const Vector3 place(radius * elementary::cos(angle), (ring + 0.5) * plank.y(),
                                radius * elementary::sin(angle));
            add_body(scene, name_of_plank("ring ", ring, i), BoxShape{plank}, plank_mass, place).orientation =
                turned(-angle - 0.5 * std::numbers::pi);
        }
    }
    return standing(std::move(scene));
}

// Two planks side by side, and two across them.
Prospect describe_square(const ParameterValues& values, Random&) {
    SceneDescription scene = on_ground(values);
    const double out = 0.5 * (plank.x() - plank.z());
    for (int k = 0; k < 2 * values.whole("storeys"); ++k) {
        for (const int side : {-1, 1}) {
            const double y = (k + 0.5) * plank.y();
            const Vector3 place = k % 2 == 0 ? Vector3(0, y, side * out) : Vector3(side * out, y, 0);
            add_body(scene, name_of_plank("layer ", k, (side + 1) / 2), BoxShape{plank}, plank_mass, place)
                .orientation = turned(k % 2 == 0 ? 0.0 : 0.5 * std::numbers::pi);
        }
    }
    return standing(std::move(scene));
}

// Slat i of layer k, which lies across the layer below.
void add_slat(SceneDescription& scene, const std::string& name, int k, int i, double gap) {
    const double beside = (i - 1) * (slat.z() + gap), y = (k + 0.5) * slat.y();
    const bool along_x = k % 2 == 0;
    add_body(scene, name, BoxShape{along_x ? slat : Vector3(slat.z(), slat.y(), slat.x())}, slat_mass,
             along_x ? Vector3(0, y, beside) : Vector3(beside, y, 0));
}

Prospect describe_crossed(const ParameterValues& values, Random&) {
    const double gap = values.number("gap");
    SceneDescription scene = on_ground(values);
    for (int k = 0; k < values.whole("layers"); ++k) {
        for (int i = 0; i < 3; ++i) add_slat(scene, name_of_plank("layer ", k, i), k, i, gap);
    }
    return standing(std::move(scene));
}

using Storey = std::array<bool, 3>;  // which of three slats side by side are there

// The two outer edges of the slats of a storey, across them [m].
std::array<double, 2> support_of(const Storey& storey) {
    double left = 0.0, right = 0.0;
    for (std::size_t i = 3; i-- > 0;) left = storey[i] ? (static_cast<double>(i) - 1.5) * slat.z() : left;
    for (std::size_t i = 0; i < 3; ++i) right = storey[i] ? (static_cast<double>(i) - 0.5) * slat.z() : right;
    return {left, right};
}

// From the top down, slats are taken out where the centre of all that is above stays over those that remain.
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
    for (int k = 0; k < std::ssize(all); ++k) {
        for (int i = 0; i < 3; ++i) {
            const bool is_there = all[static_cast<std::size_t>(k)][static_cast<std::size_t>(i)];
            if (is_there) add_slat(scene, name_of_plank("storey ", k, i), k, i, 0.0);
        }
    }
    return standing(std::move(scene));
}

}  // namespace

const Family round_tower{"round-tower",
                         "A round tower of planks, each ring turned by half a plank.",
                         upright,
                         {{{"planks", "N", "planks per ring", 0, 8, 20, true}},
                          {{"rings", "N", "number of rings", 0, 2, 60, true}, Draw::by_decades},
                          friction_of(0.3, 1.0)},
                         describe_round};

const Family square_tower{
    "square-tower",
    "A square tower of planks, four per storey, laid like logs.",
    upright,
    {{{"storeys", "N", "number of storeys", 0, 2, 60, true}, Draw::by_decades}, friction_of(0.3, 1.0)},
    describe_square};

const Family crossed{"crossed",
                     "Layers of three planks, each across the one below.",
                     upright,
                     {{{"layers", "N", "number of layers", 0, 2, 60, true}, Draw::by_decades},
                      {{"gap", "M", "space between the planks of a layer, m", 0, 0, 0.05}},
                      friction_of(0.3, 1.0)},
                     describe_crossed};

const Family taken_out{"taken-out",
                       "Storeys of three planks, each across the one below, from which planks have been taken.",
                       "Stands: what is above a storey has its centre over the planks that are left of it.",
                       {{{"storeys", "N", "number of storeys", 0, 3, 40, true}, Draw::by_decades},
                        {{"taken", "X", "share of the planks that are tried", 0, 0, 0.7}},
                        friction_of(0.3, 1.0)},
                       describe_taken_out};

}  // namespace pushfactor::demos::families
