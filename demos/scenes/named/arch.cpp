// Voussoirs are prisms between two joints, which point to the centre of the arch; its inner and outer outlines are
// polygons. Nothing holds them but weight, contact and friction. The abutments are static.
#include "demos/scenes/named/arch.h"

#include "demos/scenes/named/named_scenes.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

namespace pushfactor::demos::scenes {

using engine::Quaternion;
using engine::Vector3;

namespace {

constexpr double density = 2000.0;   // kg/m^3
constexpr double mean_radius = 2.0;  // m
constexpr double depth = 0.8;        // m, of the arch along its axis
constexpr double abutment = 0.5;     // m, height of an abutment

// Points at a distance from the centre, at an angle from the crown.
Vector3 at(double radius, double angle, double z) {
    return {radius * elementary::sin(angle), radius * elementary::cos(angle), z};
}

void add_abutment(SceneDescription& scene, const std::string& name, double angle, double thickness, double mu) {
    // The joint is the upper face.
    const Vector3 up(-elementary::cos(angle), elementary::sin(angle), 0.0);
    const Vector3 outwards = angle > 0.0 ? up : Vector3(-up);
    const double turn = elementary::atan2(-outwards.x(), outwards.y());
    scene.bodies.push_back({.name = name,
                            .shape = BoxShape{Vector3(2.5 * thickness, abutment, 1.25 * depth)},
                            .position = at(mean_radius, angle, 0.0) - 0.5 * abutment * outwards,
                            .orientation = exponential(turn * Vector3::UnitZ()),
                            .friction = mu});
}

BodyDescription voussoir(double from, double to, double thickness) {
    const double inner = mean_radius - 0.5 * thickness, outer = mean_radius + 0.5 * thickness;
    std::vector<Vector3> points;
    for (const double z : {-0.5 * depth, 0.5 * depth}) {
        for (const double radius : {inner, outer}) {
            points.insert(points.end(), {at(radius, from, z), at(radius, to, z)});
        }
    }
    const FramedPolyhedron polyhedron = make_polyhedron(points);
    BodyDescription body{.mass = density * polyhedron.shape.volume};
    give_polyhedron(body, polyhedron);
    return body;
}

// What a joint carries of the half of an arch above it.
struct Joint {
    double angle;   // rad, from the crown
    double weight;  // of what is between the crown and the joint
    double moment;  // of the weight about the centre of the arch
};

std::vector<Joint> joints_of_half(const ArchShape& shape) {
    const double inner = 1.0 - 0.5 * shape.thickness, outer = 1.0 + 0.5 * shape.thickness;
    const double step = 2.0 * shape.half_angle / shape.voussoirs;
    // Area, and area times distance of its centre, of a triangle with the tip at the centre of the arch.
    const auto triangle = [&](double radius) {
        const double area = 0.5 * radius * radius * elementary::sin(step);
        return std::pair{area, area * 2.0 / 3.0 * radius * elementary::cos(0.5 * step)};
    };
    const auto [large, large_moment] = triangle(outer);
    const auto [small, small_moment] = triangle(inner);
    const double area = large - small, distance = (large_moment - small_moment) / area;

    std::vector<Joint> joints;
    double weight = 0.0, moment = 0.0;
    const bool on_crown = shape.voussoirs % 2 == 1;
    if (on_crown) {
        // Half of the keystone: its outline is a triangle with a right angle.
        const auto half = [&](double radius) {
            const double height = radius * elementary::cos(0.5 * step),
                         width = radius * elementary::sin(0.5 * step);
            return 0.5 * height * width * width / 3.0;
        };
        weight = 0.5 * area;
        moment = half(outer) - half(inner);
    }
    for (double angle = on_crown ? 0.5 * step : 0.0;; angle += step) {
        joints.push_back({angle, weight, moment});
        if (angle + 0.5 * step > shape.half_angle) break;
        weight += area;
        moment += area * distance * elementary::sin(angle + 0.5 * step);
    }
    return joints;
}

// The widest room, over all horizontal thrusts that friction allows, between the least and the greatest moment of
// the thrust at the crown. Negative: no thrust line stays within the arch.
double room(const std::vector<Joint>& joints, const ArchShape& shape, double friction) {
    const double inner = 1.0 - 0.5 * shape.thickness, outer = 1.0 + 0.5 * shape.thickness;
    // |H sin - W cos| <= friction (H cos + W sin) at each joint.
    double least = 0.0, greatest = 1e6 * joints.back().weight;
    for (const auto& [angle, weight, moment] : joints) {
        const double s = elementary::sin(angle), c = elementary::cos(angle);
        if (s + friction * c > 0.0) least = std::max(least, weight * (c - friction * s) / (s + friction * c));
        if (s - friction * c > 0.0) greatest = std::min(greatest, weight * (c + friction * s) / (s - friction * c));
    }
    if (least > greatest) return -std::numeric_limits<double>::infinity();
    const auto room_with = [&](double thrust) {
        double low = -std::numeric_limits<double>::infinity(), high = -low;
        for (const auto& [angle, weight, moment] : joints) {
            const double normal = thrust * elementary::cos(angle) + weight * elementary::sin(angle);
            low = std::max(low, inner * normal - moment);
            high = std::min(high, outer * normal - moment);
        }
        return high - low;
    };
    // Concave in the thrust.
    for (int i = 0; i < 200; ++i) {
        const double left = least + (greatest - least) / 3.0, right = greatest - (greatest - least) / 3.0;
        (room_with(left) < room_with(right) ? least : greatest) = room_with(left) < room_with(right) ? left : right;
    }
    return room_with(0.5 * (least + greatest));
}

// The least value in [low, high] for which `holds`, which holds from there on.
template <typename Holds>
double bisect(double low, double high, const Holds& holds) {
    while (high - low > 1e-9) {
        const double middle = 0.5 * (low + high);
        (holds(middle) ? high : low) = middle;
    }
    return high;
}

}  // namespace

bool can_stand(const ArchShape& shape, double friction) {
    return room(joints_of_half(shape), shape, friction) >= 0.0;
}

double least_thickness(ArchShape shape, double friction) {
    return bisect(0.01, 1.0, [&](double thickness) {
        shape.thickness = thickness;
        return can_stand(shape, friction);
    });
}

double least_friction(const ArchShape& shape) {
    return bisect(0.0, 2.0, [&](double friction) { return can_stand(shape, friction); });
}

namespace {

constexpr std::array arch_parameters{
    Parameter{"voussoirs", "N", "number of voussoirs [15]", 15, 2, 200, true},
    Parameter{"thickness", "T", "of the arch over its mean radius [0.12]", 0.12, 0.02, 0.9},
    Parameter{"half-angle", "DEG", "from the crown to a springing, in degrees [90]", 90, 10, 120},
};

SceneDescription describe_arch(const ParameterValues& parameters) {
    const int count = parameters.whole("voussoirs");
    const double thickness = parameters.number("thickness") * mean_radius;
    const double half = parameters.number("half-angle") * std::numbers::pi / 180.0;

    SceneDescription scene;
    scene.contacts = true;
    add_abutment(scene, "left abutment", -half, thickness, arch_friction);
    add_abutment(scene, "right abutment", half, thickness, arch_friction);
    const auto joint = [&](int k) { return half * (2.0 * k / count - 1.0); };
    for (int k = 0; k < count; ++k) {
        BodyDescription body = voussoir(joint(k), joint(k + 1), thickness);
        body.name = "voussoir " + std::to_string(k + 1);
        body.friction = arch_friction;
        body.colour = k % 2 == 0 ? "orange" : "vermilion";
        scene.bodies.push_back(body);
    }
    const double lowest = mean_radius * elementary::cos(half) - abutment;
    scene.view = view_of({0, 0.5 * (lowest + mean_radius), 0}, mean_radius - lowest);
    scene.view.eye = scene.view.target + 0.8 * (scene.view.eye - scene.view.target);
    scene.view.floor = lowest;
    return scene;
}

}  // namespace

constinit const SceneEntry arch{"arch",
                                "A semicircular arch of loose voussoirs stands by weight, contact and friction.",
                                arch_parameters, describe_arch};

}  // namespace pushfactor::demos::scenes
