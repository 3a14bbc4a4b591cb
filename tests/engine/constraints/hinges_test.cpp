// Hinges and ball joints against closed forms, and linkages of them.
#include "tests/catch.h"
#include "tests/engine/constraints/linkage.h"
#include "tests/engine/rows.h"
#include "tests/random.h"

using namespace pushfactor::engine;
using namespace pushfactor::tests;
using Catch::Matchers::WithinAbs;

namespace {

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
