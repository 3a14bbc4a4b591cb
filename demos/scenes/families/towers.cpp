// Towers of planks that touch exactly.
#include "demos/scenes/families/pieces.h"

#include <numbers>

namespace pushfactor::demos::families {

namespace {

using engine::Vector3;

const Vector3 plank(1.2, 0.08, 0.24);  // m
constexpr double plank_mass = 14.0;    // kg
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

Prospect describe_crossed(const ParameterValues& values, Random&) {
    const double gap = values.number("gap");
    SceneDescription scene = on_ground(values);
    constexpr double height = 0.1, width = 0.3, length = 1.0;  // m
    for (int k = 0; k < values.whole("layers"); ++k) {
        for (int i = -1; i <= 1; ++i) {
            const double beside = i * (width + gap), y = (k + 0.5) * height;
            const bool across = k % 2 == 1;
            add_body(scene, name_of_plank("layer ", k, i + 1),
                     BoxShape{across ? Vector3(width, height, length) : Vector3(length, height, width)}, 10.0,
                     across ? Vector3(beside, y, 0) : Vector3(0, y, beside));
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

}  // namespace pushfactor::demos::families
