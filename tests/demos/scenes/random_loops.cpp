#include "tests/demos/scenes/random_loops.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

namespace pushfactor::tests {

namespace {

using namespace demos;
using engine::Matrix3;
using engine::Quaternion;
using engine::Vector3;

enum class Held { ball, hinge, weld };

constexpr double pi = std::numbers::pi;

bool chance(Random& random, double share) {
    return random.in(0.0, 1.0) < share;
}

int count(Random& random, int low, int high) {
    return std::min(high, low + static_cast<int>(random.in(0.0, high - low + 1.0)));
}

// Bodies and joints at points of the world; masses differ by a factor of up to 100.
class Builder {
  public:
    Builder(const char* name, Random& random)
        : random_(random),
          middle_(std::exp(random.in(std::log(0.3), std::log(30.0)))),
          spread_(random.in(1.0, 10.0)) {
        scene.name = name;
        scene.gravity.setZero();
        scene.contacts = true;
    }

    // Lies along x in its own frame, which has z near `side`.
    int bar(const Vector3& from, const Vector3& to, double thickness, const Vector3& side = Vector3::UnitZ()) {
        const Vector3 x = (to - from).normalized();
        Vector3 y = side.cross(x);
        y = y.norm() > 1e-3 ? y.normalized() : x.unitOrthogonal();
        Matrix3 frame;
        frame << x, y, x.cross(y);
        return box({(to - from).norm(), thickness, thickness}, 0.5 * (from + to), Quaternion(frame));
    }
    int box(const Vector3& size, const Vector3& position, const Quaternion& orientation = Quaternion::Identity()) {
        scene.bodies.push_back({.name = std::to_string(scene.bodies.size()),
                                .shape = BoxShape{size},
                                .mass = mass(),
                                .position = position,
                                .orientation = orientation,
                                .friction = 0.5});
        return static_cast<int>(scene.bodies.size()) - 1;
    }

    JointDescription& join(int a, int b, const Vector3& point, Held held = Held::hinge,
                           const Vector3& axis = Vector3::UnitZ()) {
        JointDescription joint{.a = end(a, point), .b = end(b, point)};
        if (held != Held::ball) {
            const Vector3 own = a < 0 ? axis : Vector3(body(a).orientation.conjugate() * axis);
            joint.hinge = HingeDescription{.axis = own};
            if (held == Held::weld) joint.hinge->limits = engine::AngleLimits{0.0, 0.0};
        }
        scene.joints.push_back(joint);
        return scene.joints.back();
    }
    void spring(int a, const Vector3& at_a, int b, const Vector3& at_b, const engine::Spring& spring) {
        scene.distances.push_back({.a = end(a, at_a), .b = end(b, at_b), .spring = spring});
    }
    void rod(int a, const Vector3& at_a, int b, const Vector3& at_b) {
        scene.distances.push_back({.a = end(a, at_a), .b = end(b, at_b)});
    }

    // None of them touches another.
    void as_group() {
        for (BodyDescription& body : scene.bodies) body.group = "one";
    }

    SceneDescription scene;

  private:
    const BodyDescription& body(int number) const { return scene.bodies[static_cast<std::size_t>(number)]; }
    double mass() { return middle_ * std::pow(spread_, random_.in(-1.0, 1.0)); }
    DistanceDescription::End end(int number, const Vector3& point) const {
        if (number < 0) return {.body = "world", .point = point};
        const BodyDescription& own = body(number);
        return {.body = own.name, .point = own.orientation.conjugate() * (point - own.position)};
    }

