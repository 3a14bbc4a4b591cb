// Single bodies, piles, cards, planks and rods.
#include "demos/reports/stability/scenes/pieces.h"
#include "demos/scenes/named/named_scenes.h"

#include <cmath>
#include <numbers>

namespace pushfactor::demos::reports::stability {

namespace {

using engine::Quaternion;
using engine::Vector3;

SceneDescription weightless(const std::string& name, BodyDescription body, const Vector3& turning) {
    SceneDescription scene;
    scene.name = name;
    scene.gravity.setZero();
    body.angular_velocity = turning;
    scene.bodies = {body};
    return scene;
}

constexpr double height = 0.6;  // m, of a standing card
constexpr double rod_length = 1.0;
constexpr double rod_thickness = 0.04;
constexpr int links = 5;
constexpr double link_length = 0.5;

// Turned by `angle` [rad] about the z axis.
Quaternion inclined(double angle) {
    return exponential(angle * Vector3::UnitZ());
}

// A card on its long edge, leaning by `angle` towards +x (-x if negative): its lower edge is on the ground, and
// `at` [m] is the x coordinate of the farthest point of its upper end.
BodyDescription leaning_card(const std::string& name, double angle, double at) {
    const double sine = elementary::sin(std::abs(angle));
    const double cosine = elementary::cos(angle);
    const double reach = 0.5 * (height * sine + card_thickness * cosine);
    const double middle = 0.5 * (height * cosine + card_thickness * sine);
    BodyDescription card =
        box(name, {card_thickness, height, 1.0}, {angle > 0.0 ? at - reach : at + reach, middle, 0});
    card.orientation = inclined(-angle);
    return card;
}

// Direction of a rod that hangs from the origin in the plane z = 0, `angle` [rad] from the vertical.
Vector3 down_along(double angle) {
    return {elementary::sin(angle), -elementary::cos(angle), 0};
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
        scene.bodies.back().mass = 1000.0 * (pile.side * pile.side * pile.side);
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

SceneDescription card_lying() {
    return touching("card-lying",
                    {ground(), box("card", {1, card_thickness, height}, {0, 0.5 * card_thickness, 0})}, 0.5);
}

SceneDescription card_upright() {
    SceneDescription scene = touching(
        "card-upright",
        {ground(), wall("box", {0.4, 0.4, 1.2}, {0.2, 0.2, 0}), leaning_card("card", 0.0, card_thickness)}, 0.5);
    scene.bodies.back().position.x() = -0.5 * card_thickness;
    return scene;
}

SceneDescription card_leaning(double angle) {
    SceneDescription scene = touching(
        "card-leaning", {ground(), wall("box", {0.4, 0.4, 1.2}, {0.2, 0.2, 0}), leaning_card("card", angle, 0.0)});
    // Moved along x until its face touches the edge of the box.
    BodyDescription& card = scene.bodies.back();
    const Vector3 face = card.orientation * Vector3::UnitX();
    const Vector3 point = card.position + 0.5 * card_thickness * face;
    card.position.x() += face.dot(Vector3(0, 0.4, 0) - point) / face.x();
    scene.view = {.eye = {-6, 5, 14}};
    return scene;
}

SceneDescription card_house(double angle) {
    return touching("card-house", {ground(), leaning_card("left", angle, 0.0), leaning_card("right", -angle, 0.0)},
                    0.4);
}

SceneDescription plank_on_supports() {
    return touching(
        "plank-on-supports",
        {ground(), wall("left", {0.1, 0.3, 0.3}, {-0.8, 0.15, 0}), wall("right", {0.1, 0.3, 0.3}, {0.8, 0.15, 0}),
         box("plank", {2, plank_thickness, 0.2}, {0, 0.3 + 0.5 * plank_thickness, 0})},
        0.4);
}

SceneDescription rod_lying() {
    BodyDescription rod = box("rod", {1, card_thickness, card_thickness}, {0, 0.5 * card_thickness, 0});
    rod.orientation = turned(0.5);
    return touching("rod-lying", {ground(), rod}, 0.5);
}

SceneDescription rod_pendulum(double angle) {
    BodyDescription rod =
        box("rod", {rod_thickness, rod_length, rod_thickness}, 0.5 * rod_length * down_along(angle));
    rod.orientation = inclined(angle);
    SceneDescription scene;
    scene.name = "rod-pendulum";
    scene.bodies = {rod};
    scene.distances = {{.a = {"world", Vector3::Zero()}, .b = {"rod", {0, 0.5 * rod_length, 0}}, .length = 0.0}};
    scene.view = seen_from(0.1);
    return scene;
}

double rod_pendulum_period(double angle) {
    // Squared rate of small swings: m g l / 2 over the moment of inertia about the end; m = 1 kg.
    const double inertia = rod_length * rod_length / 3.0 + rod_thickness * rod_thickness / 12.0;  // m^2
    const double rate = std::sqrt(usual_gravity * 0.5 * rod_length / inertia);                    // rad/s
    return 4.0 * std::comp_ellint_1(elementary::sin(0.5 * angle)) / rate;
}

SceneDescription ball_joint_chain(double angle) {
    SceneDescription scene;
    scene.name = "ball-joint-chain";
    const Vector3 up(0, 0.5 * link_length, 0);
    std::string above = "world";
    for (int i = 0; i < links; ++i) {
        BodyDescription rod = box("rod " + std::to_string(i + 1), {rod_thickness, link_length, rod_thickness},
                                  (i + 0.5) * link_length * down_along(angle));
        rod.orientation = inclined(angle);
        scene.distances.push_back(
            {.a = {above, i == 0 ? Vector3(Vector3::Zero()) : Vector3(-up)}, .b = {rod.name, up}, .length = 0.0});
        above = rod.name;
        scene.bodies.push_back(rod);
    }
    scene.view = seen_from(0.1);
    return scene;
}

double ball_joint_chain_swing(double angle) {
    const double mass = links;  // kg
    return mass * usual_gravity * 0.5 * links * link_length * (1.0 - elementary::cos(angle));
}

}  // namespace pushfactor::demos::reports::stability
