// Polyhedra with faces that slope.
#include "demos/scenes/families/pieces.h"
#include "demos/scenes/named/arch.h"
#include "demos/scenes/named/named_scenes.h"

#include <vector>

namespace pushfactor::demos::families {

namespace {

using engine::Vector3;

// A body whose outline in the plane z = 0 are these corners.
void add_prism(SceneDescription& scene, const std::string& name, const std::vector<Vector3>& corners, double depth,
               double density) {
    std::vector<Vector3> points;
    for (const Vector3& corner : corners) {
        for (const double z : {-0.5 * depth, 0.5 * depth}) points.emplace_back(corner.x(), corner.y(), z);
    }
    const FramedPolyhedron polyhedron = make_polyhedron(points);
    give_polyhedron(add_body(scene, name, polyhedron.shape, density * polyhedron.shape.volume, Vector3::Zero()),
                    polyhedron);
}

// A column of cubes, each cut by a plane through its middle. What is above a cut presses straight down on it.
Prospect describe_cut_column(const ParameterValues& values, Random&) {
    constexpr double side = 1.0, density = 1000.0;  // m, kg/m^3
    const auto [sine, cosine] = elementary::sine_cosine(values.number("angle"));
    const double slope = sine / cosine;
    SceneDescription scene = on_ground(slope * more_than_limit(values));
    const int cubes = values.whole("cubes");
    for (int k = 0; k < cubes; ++k) {
        const double ground = k * side, cut = ground + 0.5 * side, rise = 0.5 * side * slope, half = 0.5 * side;
        const std::string name = "cube " + std::to_string(k + 1);
        add_prism(scene, name + " lower",
                  {{-half, ground, 0}, {half, ground, 0}, {-half, cut - rise, 0}, {half, cut + rise, 0}}, side,
                  density);
        add_prism(
            scene, name + " upper",
            {{-half, cut - rise, 0}, {half, cut + rise, 0}, {-half, ground + side, 0}, {half, ground + side, 0}},
            side, density);
    }
    return ends_by_limit(values, std::move(scene), Ends::slides, 15.0, "cube " + std::to_string(cubes) + " upper");
}

Prospect describe_arch(const ParameterValues& values, Random&) {
    const int voussoirs = values.whole("voussoirs");
    const double least = scenes::least_thickness({.voussoirs = voussoirs}, scenes::arch_friction);
    const double thickness = least * more_than_limit(values);
    ParameterValues of_arch(scenes::arch.parameters);
    for (const Parameter& parameter : scenes::arch.parameters) {
        if (parameter.name == "voussoirs") of_arch.set(parameter, std::to_string(voussoirs));
        if (parameter.name == "thickness") of_arch.set(parameter, std::to_string(thickness));
    }
    SceneDescription scene = scenes::arch.describe(of_arch);
    scene.gravity = Vector3(0, -gravity, 0);
    scene.bodies.push_back({.name = "ground", .shape = PlaneShape{}, .position = {0, *scene.view.floor, 0}});
    return ends_by_limit(values, std::move(scene), Ends::slides, 8.0,
                         "voussoir " + std::to_string((voussoirs + 1) / 2));
}

}  // namespace

const Family cut_column{"cut-column",
                        "A column of cubes of 1 m, each cut in two by an inclined plane.",
                        "Stands if friction exceeds the tangent of the cuts' angle, else the upper halves slide.",
                        {{{"cubes", "N", "number of cubes", 0, 1, 12, true}},
                         {{"angle", "RAD", "of the cuts, rad", 0, 0.1, 0.6}},
                         inside_of("1: more friction than the limit, 0: less"),
                         beyond_of(0.05, 0.3, "share of the limit by which it is more or less")},
                        describe_cut_column};

const Family arch{"arch",
                  "A semicircular arch, thicker or thinner than the least thickness that can stand.",
                  "Stands if a line of thrust fits inside its joints (Heyman 1966), else it falls.",
                  {{{"voussoirs", "N", "number of voussoirs", 0, 4, 61, true}},
                   inside_of("1: thicker than the limit, 0: thinner"),
                   beyond_of(0.02, 0.3, "share of the limit by which it is more or less")},
                  describe_arch};

}  // namespace pushfactor::demos::families
