// The scene for every engine: what `pushfactor scene` prints, so that bodies, positions, masses and friction are
// the same to the last digit.
#pragma once

#include <Eigen/Geometry>

#include <string>
#include <vector>

namespace pushfactor::tests::peers {

using Vector3 = Eigen::Vector3d;
using Quaternion = Eigen::Quaterniond;

inline constexpr double step_length = 1.0 / 60.0;  // s, of scenes of files

// World frame, SI units.
struct State {
    Vector3 position = Vector3::Zero();
    Quaternion orientation = Quaternion::Identity();
    Vector3 velocity = Vector3::Zero();
    Vector3 angular_velocity = Vector3::Zero();
};

enum class Shape { plane, box, sphere };  // a plane's normal is the body's y axis

struct Body {
    Shape shape = Shape::sphere;
    Vector3 size = Vector3::Zero();     // edges of a box, m
    double radius = 0.0;                // of a sphere, m
    double mass = 0.0;                  // kg, of a movable body
    Vector3 moments = Vector3::Zero();  // kg m^2, about the body's axes; zero: those of the uniform solid
    double friction = 0.0;              // of a pair: the root of the product
    double restitution = 0.0;           // the same for both of a pair
    State start;
};

// A massless bar between a point of body a and a point of body b.
struct Link {
    int a = -1;  // place in Scene::movable, or -1: the world
    int b = -1;
    Vector3 point_a, point_b;  // body frame, m
    double length = 0.0;       // m
};

struct Scene {
    std::string name;
    Vector3 gravity = Vector3::Zero();  // m/s^2
    std::vector<Body> fixed, movable;
    std::vector<Link> links;
    bool contacts = false;
    double step = step_length;  // s
};

// Throws std::runtime_error with the file's name when it cannot be read.
Scene read_scene(const std::string& file);

// Its own, or those of a uniform box or sphere, in the body's axes, kg m^2.
Vector3 inertia(const Body& body);

// World positions of a link's two ends, m.
Vector3 end_a(const Link& link, const std::vector<State>& states);
Vector3 end_b(const Link& link, const std::vector<State>& states);

std::vector<State> starts(const Scene& scene);

}  // namespace pushfactor::tests::peers
