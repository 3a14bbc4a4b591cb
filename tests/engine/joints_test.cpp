// Hinges, their motors and limits, and ball joints against closed forms.
#include "engine/bodies/diagnostics.h"
#include "engine/constraints/joint_constraints.h"
#include "engine/energy_account.h"
#include "engine/forces/gravity.h"
#include "engine/world.h"
#include "tests/catch.h"
#include "tests/engine/rows.h"
#include "tests/random.h"

#include <cmath>
#include <numbers>

using namespace pushfactor::engine;
using Catch::Matchers::WithinAbs;
using pushfactor::tests::Random;

namespace {

constexpr double pi = std::numbers::pi;
const Vector3 gravity(0, -10, 0);
constexpr Correction whole{PushKind::persistent, 1.0};

Quaternion about_z(double angle) {
    return Quaternion(Eigen::AngleAxisd(angle, Vector3::UnitZ()));
}

// Bodies on joints; body 0 is the world.
struct Linkage {
    World world;
    std::vector<Joint> joints;
    const JointConstraints* source = nullptr;
    EnergyAccount account{gravity};

    Linkage() { world.bodies.push_back(static_body(Vector3::Zero())); }

    int add(const Body& body) {
        world.bodies.push_back(body);
        return static_cast<int>(world.bodies.size()) - 1;
    }

    // Joins a and b at a point of the world, as they are now; the axis is z.
    Joint& join(int a, int b, const Vector3& at, bool hinge = true) {
        const auto in = [&](int body) -> Vector3 {
            const Body& own = world.bodies[static_cast<std::size_t>(body)];
            return own.orientation.conjugate() * (at - own.position);
        };
        Joint& joint = joints.emplace_back();
        joint = {.body_a = a, .body_b = b, .point_a = in(a), .point_b = in(b)};
        if (!hinge) return joint;
        const Quaternion& q_a = world.bodies[static_cast<std::size_t>(a)].orientation;
        joint.hinge = Hinge{.axis = q_a.conjugate() * Vector3::UnitZ(),
                            .zero = q_a.conjugate() * world.bodies[static_cast<std::size_t>(b)].orientation};
        return joint;
    }

    void build(const Correction& correction = whole, bool heavy = true, const char* solver = "direct") {
        auto made = std::make_unique<JointConstraints>(joints, correction, true);
        source = made.get();
        world.constraints.push_back(std::move(made));
        if (heavy) world.forces.push_back(std::make_unique<Gravity>(gravity));
        if (!heavy) account = EnergyAccount(Vector3::Zero());
        world.solver = solvers::make_solver(solver);
        world.termination = {.iterations = 1000, .tolerance_high = 1e-12, .tolerance_low = 1e-12};
    }

    StepCount step(double dt) {
        account.begin(world.bodies);
        const StepCount count = world.step(dt);
        account.end(world, dt);
        return count;
    }

    double angle(std::size_t joint = 0) const { return angle_of(source->joints()[joint], world.bodies); }
    double speed(std::size_t body) const { return angular_velocity(world.bodies[body]).z(); }
    double energy() const { return kinetic_energy(world.bodies) + potential_energy(world.bodies, gravity); }