    Random& random_;
    double middle_, spread_;
};

// Corners of a star-shaped polygon around the origin.
std::vector<Vector3> polygon(Random& random, int sides, double size) {
    std::vector<Vector3> corners;
    for (int k = 0; k < sides; ++k) {
        const double angle = 2.0 * pi * (k + random.in(-0.25, 0.25)) / sides, radius = size * random.in(0.7, 1.2);
        corners.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.0);
    }
    return corners;
}

// `held(k)` says how the joint after bar k holds, `axis()` about what.
template <typename Kind, typename Axis>
Builder ring_of(const char* name, Random& random, double out_of_plane, const Kind& held, const Axis& axis) {
    Builder made(name, random);
    const int sides = count(random, 3, 8);
    const double size = random.in(0.4, 1.4), thickness = size * random.in(0.04, 0.08);
    std::vector<Vector3> corners = polygon(random, sides, size);
    for (Vector3& corner : corners) corner.z() = size * random.in(-out_of_plane, out_of_plane);
    const auto corner = [&](int k) { return corners[static_cast<std::size_t>(k % sides)]; };
    for (int k = 0; k < sides; ++k) made.bar(corner(k), corner(k + 1), thickness);
    for (int k = 0; k < sides; ++k) made.join(k, (k + 1) % sides, corner(k + 1), held(), axis());
    return made;
}

Vector3 along_z() {
    return Vector3::UnitZ();
}

Held hinged() {
    return Held::hinge;
}

SceneDescription hinged_ring(Random& random) {
    return ring_of("hinged ring", random, 0.0, hinged, along_z).scene;
}

SceneDescription welded_ring(Random& random) {
    return ring_of(
               "welded ring", random, 0.3, [] { return Held::weld; }, along_z)
        .scene;
}

SceneDescription mixed_ring(Random& random) {
    const auto mixed = [&] { return chance(random, 0.4) ? Held::weld : Held::hinge; };
    return ring_of("mixed ring", random, 0.0, mixed, along_z).scene;
}

// With seven bars or more they move, with fewer they are rigid.
SceneDescription spatial_ring(Random& random) {
    const auto any = [&] { return random.rotation() * Vector3::UnitX(); };
    return ring_of("spatial ring", random, 0.4, hinged, any).scene;
}

Builder scissors_of(const char* name, Random& random) {
    Builder made(name, random);
    const int stages = count(random, 2, 5);
    const double length = random.in(0.5, 1.4), angle = random.in(0.4, 1.1);
    const double thickness = length * random.in(0.04, 0.08);
    const Vector3 half(0.5 * length * std::cos(angle), 0.5 * length * std::sin(angle), 0);
    const Vector3 mirrored(half.x(), -half.y(), 0), side(0, 0, 0.6 * thickness);
    for (int k = 0; k < stages; ++k) {
        const Vector3 middle(0, (2 * k - stages + 1) * half.y(), 0);
        made.bar(middle - half + side, middle + half + side, thickness);
        made.bar(middle - mirrored - side, middle + mirrored - side, thickness);
        made.join(2 * k, 2 * k + 1, middle);
        if (k == 0) continue;
        made.join(2 * k - 2, 2 * k + 1, middle + mirrored);
        made.join(2 * k - 1, 2 * k, middle - half);
    }
    return made;
}

SceneDescription scissors(Random& random) {
    return scissors_of("scissors", random).scene;
}

// Two rails and rungs, some with a brace.
SceneDescription ladder(Random& random) {
    Builder made("ladder", random);
    const double length = random.in(0.8, 2.0), width = random.in(0.3, 0.8), thickness = random.in(0.03, 0.08);
    const Vector3 along(0.5 * length, 0, 0), across(0, 0.5 * width, 0);
    made.bar(across - along, across + along, thickness);
    made.bar(-across - along, -across + along, thickness);
    const int rungs = count(random, 2, 5);
    for (int k = 0; k < rungs; ++k) {
        const Vector3 at = (2.0 * k / (rungs - 1) - 1.0) * along;
        const int rung = made.bar(at - across, at + across, thickness);
        made.join(0, rung, at + across, Held::weld);
        made.join(1, rung, at - across, Held::weld);
    }
    if (chance(random, 0.5)) {
        const int brace = made.bar(-along - across, along + across, thickness);
        made.join(0, brace, along + across, Held::weld);
        made.join(1, brace, -along - across, Held::weld);
    }
    made.as_group();
    return made.scene;
}

// The twelve edges of a block, and diagonals of `braced` of its faces. Bars meet the first one of their corner.
SceneDescription block_of_bars(const char* name, Random& random, Held held, int braced) {
    Builder made(name, random);
    const Vector3 half = random.vector(0.3, 0.7);
    const double thickness = random.in(0.03, 0.08);
    std::array<int, 8> first{};
    first.fill(-1);
    const auto place = [&](int corner) -> Vector3 {
        return half.cwiseProduct(Vector3(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1));
    };
    const auto add = [&](int from, int to) {
        const int own = made.bar(place(from), place(to), thickness);
        for (const int corner : {from, to}) {
            int& other = first[static_cast<std::size_t>(corner)];
            if (other < 0) {
                other = own;
            } else {
                made.join(other, own, place(corner), held);
            }
        }
    };
    for (int corner = 0; corner < 8; ++corner) {
        for (const int step : {1, 2, 4}) {
            if (!(corner & step)) add(corner, corner + step);
        }
    }
    for (int face = 0; face < braced; ++face) {
        const int across = 1 << face / 2, from = face % 2 ? across : 0;
        add(from, from + 7 - across);
    }
    made.as_group();
    return made.scene;
}

SceneDescription welded_block(Random& random) {
    const int braced = count(random, 0, 6);
    return block_of_bars("welded block", random, Held::weld, braced);
}

// Ball joints; six diagonals make it rigid but for the bars, which may turn about themselves.
SceneDescription truss(Random& random) {
    return block_of_bars("truss", random, Held::ball, 6);
}

// A chassis whose uprights are on two arms each, by hinges or by ball joints with a rod that steers.
SceneDescription wishbones(Random& random) {
    Builder made("wishbones", random);
    const double width = random.in(0.4, 1.0), height = random.in(0.2, 0.4), arm = random.in(0.3, 0.6);
    const double lower = arm * random.in(1.0, 1.3), wide = random.in(0.15, 0.3), thickness = random.in(0.03, 0.06);
    const bool steered = chance(random, 0.5), sprung = chance(random, 0.5), twice = chance(random, 0.5);
    const int axles = count(random, 1, 2);
    const double length = axles == 1 ? wide : 1.5;
    const int chassis = made.box({length, 0.6 * height, width}, Vector3::Zero());
    for (int corner = 0; corner < 2 * axles; ++corner) {
        const double side = corner % 2 ? 1.0 : -1.0, along = axles == 1 ? 0.0 : (corner < 2 ? -0.6 : 0.6);
        const auto at = [&](double x, double y, double z) { return Vector3(along + x, y, side * z); };
        const double gap = 0.5 * width + 0.02, high = 0.5 * height;
        const Vector3 upper_end = at(0, high, gap + arm), lower_end = at(0, -high, gap + lower);
        const int upright = made.bar(lower_end, upper_end, thickness, Vector3::UnitX());
        for (const bool top : {true, false}) {
            const double y = top ? high : -high, reach = top ? arm : lower;
            const int own = made.box({wide, thickness, reach - thickness}, at(0, y, gap + 0.5 * reach));
            for (const double x : {-0.4, 0.4}) {
                if (x > 0.0 && !twice) continue;
                JointDescription& joint =
                    made.join(chassis, own, at(twice ? x * wide : 0.0, y, gap), Held::hinge, Vector3::UnitX());
                if (x < 0.0) joint.hinge->limits = engine::AngleLimits{-0.5, 0.5};
            }
            made.join(own, upright, top ? upper_end : lower_end, steered ? Held::ball : Held::hinge,
                      Vector3::UnitX());
            if (!top && sprung) {
                const double stiffness = random.in(1e3, 2e4);
                made.spring(chassis, at(0, high, gap), own, at(0, y, gap + 0.8 * reach),
                            {.stiffness = stiffness, .damping = 0.03 * stiffness});
            }
        }
        if (steered) made.rod(chassis, at(0.4 * wide, 0, gap), upright, at(0.4 * wide, 0, gap + arm));
    }
    return made.scene;
}

engine::Motor any_motor(const SceneDescription& scene, Random& random) {
    const double weight = 9.81 * mass_of(scene) * reach_of(scene), speed = random.in(1.0, 8.0);
    return {.speed = chance(random, 0.5) ? speed : -speed, .max_torque = weight * random.in(0.1, 2.0)};
}

// Where circles about two points of the plane meet, left of the way from a to b.
std::optional<Vector3> meeting(const Vector3& a, double radius_a, const Vector3& b, double radius_b) {
    const Vector3 way = b - a;
    const double distance = way.norm();
    const double along = 0.5 * (distance + (radius_a * radius_a - radius_b * radius_b) / distance);
    const double squared = radius_a * radius_a - along * along;
    if (!(squared > 1e-3)) return std::nullopt;
    return a + along / distance * way + std::sqrt(squared) / distance * Vector3(-way.y(), way.x(), 0);
}

// Four bars, the first of them the world (if anchored) or a bar of its own; the motor turns the second. That goes
// all around if the shortest and the longest bar are not longer than the others.
Builder four_bars(const char* name, Random& random, bool anchored, bool around) {
    const double base = random.in(0.8, 1.2);
    const Vector3 a(-0.5 * base, 0, 0), d(0.5 * base, 0, 0);
    for (;;) {
        const double crank = around ? random.in(0.2, 0.4) : random.in(0.7, 1.1), coupler = random.in(0.6, 1.3);
        const double rocker = random.in(0.6, 1.3), angle = random.in(-pi, pi);
        std::array<double, 4> sorted{base, crank, coupler, rocker};
        std::ranges::sort(sorted);
        const double spare = sorted[1] + sorted[2] - sorted[0] - sorted[3];
        if (around ? spare < 0.05 || sorted[0] != crank : spare > -0.05) continue;
        const Vector3 b = a + crank * Vector3(std::cos(angle), std::sin(angle), 0);
        const auto c = meeting(b, coupler, d, rocker);
        if (!c) continue;
        Builder made(name, random);
        const double thickness = random.in(0.03, 0.06);
        const int frame = anchored ? -1 : made.bar(a, d, thickness);
        const int first = made.bar(a, b, thickness), second = made.bar(b, *c, thickness);
        const int third = made.bar(*c, d, thickness);
        made.join(frame, first, a);
        made.join(first, second, b);
        made.join(second, third, *c);
        made.join(third, frame, d);
        made.scene.joints.front().hinge->motor = any_motor(made.scene, random);
        made.as_group();
        return made;
    }
}

SceneDescription crank(Random& random) {
    return four_bars("crank", random, true, true).scene;
}

// The motor cannot turn it all around: the bars lock.
SceneDescription locking_crank(Random& random) {
    return four_bars("locking crank", random, true, false).scene;
}

SceneDescription limited_crank(Random& random) {
    SceneDescription scene = four_bars("limited crank", random, true, true).scene;
    scene.joints.front().hinge->limits = engine::AngleLimits{-random.in(0.2, 2.0), random.in(0.2, 2.0)};
    return scene;
}

SceneDescription dropped_crank(Random& random) {
    const bool around = chance(random, 0.5);
    return four_bars("dropped crank", random, false, around).scene;
}

SceneDescription driven_ring(Random& random) {
    SceneDescription scene = ring_of("driven ring", random, 0.0, hinged, along_z).scene;
    scene.joints.front().hinge->motor = any_motor(scene, random);
    return scene;
}

SceneDescription driven_scissors(Random& random) {
    SceneDescription scene = scissors_of("driven scissors", random).scene;
    scene.joints.front().hinge->motor = any_motor(scene, random);
    if (chance(random, 0.5)) scene.joints.front().hinge->limits = engine::AngleLimits{-0.3, 0.3};
    return scene;
}

constexpr std::array table{LoopFamily{"hinged ring", false, false, hinged_ring},
                           LoopFamily{"welded ring", false, false, welded_ring},
                           LoopFamily{"mixed ring", false, false, mixed_ring},
                           LoopFamily{"spatial ring", false, false, spatial_ring},
                           LoopFamily{"scissors", false, false, scissors},
                           LoopFamily{"ladder", false, false, ladder},
                           LoopFamily{"welded block", false, false, welded_block},
                           LoopFamily{"truss", false, false, truss},
                           LoopFamily{"wishbones", false, false, wishbones},
                           LoopFamily{"crank", true, true, crank},
                           LoopFamily{"locking crank", true, true, locking_crank},
                           LoopFamily{"limited crank", true, true, limited_crank},
                           LoopFamily{"dropped crank", true, false, dropped_crank},
                           LoopFamily{"driven ring", true, false, driven_ring},
                           LoopFamily{"driven scissors", true, false, driven_scissors}};

// Turns everything about the origin, also what is of the world.
void turn_all(SceneDescription& scene, const Quaternion& turn) {
    for (BodyDescription& body : scene.bodies) {
        body.position = turn * body.position;
        body.orientation = turn * body.orientation;
    }
    const auto turn_end = [&](DistanceDescription::End& end) {
        if (end.body == "world") end.point = turn * end.point;
    };
    for (JointDescription& joint : scene.joints) {
        if (joint.a.body == "world" && joint.hinge) joint.hinge->axis = turn * joint.hinge->axis;
        turn_end(joint.a);
        turn_end(joint.b);
    }
}

// As one piece, about the centre of mass.
void spin_all(SceneDescription& scene, const Vector3& spin) {
    Vector3 centre = Vector3::Zero();
    for (const BodyDescription& body : scene.bodies) centre += *body.mass * body.position;
    centre /= mass_of(scene);
    for (BodyDescription& body : scene.bodies) {
        body.velocity = spin.cross(body.position - centre);
        body.angular_velocity = spin;
    }
}

}  // namespace

