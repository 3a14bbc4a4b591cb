// Dominoes of the proportions of the game, 48 x 24 x 7.5 mm, on a table, a gap of half their height between two of
// them. The first one starts with the angular velocity that takes it a little beyond its balance. All lengths grow
// with --height, and speeds with its square root.
#include "demos/scenes/named/named_scenes.h"

#include <array>
#include <cmath>

namespace pushfactor::demos::scenes {

using engine::Vector3;

namespace {

constexpr double width_to_height = 0.5, thickness_to_height = 0.15625;
constexpr double domino_friction = 0.3;
constexpr double push = 1.5;  // energy of the first one over what its balance takes

// rad/s about the lower edge: the centre of mass has to rise by half of the diagonal less half of the height.
double push_speed(double height, double thickness, double gravity) {
    const double squared_diagonal = height * height + thickness * thickness;
    const double rise = 0.5 * (std::sqrt(squared_diagonal) - height);
    const double moment = squared_diagonal / 3.0;  // about the edge, per unit of mass
    return std::sqrt(2.0 * push * gravity * rise / moment);
}

constexpr std::array dominoes_parameters{
    Parameter{"count", "N", "number of dominoes [40]", 40, 1, 1000, true},
    Parameter{"height", "M", "of a domino in m [0.048]", 0.048, 1e-3, 100},
    Parameter{"spacing", "S", "gap between two of them, in heights [0.5]", 0.5, 0.01, 0.95},
};

SceneDescription describe_dominoes(const ParameterValues& parameters) {
    const int count = parameters.whole("count");
    const double height = parameters.number("height");
    const double thickness = thickness_to_height * height;
    const double pitch = thickness + parameters.number("spacing") * height;

    SceneDescription scene;
    scene.contacts = true;
    scene.bodies.push_back({.name = "table", .shape = PlaneShape{}, .friction = domino_friction});
    const Vector3 size(thickness, height, width_to_height * height);
    for (int i = 0; i < count; ++i) {
        BodyDescription domino{.name = "domino " + std::to_string(i + 1),
                               .shape = BoxShape{size},
                               .mass = 2000.0 * size.prod(),  // of 2 g/cm^3
                               .position = {pitch * (i - 0.5 * (count - 1)), 0.5 * height, 0.0},
                               .friction = domino_friction};
        if (i == 0) {
            const double rate = push_speed(height, thickness, -scene.gravity.y());
            domino.angular_velocity = {0, 0, -rate};
            domino.velocity = domino.angular_velocity.cross(Vector3(-0.5 * thickness, 0.5 * height, 0.0));
        }
        scene.bodies.push_back(domino);
    }
    // A domino of the game falls within a few steps of 1/60 s.
    scene.options = {{"substeps", "4"}};
    scene.view = view_of({0, 0.5 * height, 0}, 0.0);
    // The row fills the width: 1.22 m of it are seen per metre of distance.
    const double distance = 0.68 * (pitch * count + height);
    scene.view.eye = scene.view.target + distance * Vector3(0.35, 0.38, 1.0).normalized();
    return scene;
}

}  // namespace

constinit const SceneEntry dominoes{"dominoes", "A row of dominoes falls, one knocking over the next.",
                                    dominoes_parameters, describe_dominoes};

}  // namespace pushfactor::demos::scenes
