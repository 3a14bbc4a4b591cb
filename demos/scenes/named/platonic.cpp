// All solids have the volume of a ball of 0.5 m and 1 kg. They start in layers, in random order and orientation,
// each as likely, above the funnel of section 10.3.
#include "demos/scenes/named/platonic.h"

#include "demos/scenes/named/named_scenes.h"
#include "demos/scenes/random.h"

#include <algorithm>
#include <array>
#include <numbers>

namespace pushfactor::demos::scenes {

using engine::Vector3;

namespace {

constexpr double volume = 4.0 / 3.0 * std::numbers::pi * 0.125;  // m^3
constexpr double mu = 0.3;

std::vector<Vector3> on_unit_sphere(std::vector<Vector3> points) {
    for (Vector3& point : points) point.normalize();
    return points;
}

// The points with (0, +-a, +-b) and its cyclic permutations.
std::vector<Vector3> with_rectangles(double a, double b, std::vector<Vector3> points = {}) {
    for (const double s : {a, -a}) {
        for (const double t : {b, -b}) {
            points.insert(points.end(), {Vector3(0, s, t), Vector3(s, t, 0), Vector3(t, 0, s)});
        }
    }
    return points;
}

std::vector<Vector3> cube_points() {
    std::vector<Vector3> points;
    for (const double x : {1.0, -1.0}) {
        for (const double y : {1.0, -1.0}) {
            for (const double z : {1.0, -1.0}) points.emplace_back(x, y, z);
        }
    }
    return points;
}

constexpr std::array colours{"vermilion", "orange", "green", "blue", "violet"};

}  // namespace

const std::array<RegularSolid, 5>& regular_solids() {
    using std::numbers::phi;
    static const std::array<RegularSolid, 5> solids{
        RegularSolid{"tetrahedron", on_unit_sphere({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}})},
        RegularSolid{"cube", on_unit_sphere(cube_points())},
        RegularSolid{"octahedron",
                     {Vector3::UnitX(), -Vector3::UnitX(), Vector3::UnitY(), -Vector3::UnitY(), Vector3::UnitZ(),
                      -Vector3::UnitZ()}},
        RegularSolid{"dodecahedron", on_unit_sphere(with_rectangles(1.0 / phi, phi, cube_points()))},
        RegularSolid{"icosahedron", on_unit_sphere(with_rectangles(1.0, phi))},
    };
    return solids;
}

namespace {

constexpr std::array platonic_parameters{
    Parameter{"count", "N", "number of each solid [20]", 20, 1, 10000, true},
    Parameter{"seed", "N", "seed of places, order and orientations [1]", 1, 0, 1e9, true},
};

SceneDescription describe_platonic(const ParameterValues& parameters) {
    SceneDescription scene;
    scene.contacts = true;
    add_funnel_planes(scene, mu);

    std::array<FramedPolyhedron, 5> shapes;
    double reach = 0.0;  // m, of the largest corner
    for (std::size_t kind = 0; kind < shapes.size(); ++kind) {
        std::vector<Vector3> points = regular_solids()[kind].points;
        const double scale = elementary::cbrt(volume / make_polyhedron(points).shape.volume);
        for (Vector3& point : points) point *= scale;
        shapes[kind] = make_polyhedron(points);
        reach = std::max(reach, scale);
    }

    Random random(parameters.whole("seed"));
    const int count = 5 * parameters.whole("count");
    std::vector<std::size_t> order;
    for (int i = 0; i < count; ++i) order.push_back(static_cast<std::size_t>(i) % shapes.size());
    for (std::size_t i = order.size() - 1; i > 0; --i) {
        std::swap(order[i], order[static_cast<std::size_t>(random.in(0.0, static_cast<double>(i + 1)))]);
    }
    const std::vector<Vector3> places = funnel_places(count, reach, random);
    for (int i = 0; i < count; ++i) {
        const std::size_t kind = order[static_cast<std::size_t>(i)];
        BodyDescription body{.name = std::string(regular_solids()[kind].name) + " " + std::to_string(i + 1),
                             .mass = 1.0,
                             .position = places[static_cast<std::size_t>(i)],
                             .friction = mu,
                             .colour = colours[kind]};
        body.orientation = random_orientation(random);
        give_polyhedron(body, shapes[kind]);
        scene.bodies.push_back(body);
    }
    scene.view = view_into_funnel(count);
    return scene;
}

}  // namespace

constinit const SceneEntry platonic{"platonic",
                                    "The five regular solids are poured into the funnel and come to rest.",
                                    platonic_parameters, describe_platonic};

}  // namespace pushfactor::demos::scenes