    // How far the points of the joints are apart [m], and by how much their axes differ [rad].
    double opened() const {
        double largest = 0.0;
        for (const Joint& joint : source->joints()) {
            const auto [from, to] = span_of(joint, world.bodies);
            largest = std::max(largest, (to - from).norm());
        }
        return largest;
    }
    double tilted() const {
        double largest = 0.0;
        for (const Joint& joint : source->joints()) {
            const Body& a = world.bodies[static_cast<std::size_t>(joint.body_a)];
            const Body& b = world.bodies[static_cast<std::size_t>(joint.body_b)];
            const Vector3 axis = joint.hinge->axis;
            const Vector3 of_b = b.orientation * (joint.hinge->zero.conjugate() * axis);
            largest = std::max(largest, (a.orientation * axis).cross(of_b).norm());
        }
        return largest;
    }
};

// A bar of 1 m, 0.2 m, 0.1 m and 1 kg that hangs by its end at the origin, at `angle` from straight down.
constexpr double bar_mass = 1.0, arm = 0.5;
const Vector3 bar_size(0.2, 1.0, 0.1);

Body bar_at(double angle) {
    return box_body(bar_mass, bar_size, about_z(angle) * Vector3(0, -arm, 0), about_z(angle));
}

// About the hinge, kg m^2.
const double bar_moment = bar_mass * ((0.04 + 1.0) / 12.0 + arm * arm);

Linkage pendulum(double angle) {
    Linkage linkage;
    linkage.add(bar_at(0.0));
    linkage.join(0, 1, Vector3::Zero());
    linkage.world.bodies[1] = bar_at(angle);
    return linkage;
}

// s, of a swing that begins at rest at this angle.
double period_of(double angle, int steps_a_second) {
    Linkage linkage = pendulum(angle);
    linkage.build();
    const double dt = 1.0 / steps_a_second;
    linkage.world.kick_back_half(dt);
    // From the second crossing of the lowest point to the fourth.
    std::vector<double> crossings;
    double before = angle;
    for (int i = 1; crossings.size() < 4; ++i) {
        linkage.step(dt);
        const double now = linkage.angle();
        if ((before < 0.0) != (now < 0.0)) crossings.push_back((i - now / (now - before)) * dt);
        before = now;
    }
    return crossings[3] - crossings[1];
}

}  // namespace

TEST_CASE("a physical pendulum on a hinge has the period of the elliptic integral, to second order in the step") {
    for (const double angle : {0.1, 1.0, 2.0, 3.0}) {
        const double exact =
            4.0 * std::sqrt(bar_moment / (bar_mass * 10.0 * arm)) * std::comp_ellint_1(std::sin(0.5 * angle));
        const double coarse = std::abs(period_of(angle, 120) / exact - 1.0);
        const double fine = std::abs(period_of(angle, 480) / exact - 1.0);
        INFO(angle << " rad: " << coarse << ", " << fine);
        CHECK(fine < 1e-4);
        CHECK(fine < coarse / 10.0);
    }
}

TEST_CASE("a motor that is too weak to lift its bar stalls where gravity's torque is its own") {
    const double torque = 3.0, stall = std::asin(torque / (bar_mass * 10.0 * arm));
    Linkage linkage = pendulum(0.0);
    linkage.joints[0].hinge->motor = Motor{.speed = 0.02, .max_torque = torque};
    linkage.build();
    const double swing = 0.02 / std::sqrt(bar_mass * 10.0 * arm * std::cos(stall) / bar_moment);
    for (int i = 1; i <= 60 * 60; ++i) {
        linkage.step(1.0 / 60.0);
        // On its way it has its speed.
        if (i > 60 && i < 60 * 25) REQUIRE_THAT(linkage.speed(1), WithinAbs(0.02, 1e-9));
        if (i > 60 * 40) REQUIRE(std::abs(linkage.angle() - stall) < 1.5 * swing);
    }
    CHECK(linkage.angle() > stall - 1.5 * swing);
}

TEST_CASE("a motor that is strong enough keeps its speed over the top, and its work is the height") {
    Linkage linkage = pendulum(0.0);
    linkage.joints[0].hinge->motor = Motor{.speed = 0.5, .max_torque = 6.0};
    linkage.build();
    const double dt = 1.0 / 240.0;
    linkage.account.open(linkage.world.bodies, dt);
    double seconds = 0.0;
    for (int i = 0; linkage.angle() >= 0.0; ++i) {
        linkage.step(dt);
        seconds += dt;
        if (i >= 10) REQUIRE_THAT(linkage.speed(1), WithinAbs(0.5, 1e-9));  // it starts up in 0.03 s
    }
    CHECK_THAT(seconds, WithinAbs(2.0 * pi, 0.03));  // half a turn
    const double motion = 0.5 * bar_moment * 0.25;
    CHECK_THAT(linkage.account.external_work(), WithinAbs(10.0 + motion, 0.01));
    CHECK_THAT(linkage.account.gain(), WithinAbs(0.0, 0.01));
}

