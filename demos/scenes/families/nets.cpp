// Nets of bars that hang.
#include "demos/scenes/families/pieces.h"

#include <Eigen/Core>

#include <string>

namespace pushfactor::demos::families {

namespace {

using engine::Vector3;

// A square net whose border is fixed in a horizontal plane. If all bars carry the same force per length q, the
// heights of the knots follow from 4 y - (sum of the neighbours' y) = - m g / q (force densities: Schek 1974). The
// lowest knot hangs by a quarter of the net's width.
Prospect describe_net(const ParameterValues& values, Random& random) {
    constexpr double mesh = 0.5, radius = 0.05;  // m
    const int n = values.whole("meshes"), inner = n - 1;
    const auto is_inner = [inner](int i, int j) { return i >= 1 && j >= 1 && i <= inner && j <= inner; };

    Eigen::MatrixXd masses = Eigen::MatrixXd::Zero(n + 1, n + 1), heights = masses;
    for (int i = 1; i <= inner; ++i) {
        for (int j = 1; j <= inner; ++j) masses(i, j) = random.in(0.5, 1.5);
    }
    masses(n / 2, n / 2) = values.number("mass");
    // The error falls by cos^2(pi / n) a sweep: far below rounding.
    for (int sweep = 0; sweep < 10 * n * n; ++sweep) {
        for (int i = 1; i <= inner; ++i) {
            for (int j = 1; j <= inner; ++j) {
                heights(i, j) = 0.25 * (heights(i - 1, j) + heights(i + 1, j) + heights(i, j - 1) +
                                        heights(i, j + 1) - masses(i, j));
            }
        }
    }
    heights *= 0.25 * n * mesh / -heights.minCoeff();

    SceneDescription scene;
    scene.gravity = Vector3(0, -gravity, 0);
    const auto name = [](int i, int j) { return "knot " + std::to_string(i) + " " + std::to_string(j); };
    const auto place = [&](int i, int j) { return Vector3(i * mesh, heights(i, j), j * mesh); };
    const auto end = [&](int i, int j) {
        return is_inner(i, j) ? DistanceDescription::End{name(i, j)}
                              : DistanceDescription::End{"world", place(i, j)};
    };
    for (int i = 1; i <= inner; ++i) {
        for (int j = 1; j <= inner; ++j) {
            scene.bodies.push_back(
                {.name = name(i, j), .shape = SphereShape{radius}, .mass = masses(i, j), .position = place(i, j)});
        }
    }
    for (int i = 0; i <= inner; ++i) {
        for (int j = 0; j <= inner; ++j) {
            if (j > 0) scene.distances.push_back({.a = end(i, j), .b = end(i + 1, j)});
            if (i > 0) scene.distances.push_back({.a = end(i, j), .b = end(i, j + 1)});
        }
    }
    return standing(std::move(scene));
}

}  // namespace

const Family net{
    "net",
    "A square net of bars between knots of 0.5 to 1.5 kg, its border fixed, with a weight in the middle.",
    "Stands: it hangs in the shape in which all bars pull with the same force per length.",
    {{{"meshes", "N", "meshes per side", 0, 2, 20, true}},
     {{"mass", "KG", "of the weight, kg", 0, 1, 1000}, Draw::by_decades}},
    describe_net};

}  // namespace pushfactor::demos::families
