#include "demos/reports/stability/scenes/small.h"

#include "demos/reports/stability/scenes/pieces.h"
#include "demos/scenes/named/view.h"

#include <cmath>

namespace pushfactor::demos::reports::stability {

namespace {

using engine::Vector3;

SceneDescription weightless(const std::string& name, BodyDescription body, const Vector3& turning) {
    SceneDescription scene;
    scene.name = name;
    scene.gravity.setZero();
    body.angular_velocity = turning;
    scene.bodies = {body};
    return scene;
}

}  // namespace

SceneDescription falling_cube(double gap, double speed) {
    BodyDescription cube = box("cube", Vector3::Ones(), {0, 0.5 + gap, 0});
    cube.velocity = {0, -speed, 0};
    return touching("falling-cube", {ground(), cube});
}

SceneDescription ball_on_plate(double speed) {
    return touching("ball-on-plate",
                    {wall("plate", {4, 0.1, 4}, {0, -0.15, 0}), ball(0.1, {0, 0.32, 0}, {0, -speed, 0})});
}

SceneDescription ball_past(const Vector3& size, double speed) {
    const double aside = 0.5 * size.x() + 0.2;
    SceneDescription scene =
        touching("ball-past", {wall("box", size, Vector3::Zero()), ball(0.1, {aside, 2.13, 0}, {0, -speed, 0})});
    scene.gravity.setZero();
    return scene;
}

SceneDescription free_rod(double rate) {
    return weightless("free-rod", box("rod", {2, 0.1, 0.1}, Vector3::Zero()), {rate, rate, 0});
}

SceneDescription free_box() {
    return weightless("free-box", box("box", {1, 4, 9}, Vector3::Zero()), {0.1, 3, 0.1});
}

SceneDescription tumbling_box() {
    SceneDescription scene = touching("tumbling-box", {ground(), box("box", {1, 0.4, 0.2}, {0, 2, 0})});
    for (BodyDescription& body : scene.bodies) body.friction = 0.0;
    scene.bodies.back().restitution = 1.0;
    scene.bodies.back().angular_velocity = {1, 4, 3};
    return scene;
}

SceneDescription bouncing_ball() {
    SceneDescription scene = touching("bouncing-ball", {ground(), ball(0.1, {0, 2.1, 0})});
    scene.bodies.back().restitution = 1.0;
    return scene;
}

SceneDescription pile(const Pile& pile) {
    SceneDescription scene = touching("pile", {ground()});
    scene.gravity = {0, -pile.gravity, 0};
    scene.bodies.front().position = pile.origin;
    for (int i = 0; i < pile.count; ++i) {
        const Vector3 place(0.003 * i, 0.5 - 1e-4 + i * (1.0 - 1e-4), -0.002 * i);
        scene.bodies.push_back(
            box("cube " + std::to_string(i + 1), Vector3::Constant(pile.side), pile.origin + pile.side * place));
        scene.bodies.back().mass = 1000.0 * std::pow(pile.side, 3);
    }
    scene.view =
        scenes::view_of(pile.origin + Vector3(0, 0.46 * pile.count * pile.side, 0), pile.count * pile.side);
    return scene;
}

SceneDescription overlapping(double overlap) {
    return touching("overlapping", {ground(), box("lower", Vector3::Ones(), {0, 0.5, 0}),
                                    box("upper", Vector3::Ones(), {0, 1.5 - overlap, 0})});
}

SceneDescription hanging(const std::vector<double>& lengths, double depth) {
    SceneDescription scene;
    scene.name = "hanging";
    scene.bodies = {ball(0.1, {0, -depth, 0})};
    scene.bodies.back().mass = 2.0;
    for (const double length : lengths) {
        scene.distances.push_back(
            {.a = {"world", Vector3::Zero()}, .b = {"ball", Vector3::Zero()}, .length = length});
    }
    return scene;
}

SceneDescription overlapping_walls() {
    return touching("overlapping-walls", {ground(), wall("one", Vector3::Ones(), {0, 0.3, 0}),
                                          wall("other", Vector3::Ones(), {0.2, 0.4, 0}), ball(0.1, {3, 0.1, 0})});
}

}  // namespace pushfactor::demos::reports::stability