TEST_CASE("a flywheel starts up in moment x speed / torque, and runs on at its speed") {
    const double torque = 2.0, speed = 30.0;
    Linkage linkage;
    const int wheel = linkage.add(ball_body(5.0, 0.4, {0, 0, 0}));
    linkage.join(0, wheel, Vector3::Zero()).hinge->motor = Motor{.speed = speed, .max_torque = torque};
    linkage.build(whole, false);
    const double moment = 0.4 * 5.0 * 0.16, exact = moment * speed / torque, dt = exact / 2000.5;
    linkage.account.open(linkage.world.bodies, dt);
    int steps = 0;
    for (; linkage.speed(1) < speed * (1.0 - 1e-9); ++steps) linkage.step(dt);
    CHECK(std::abs(steps * dt / exact - 1.0) < 1e-3);
    for (int i = 0; i < 100; ++i) linkage.step(dt);
    CHECK_THAT(linkage.speed(1), WithinAbs(speed, 1e-9));
    CHECK_THAT(linkage.account.external_work(), WithinAbs(0.5 * moment * speed * speed, 1e-6));
    CHECK_THAT(linkage.account.gain(), WithinAbs(0.0, 1e-6));
}

TEST_CASE("a brake, a motor of speed zero, stops what its torque can stop, and is no work from outside") {
    Linkage linkage;
    const int wheel = linkage.add(ball_body(5.0, 0.4, {0, 0, 0}));
    linkage.join(0, wheel, Vector3::Zero()).hinge->motor = Motor{.speed = 0.0, .max_torque = 1.0};
    const double moment = 0.4 * 5.0 * 0.16;
    linkage.world.bodies[1].angular_momentum = {0, 0, 2.0};
    linkage.build(whole, false);
    linkage.account.open(linkage.world.bodies, 0.01);
    for (int i = 0; i < 199; ++i) linkage.step(0.01);
    CHECK_THAT(linkage.speed(1), WithinAbs(0.01 / moment, 1e-9));
    for (int i = 0; i < 10; ++i) linkage.step(0.01);
    CHECK_THAT(linkage.speed(1), WithinAbs(0.0, 1e-9));
    CHECK(linkage.account.external_work() == 0.0);
    CHECK(linkage.account.gain() < 0.0);
}

TEST_CASE("a motor between two free bodies turns them against each other and gives them no momentum") {
    Linkage linkage;
    const int a = linkage.add(box_body(1.0, {1, 0.4, 0.3}, {-0.5, 0, 0}));
    const int b = linkage.add(box_body(3.0, {1, 0.8, 0.3}, {0.5, 0, 0}));
    linkage.join(a, b, Vector3::Zero()).hinge->motor = Motor{.speed = 2.0, .max_torque = 4.0};
    linkage.build(whole, false);
    linkage.account.open(linkage.world.bodies, 1e-3);
    for (int i = 0; i < 2000; ++i) linkage.step(1e-3);
    CHECK_THAT(linkage.speed(2) - linkage.speed(1), WithinAbs(2.0, 1e-9));
    CHECK(linear_momentum(linkage.world.bodies).norm() < 1e-12);
    CHECK(angular_momentum(linkage.world.bodies).norm() < 1e-12);
    CHECK(std::abs(linkage.account.gain()) < 0.01 * linkage.account.external_work());
}

TEST_CASE("a hinge keeps its axis and its point under loads across them") {
    // A plate on a level axle, pushed out of its plane by gravity on its edge and by its own products of inertia.
    for (const Correction& correction : {whole, Correction{PushKind::single_frame, 0.2}}) {
        Linkage linkage;
        Body plate =
            box_body(2.0, {1.0, 0.2, 0.6}, {0.3, 0, 0.5}, Quaternion(Eigen::AngleAxisd(0.4, Vector3::UnitY())));
        const int body = linkage.add(plate);
        linkage.join(0, body, Vector3(0, 0, 0));
        linkage.build(correction);
        double opened = 0.0, tilted = 0.0;
        for (int i = 0; i < 240 * 20; ++i) {
            linkage.step(1.0 / 240.0);
            opened = std::max(opened, linkage.opened());
            tilted = std::max(tilted, linkage.tilted());
        }
        INFO("beta " << correction.beta << ": " << opened << " m, " << tilted << " rad");
        CHECK(std::abs(linkage.angle()) < pi);
        CHECK(opened < 2e-3);
        CHECK(tilted < 2e-3);
    }
}

