// Piles: dropped bodies come to rest somewhere, because every contact dissipates energy and none adds any.
#include "demos/scenes/families/pieces.h"
#include "demos/scenes/named/named_scenes.h"

#include <algorithm>
#include <cmath>

namespace pushfactor::demos::families {

namespace {

using engine::Vector3;

constexpr double pitch = 0.75;  // m between the centres of dropped bodies, none of which is larger
constexpr double cube = 0.4;    // m
constexpr const char* dissipates = "Comes to rest: every impact takes energy and nothing gives any.";

const FamilyParameter count{{"count", "N", "number of bodies", 0, 10, 5000, true}, Draw::by_decades};
const FamilyParameter layers{{"layers", "N", "layers in which they start", 0, 2, 20, true}};

// Layer by layer, each of `across` times `across` bodies, the lowest centre 0.6 m above the ground.
Vector3 place_of(int i, int across) {
    const double middle = 0.5 * (across - 1);
    const int in_layer = i % (across * across);
    const int row = in_layer / across;
    const int layer = i / (across * across);
    return {(in_layer % across - middle) * pitch, 0.6 + layer * pitch, (row - middle) * pitch};
}

std::string name_of_body(int i) {
    return "body " + std::to_string(i + 1);
}

Vector3 random_size(Random& random, double low, double high) {
    Vector3 size;
    for (double& edge : size) edge = random.in(low, high);
    return size;
}

void add_cube(SceneDescription& scene, int i, const Vector3& place, double mass, Random& random) {
    add_body(scene, name_of_body(i), BoxShape{Vector3::Constant(cube)}, mass, place).orientation =
        random_orientation(random);
}

void add_mixed_box(SceneDescription& scene, int i, const Vector3& place, Random& random) {
    const Vector3 size = random_size(random, 0.1, 0.5);
    const double mass = random.in(0.5, 5.0);
    add_body(scene, name_of_body(i), BoxShape{size}, mass, place).orientation = random_orientation(random);
}

// The last body is the highest; `speed` [m/s] is that at which it was thrown.
Prospect dropped(SceneDescription scene, const ParameterValues& values, double speed = 0.0) {
    const double height = scene.bodies.back().position.y();
    return comes_to_rest(values, std::move(scene), height, speed);
}

// A pile of bodies, each added by `add` at its place.
template <typename Add>
Prospect pile(const ParameterValues& values, const Add& add) {
    SceneDescription scene = on_ground(values);
    const int across = static_cast<int>(std::ceil(std::sqrt(values.number("count") / values.number("layers"))));
    for (int i = 0; i < values.whole("count"); ++i) add(scene, i, place_of(i, across));
    return dropped(std::move(scene), values);
}

Prospect describe_cubes(const ParameterValues& values, Random& random) {
    return pile(values, [&](SceneDescription& scene, int i, const Vector3& place) {
        add_cube(scene, i, place, 1.0, random);
    });
}

Prospect describe_boxes(const ParameterValues& values, Random& random) {
    return pile(values, [&](SceneDescription& scene, int i, const Vector3& place) {
        add_mixed_box(scene, i, place, random);
    });
}

Prospect describe_mixed(const ParameterValues& values, Random& random) {
    Prospect prospect = pile(values, [&](SceneDescription& scene, int i, const Vector3& place) {
        if (i % 3 == 1) return add_mixed_box(scene, i, place, random);
        const double mass = random.in(0.5, 5.0);
        if (i % 3 == 2) return add_cube(scene, i, place, mass, random);
        const double radius = random.in(0.15, 0.3);
        add_body(scene, name_of_body(i), SphereShape{radius}, mass, place);
    });
    prospect.stirred = true;
    return prospect;
}

// Cubes below, and rods thrown down from above.
Prospect describe_rods(const ParameterValues& values, Random& random) {
    const double speed = values.number("speed");
    SceneDescription scene = describe_cubes(values, random).scene;
    const double above = scene.bodies.back().position.y() + 1.0;
    for (int i = 0; i < values.whole("rods"); ++i) {
        const double length = random.in(0.5, 1.5);
        const double thickness = random.in(0.04, 0.1);
        const double x = random.in(-0.5, 0.5);
        const double z = random.in(-0.5, 0.5);
        BodyDescription& rod =
            add_body(scene, "rod " + std::to_string(i + 1), BoxShape{{length, thickness, thickness}},
                     100.0 * length * thickness, {x, above + 0.3 * i, z});
        const double slope = random.in(-0.1, 0.1);
        rod.orientation = turned(random.in(0.0, 6.0)) * inclined(slope);
        rod.velocity = Vector3(0, -speed, 0);
    }
    return dropped(std::move(scene), values, speed);
}

Prospect describe_plates(const ParameterValues& values, Random& random) {
    return pile(values, [&](SceneDescription& scene, int i, const Vector3& place) {
        Vector3 size = random_size(random, 0.3, 0.5);
        size.y() = values.number("thickness");
        const double angle = random.in(0.0, 6.0);
        add_body(scene, name_of_body(i), BoxShape{size}, 1000.0 * size.prod(), place).orientation =
            turned(angle) * inclined(random.in(-0.3, 0.3));
    });
}

Prospect describe_funnel(const ParameterValues& values, Random& random) {
    ParameterValues of_scene(scenes::funnel.parameters);
    const int seed = static_cast<int>(random.in(0.0, 1e6));
    for (const Parameter& parameter : scenes::funnel.parameters) {
        of_scene.set(parameter, std::to_string(parameter.name == "seed" ? seed : values.whole("count")));
    }
    SceneDescription scene = scenes::funnel.describe(of_scene);
    double top = 0.0;  // m
    for (BodyDescription& body : scene.bodies) {
        body.friction = values.number("friction");
        top = std::max(top, body.position.y());
    }
    return {.scene = std::move(scene), .ends = Ends::rests, .rest_by = 10.0 + 3.0 * std::sqrt(2.0 * top / gravity)};
}

}  // namespace

const Family cubes{"cubes",
                   "Equal cubes of 0.4 m, turned at random, are dropped in layers.",
                   dissipates,
                   {count, layers, friction_of(0.1, 1.0)},
                   describe_cubes};

const Family boxes{"boxes",
                   "Boxes with edges of 0.1 to 0.5 m and masses of 0.5 to 5 kg are dropped in layers.",
                   dissipates,
                   {count, layers, friction_of(0.1, 1.0)},
                   describe_boxes};

const Family mixed{"mixed",
                   "Balls, boxes and cubes, a third each, of 0.5 to 5 kg, are dropped in layers.",
                   "Comes to rest but for balls, which may roll for ever and push boxes.",
                   {count, layers, friction_of(0.1, 1.0)},
                   describe_mixed};

const Family rods{"rods",
                  "Rods are thrown down on cubes that are dropped.",
                  dissipates,
                  {{{"count", "N", "number of cubes", 0, 5, 1000, true}, Draw::by_decades},
                   layers,
                   {{"rods", "N", "number of rods", 0, 3, 500, true}, Draw::by_decades},
                   {{"speed", "M/S", "at which the rods are thrown, m/s", 0, 0, 20}},
                   friction_of(0.1, 1.0)},
                  describe_rods};

const Family plates{"plates",
                    "Plates of 0.3 to 0.5 m and 1000 kg/m^3 are dropped in layers, nearly flat.",
                    dissipates,
                    {{{"count", "N", "number of plates", 0, 5, 1000, true}, Draw::by_decades},
                     layers,
                     {{"thickness", "M", "of a plate, m", 0, 0.02, 0.1}},
                     friction_of(0.1, 1.0)},
                    describe_plates};

const Family funnel{
    "funnel",
    "Balls of 0.5 m fall into a funnel of four planes.",
    "Comes to rest: no ball can roll anywhere but down.",
    {{{"count", "N", "number of balls", 0, 5, 2000, true}, Draw::by_decades}, friction_of(0.2, 0.8)},
    describe_funnel};

}  // namespace pushfactor::demos::families