std::span<const LoopFamily> loop_families() {
    return table;
}

void drop(SceneDescription& scene, Random& random) {
    turn_all(scene, random.rotation());
    spin_all(scene, random.in(0.0, 5.0) * (random.rotation() * Vector3::UnitX()));
    const Vector3 up(0, reach_of(scene) + random.in(0.1, 3.0), 0);
    for (BodyDescription& body : scene.bodies) body.position += up;
    scene.gravity = {0, -9.81, 0};
    scene.bodies.push_back({.name = "ground", .shape = PlaneShape{}, .friction = 0.5});
}

void set_free(SceneDescription& scene, Random& random) {
    turn_all(scene, random.rotation());
    spin_all(scene, random.in(1.0, 5.0) * (random.rotation() * Vector3::UnitX()));
    scene.contacts = false;
    std::erase_if(scene.distances, [](const DistanceDescription& own) { return own.spring.has_value(); });
}

void hang(SceneDescription& scene, Random& random) {
    turn_all(scene, random.rotation());
    scene.gravity = {0, -9.81, 0};
    scene.contacts = false;
}

double mass_of(const SceneDescription& scene) {
    double mass = 0.0;
    for (const BodyDescription& body : scene.bodies) mass += body.mass.value_or(0.0);
    return mass;
}

double reach_of(const SceneDescription& scene) {
    double reach = 0.0;
    for (const BodyDescription& body : scene.bodies) {
        reach = std::max(reach, body.position.norm() + bounding_radius(body));
    }
    return reach;
}

}  // namespace pushfactor::tests