TEST_CASE("a hinge whose axes are wrong at the start is put right, whole or by beta a step") {
    Random random(7);
    for (int i = 0; i < 20; ++i) {
        for (const double beta : {1.0, 0.2}) {
            Linkage linkage;
            linkage.add(box_body(1.0, {0.5, 1, 0.7}, {0, 0, 0}));
            linkage.join(0, 1, Vector3(0, 0.5, 0));
            linkage.world.bodies[1].orientation = random.rotation();
            linkage.build({PushKind::single_frame, beta}, false);
            const int steps = beta == 1.0 ? 60 : 240;
            for (int k = 0; k < steps; ++k) linkage.step(1.0 / 60.0);
            CHECK(linkage.tilted() < 1e-6);
            CHECK(linkage.opened() < 1e-6);
            CHECK(kinetic_energy(linkage.world.bodies) < 1e-12);
        }
    }
}

TEST_CASE("limits stop a hinge where they are, on either side, and give it no energy") {
    for (const Correction& correction : {whole, Correction{PushKind::single_frame, 0.2}}) {
        for (const double side : {1.0, -1.0}) {
            Linkage linkage = pendulum(side * 1.4);
            linkage.joints[0].hinge->limits = side > 0.0 ? AngleLimits{0.5, 2.0} : AngleLimits{-2.0, -0.5};
            linkage.build(correction);
            linkage.account.open(linkage.world.bodies, 1.0 / 60.0);
            double last = linkage.energy();
            for (int i = 0; i < 240; ++i) {
                linkage.step(1.0 / 60.0);
                REQUIRE(side * linkage.angle() > 0.5 - 1e-4);
                REQUIRE(linkage.account.gain() < 0.05);
            }
            CHECK_THAT(side * linkage.angle(), WithinAbs(0.5, 1e-5));
            CHECK(std::abs(linkage.speed(1)) < 1e-5);
            CHECK(linkage.energy() < last);
        }
    }
}

TEST_CASE("a hinge outside its limits is pushed back, with no speed left by the single-frame push") {
    Linkage linkage = pendulum(1.0);
    linkage.joints[0].hinge->limits = AngleLimits{-0.5, 0.5};
    linkage.build({PushKind::single_frame, 0.2}, false);
    double last = 1.0;
    for (int i = 0; i < 100; ++i) {
        linkage.step(1.0 / 60.0);
        CHECK(linkage.angle() <= last + 1e-12);
        last = linkage.angle();
    }
    CHECK_THAT(linkage.angle(), WithinAbs(0.5, 1e-6));
    CHECK(std::abs(linkage.speed(1)) < 1e-9);
}

TEST_CASE("equal limits weld: two bodies fly and turn as one") {
    Linkage linkage;
    const int a = linkage.add(box_body(1.0, {1, 0.4, 0.3}, {-0.5, 0, 0}));
    const int b = linkage.add(box_body(3.0, {1, 0.8, 0.3}, {0.5, 0, 0}));
    linkage.join(a, b, Vector3::Zero()).hinge->limits = AngleLimits{0.0, 0.0};
    linkage.world.bodies[1].angular_momentum = {0.3, 0.2, 0.5};
    linkage.build(whole, false);
    for (int i = 0; i < 600; ++i) REQUIRE(linkage.step(1.0 / 240.0).rows(RowKind::limit) == 1);
    CHECK(linkage.world.bodies[1].orientation.angularDistance(linkage.world.bodies[2].orientation) < 1e-4);
    CHECK((angular_velocity(linkage.world.bodies[1]) - angular_velocity(linkage.world.bodies[2])).norm() < 1e-3);
    CHECK(angular_velocity(linkage.world.bodies[1]).norm() > 0.1);
}

