// A chain of balls on bars of 1 m, released from the horizontal. Under a heavy end it is stiff against sideways
// motion, which the time step has to resolve.
#include "demos/scenes/named/named_scenes.h"

#include <array>
#include <numbers>

namespace pushfactor::demos::scenes {

using engine::Vector3;

namespace {

constexpr std::array chain_parameters{
    Parameter{"links", "N", "number of bars [20]", 20, 1, 10000, true},
    Parameter{"end-mass", "KG", "mass of the last ball in kg, the others have 1 [1]", 1, 1e-6, 1e9},
    Parameter{"angle", "DEG", "where it starts, degrees from hanging straight down [90]", 90, -180, 180},
};

SceneDescription describe_chain(const ParameterValues& parameters) {
    constexpr double length = 1.0;  // m
    constexpr double radius = 0.2;  // m, drawn only; the bars hold the centres
    const int links = parameters.whole("links");
    const double end_mass = parameters.number("end-mass");
    const double angle = parameters.number("angle") * std::numbers::pi / 180.0;
    const Vector3 along(elementary::sin(angle), -elementary::cos(angle), 0.0);

    SceneDescription scene;
    for (int i = 1; i <= links; ++i) {
        const bool end = i == links;
        BodyDescription ball{
            .name = "ball " + std::to_string(i),
            .shape = SphereShape{end ? radius * std::clamp(elementary::cbrt(end_mass), 1.0, 8.0) : radius},
            .mass = end ? end_mass : 1.0,
            .position = (i * length) * along};
        ball.colour = end ? "vermilion" : "ivory";
        scene.distances.push_back({.a = {i == 1 ? "world" : scene.bodies.back().name, Vector3::Zero()},
                                   .b = {ball.name, Vector3::Zero()},
                                   .length = length});
        scene.bodies.push_back(ball);
    }
    const double reach = links * length;
    scene.view = view_of({0, -0.42 * reach, 0}, 0.98 * reach);
    scene.view.floor = -1.15 * reach;
    return scene;
}

}  // namespace

constinit const SceneEntry chain{"chain",
                                 "A chain of bars swings down from the horizontal with a weight at its end.",
                                 chain_parameters, describe_chain};

}  // namespace pushfactor::demos::scenes
