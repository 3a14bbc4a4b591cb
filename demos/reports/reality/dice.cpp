#include "demos/reports/reality/dice.h"

#include "demos/platform/assets.h"
#include "demos/reports/reality/measured_file.h"
#include "demos/runs/scene.h"
#include "demos/scenes/random.h"
#include "demos/text/errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace pushfactor::demos::reports::reality {

namespace {

using engine::Vector3;

constexpr double square = 0.012;  // m, edge of the square face
constexpr double steel = 7800.0;  // kg/m^3
constexpr double gravity = 9.81;  // m/s^2
constexpr int most_seconds = 10;

SceneDescription thrown(double length, const Bounce& bounce, int number) {
    scenes::Random random(number);
    const Vector3 size(square, length * square, square);
    SceneDescription scene;
    scene.name = "die";
    scene.gravity = Vector3(0, -gravity, 0);
    scene.contacts = true;
    scene.bodies.push_back(
        {.name = "table", .shape = PlaneShape{}, .friction = bounce.friction, .restitution = bounce.restitution});
    const engine::Quaternion orientation = scenes::random_orientation(random);
    const Vector3 axis = scenes::random_orientation(random) * Vector3::UnitX();
    const double rate = random.in(0.0, 60.0), speed = random.in(0.0, 1.0);
    scene.bodies.push_back({.name = "die",
                            .shape = BoxShape{size},
                            .mass = steel * size.prod(),
                            .position = Vector3(0, 0.2, 0),
                            .orientation = orientation,
                            .velocity = Vector3(speed, 0, 0),
                            .angular_velocity = rate * axis,
                            .friction = bounce.friction,
                            .restitution = bounce.restitution});
    return scene;
}

// The face below, if the die can no longer get over one of its edges: 1 for the square one, none while it can. Over
// the border between two faces, where up_i / half_i is the same for both, the centre is nowhere lower than over
// their edge.
std::optional<Eigen::Index> decided_axis(const engine::Body& die, double length) {
    const Vector3 half(0.5 * square, 0.5 * length * square, 0.5 * square);
    const Vector3 up = die.orientation.conjugate() * Vector3::UnitY();
    Eigen::Index axis = 0;
    up.cwiseAbs().cwiseQuotient(half).maxCoeff(&axis);
    double barrier = half.norm();
    for (Eigen::Index other = 0; other < 3; ++other) {
        if (other != axis) barrier = std::min(barrier, std::hypot(half[axis], half[other]));
    }
    const double kinetic = 0.5 * die.inverse_mass * die.linear_momentum.squaredNorm() +
                           0.5 * die.angular_momentum.dot(engine::angular_velocity(die));
    if (kinetic * die.inverse_mass + gravity * die.position.y() >= gravity * barrier) return {};
    return axis;
}

bool ends_on_square(double length, const Bounce& bounce, int number) {
    Settings settings = preset_settings("default");
    settings.threads = 1;
    BuiltScene scene = build_scene(thrown(length, bounce, number), settings);
    const engine::Body& die = scene.world.bodies.at(1);
    for (int step = 0; step < most_seconds * 240; ++step) {
        if (const auto axis = decided_axis(die, length)) return *axis == 1;
        scene.step(scene.world, 1.0 / 240.0);
    }
    throw RunError(fmt::format("a die of length {} does not come to rest", length));
}

}  // namespace

std::vector<Die> read_dice() {
    std::vector<Die> dice;
    for (const auto& line :
         numbers_of(asset_folder("measured") / "dice.csv", "length_over_square_edge,share_square_face_up,throws")) {
        dice.push_back({line[0], line[1], static_cast<int>(line[2])});
    }
    return dice;
}

int square_faces(double length, const Bounce& bounce, int first, int throws, const std::function<void()>& check) {
    int found = 0;
    for (int number = first; number < first + throws; ++number) {
        check();
        found += ends_on_square(length, bounce, number) ? 1 : 0;
    }
    return found;
}

}  // namespace pushfactor::demos::reports::reality