TEST_CASE("a motor stops at a limit and holds there") {
    Linkage linkage = pendulum(0.0);
    linkage.joints[0].hinge->motor = Motor{.speed = 1.0, .max_torque = 20.0};
    linkage.joints[0].hinge->limits = AngleLimits{-1.0, 1.2};
    linkage.build();
    for (int i = 0; i < 300; ++i) linkage.step(1.0 / 60.0);
    CHECK_THAT(linkage.angle(), WithinAbs(1.2, 1e-6));
    CHECK(std::abs(linkage.speed(1)) < 1e-9);
}

TEST_CASE("a four-bar linkage, whose rows are redundant, swings without gaining energy or coming apart") {
    // A parallelogram of three bars of 1 m between hinges on the world 1.4 m apart.
    for (const char* const solver : {"direct", "auto"}) {
        Linkage linkage;
        const auto bar = [&](const Vector3& from, const Vector3& to) {
            const Vector3 along = to - from;
            return linkage.add(box_body(1.0, {along.norm(), 0.1, 0.1}, 0.5 * (from + to),
                                        about_z(std::atan2(along.y(), along.x()))));
        };
        const Vector3 left(0, 0, 0), right(1.4, 0, 0), low(0.8, -0.6, 0), high(2.0, -0.2, 0);
        const int first = bar(left, low), middle = bar(low, high), last = bar(right, high);
        linkage.join(0, first, left);
        linkage.join(first, middle, low);
        linkage.join(middle, last, high);
        linkage.join(last, 0, right);
        linkage.build(whole, true, solver);
        const double dt = 1.0 / 240.0;
        linkage.world.kick_back_half(dt);
        linkage.account.open(linkage.world.bodies, dt);
        double moving = 0.0, gain = 0.0, opened = 0.0, tilted = 0.0;
        for (int i = 0; i < 240 * 10; ++i) {
            const StepCount count = linkage.step(dt);
            REQUIRE(count.islands_contradicting == 0);
            moving = std::max(moving, kinetic_energy(linkage.world.bodies));
            gain = std::max(gain, linkage.account.gain());
            opened = std::max(opened, linkage.opened());
            tilted = std::max(tilted, linkage.tilted());
        }
        INFO(solver << ": gain " << gain << " of " << moving << " J, " << opened << " m, " << tilted << " rad");
        CHECK(moving > 1.0);
        CHECK(gain < 0.01 * moving);
        CHECK(opened < 1e-3);
        CHECK(tilted < 1e-6);
    }
}

TEST_CASE("a chain of hinges swings without gaining energy") {
    Linkage linkage;
    for (int i = 0; i < 8; ++i) {
        linkage.add(box_body(1.0, {0.5, 0.1, 0.1}, {0.25 + 0.5 * i, 0, 0}));
        linkage.join(i, i + 1, {0.5 * i, 0, 0});
    }
    linkage.build();
    const double dt = 1.0 / 960.0;
    linkage.world.kick_back_half(dt);
    linkage.account.open(linkage.world.bodies, dt);
    double moving = 0.0, gain = 0.0;
    for (int i = 0; i < 960 * 4; ++i) {
        linkage.step(dt);
        moving = std::max(moving, kinetic_energy(linkage.world.bodies));
        gain = std::max(gain, linkage.account.gain());
    }
    INFO("gain " << gain << " of " << moving << " J");
    CHECK(moving > 20.0);
    CHECK(gain < 0.01 * moving);
    CHECK(linkage.opened() < 5e-3);
}

