// Scenes of the stress list: their building blocks, and those that several files know. Bodies that do not touch
// each other share a scene. Unless stated otherwise cubes have 1 m and bodies 1 kg; speeds are in m/s, angles in
// rad.
#pragma once

#include "demos/scenes/families/pieces.h"

#include <string>
#include <utility>
#include <vector>

namespace pushfactor::demos::reports::stability {

using engine::Quaternion;
using engine::Vector3;
using families::inclined;
using families::turned;

constexpr double usual_gravity = 10.0;  // m/s^2

inline BodyDescription ground() {
    return {.name = "ground", .shape = PlaneShape{}};
}

inline BodyDescription ball(double radius, const Vector3& position, const Vector3& velocity = Vector3::Zero()) {
    return {.name = "ball", .shape = SphereShape{radius}, .mass = 1.0, .position = position, .velocity = velocity};
}

inline BodyDescription box(const std::string& name, const Vector3& size, const Vector3& position,
                           const Vector3& velocity = Vector3::Zero()) {
    return {.name = name, .shape = BoxShape{size}, .mass = 1.0, .position = position, .velocity = velocity};
}

// Of 1 m, with this number from 0.
inline BodyDescription cube(int number, const Vector3& position, const Vector3& velocity = Vector3::Zero()) {
    return box("cube " + std::to_string(number + 1), Vector3::Ones(), position, velocity);
}

inline BodyDescription wall(const std::string& name, const Vector3& size, const Vector3& position) {
    return {.name = name, .shape = BoxShape{size}, .position = position};
}

// A horizontal vector of this length, turned by `angle` about the vertical from the x axis.
inline Vector3 along(double angle, double length) {
    return turned(angle) * Vector3(length, 0, 0);
}

// Angular velocity [rad/s] with which a ball rolls on level ground at `velocity`.
inline Vector3 rolling(const Vector3& velocity, double radius) {
    return Vector3::UnitY().cross(velocity) / radius;
}

// A view of the origin from the right; `height` is the upward component of the direction. Pictures find their own
// distance.
inline View seen_from(double height) {
    return {.eye = 20.0 * Vector3(0.45, height, 1.0).normalized(), .target = Vector3::Zero()};
}

inline SceneDescription scene_of(const std::string& name, std::vector<BodyDescription> bodies) {
    SceneDescription scene;
    scene.name = name;
    scene.bodies = std::move(bodies);
    return scene;
}

// Bodies that may touch; `height` as in seen_from(), 0 for the usual view.
inline SceneDescription touching(const std::string& name, std::vector<BodyDescription> bodies,
                                 double height = 0.0) {
    SceneDescription scene = scene_of(name, std::move(bodies));
    scene.contacts = true;
    if (height > 0.0) scene.view = seen_from(height);
    return scene;
}

inline SceneDescription with_friction(SceneDescription scene, double friction) {
    for (BodyDescription& body : scene.bodies) body.friction = friction;
    return scene;
}

// Five stacked cubes, each overlapping the one below by a ten-thousandth of its side and slightly offset, so that
// no symmetry helps.
struct Pile {
    double side = 1.0;                 // m, of cubes as dense as water
    Vector3 origin = Vector3::Zero();  // m, below the lowest
    double gravity = usual_gravity;    // m/s^2
};
SceneDescription pile(const Pile& pile);

SceneDescription bouncing_ball();  // radius 0.1 m, dropped by 2 m, restitution 1

// Cards of 1 x 0.01 x 0.6 m: one inclined by `angle` against the edge of a box 0.4 m high; and two that lean
// against each other, each standing on its long edge.
constexpr double card_thickness = 0.01;  // m
SceneDescription card_leaning(double angle);
SceneDescription card_house(double angle);

// s, by the elliptic integral: of a rod 1 x 0.04 x 0.04 m that is hung by its end, from rest, `angle` from hanging.
double rod_pendulum_period(double angle);

// Five rods 0.5 x 0.04 x 0.04 m joined by ball joints, in a straight line `angle` from hanging, at rest.
SceneDescription ball_joint_chain(double angle);

// 16 cubes in a ring that slide outwards, each in a different direction relative to its edges, on a plane or a box.
SceneDescription cubes_in_16_directions(double speed, double friction, bool on_box);

// A slab of 1 x 0.2 x 1 m that slides and turns by `spin` [rad/s] about the vertical; gravity 9.81 m/s^2.
SceneDescription spinning_slab(double speed, double spin, double friction);

// Sliding distance of a slab that spins about the vertical while it slides: rigid, Coulomb friction at its four
// lower corners, always lying flat.
//
// The loads N of the corners follow from the weight and the moments about both horizontal axes (friction acts half
// the height below the centre): three equations for four unknowns. The fourth is a choice: here loads are linear in
// the position, as for a slab on elastic ground. Shifting a tenth of the weight from one pair of opposite corners
// to the other changes the result by half a percent.
struct Slab {
    double side = 1.0;      // m, of its square
    double height = 0.2;    // m
    double friction = 0.3;  // mu
    double gravity = 9.81;  // m/s^2
};

// Distance from start to stop [m] for `speed` [m/s] and `spin` [rad/s], not both zero.
double slide_of(const Slab& slab, double speed, double spin);

struct Ride {
    double speed = 4.0;   // m/s
    double angle = 0.0;   // rad, about the vertical, between the direction of motion and the rows of boxes
    double uneven = 0.0;  // m, by which every other box lies lower
};

// A cube and a plank 2 x 0.2 x 0.2 m, which slide without friction, and on an even floor a rolling ball of radius
// 0.5 m: on a floor of boxes, and the same bodies again on a single box behind it. The higher boxes of an uneven
// floor carry the bodies, so that both should move alike.
SceneDescription seam_floor(const Ride& ride);

}  // namespace pushfactor::demos::reports::stability