TEST_CASE("a ball joint moves bodies as a distance of length zero does, bit for bit") {
    const auto run = [](std::unique_ptr<ConstraintSource> source) {
        Linkage linkage;
        linkage.add(box_body(1.0, {1, 0.1, 0.2}, {0.5, 0, 0}));
        linkage.add(box_body(2.0, {1, 0.3, 0.1}, {1.5, 0.1, 0}));
        linkage.build();
        linkage.world.constraints[0] = std::move(source);
        for (int i = 0; i < 200; ++i) linkage.world.step(1.0 / 240.0);
        return state_hash(linkage.world.bodies);
    };
    const auto held = [](int a, int b, const Vector3& on_a, auto made) {
        made.body_a = a;
        made.body_b = b;
        made.point_a = on_a;
        made.point_b = {-0.5, 0, 0};
        return made;
    };
    const std::vector<Joint> joints{held(0, 1, {0, 0, 0}, Joint{}), held(1, 2, {0.5, 0.1, 0}, Joint{})};
    Distance zero;
    zero.length = 0.0;
    const std::vector<Distance> distances{held(0, 1, {0, 0, 0}, zero), held(1, 2, {0.5, 0.1, 0}, zero)};
    CHECK(run(std::make_unique<JointConstraints>(joints, whole, true)) ==
          run(std::make_unique<DistanceConstraints>(distances, whole, true)));
}

TEST_CASE("the rows of hinges are derivatives of what they hold, and turn with the scene") {
    // c of the axis rows and of the limits, by finite differences of the orientations, where the axes agree.
    Random random(3);
    for (int i = 0; i < 50; ++i) {
        std::vector<Body> bodies{box_body(1.0, {1, 2, 3}, random.vector(-1, 1), random.rotation()),
                                 box_body(2.0, {2, 1, 1}, random.vector(-1, 1), random.rotation())};
        if (i % 5 == 0) bodies[0].inverse_mass = 0.0, bodies[0].inverse_inertia.setZero();
        Joint joint{.body_a = 0, .body_b = 1, .point_a = random.vector(-1, 1), .point_b = random.vector(-1, 1)};
        const Vector3 axis = random.vector(-1, 1).normalized();
        const double angle = random.in(-3, 3);
        joint.hinge = Hinge{.axis = axis};
        joint.hinge->zero = Quaternion(Eigen::AngleAxisd(-angle, axis)) *
                            (bodies[0].orientation.conjugate() * bodies[1].orientation);
        joint.hinge->motor = Motor{.speed = 1.5, .max_torque = 4.0};
        joint.hinge->limits = AngleLimits{-3.1, 3.1};
        REQUIRE_THAT(angle_of(joint, bodies), WithinAbs(angle, 1e-12));
        const auto rows_at = [&](std::span<const Body> at) {
            return pushfactor::tests::rows_of(JointConstraints({joint}, whole, false), {at, 0.01});
        };
        const auto rows = rows_at(bodies);
        REQUIRE(rows.size() == row_count(joint));
        constexpr double small = 1e-6;
        for (int body = bodies[0].is_static() ? 1 : 0; body < 2; ++body) {
            for (int k = 0; k < 3; ++k) {
                std::vector<Body> turned = bodies;
                Quaternion& q = turned[static_cast<std::size_t>(body)].orientation;
                q = Quaternion(Eigen::AngleAxisd(small, Vector3::Unit(k))) * q;
                const auto moved = rows_at(turned);
                for (const std::size_t row : {3u, 4u, 6u, 7u}) {
                    const Jacobian& j = rows[row].jacobian;
                    const double expected = body == 0 ? j.a[3 + k] : j.b[3 + k];
                    const double found = (moved[row].error - rows[row].error) / small;
                    REQUIRE_THAT(found, WithinAbs(expected, 1e-5));
                }
            }
        }
        // The motor row is the same axis as the lower limit, its bounds are the torque.
        CHECK((rows[5].jacobian.b - rows[6].jacobian.b).norm() == 0.0);
        const double lever = rows[5].jacobian.b.tail<3>().norm();
        CHECK_THAT(rows[5].push.lasting, WithinAbs(1.5 * lever, 1e-12));
        CHECK_THAT(rows[5].bounds.c_max * lever, WithinAbs(4.0, 1e-12));
        CHECK(rows[5].bounds.c_min == -rows[5].bounds.c_max);
    }
}
