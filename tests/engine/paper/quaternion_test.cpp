// Paper sections 12.4 and 12.5: the quaternion of a rotation, its derivative, and where the engine uses them.
// 12.4.1 is the number of the formula in 12.4; the derivative and the proof by a limit are section 12.5.
//
// Symbols: q orientation; a angle [rad] about the unit vector b; w angular velocity [rad/s, world frame]; h a short
// time [s].
#include "engine/bodies/integrator.h"
#include "tests/catch.h"
#include "tests/random.h"

#include <cmath>
#include <numbers>

using namespace pushfactor::engine;
using pushfactor::tests::Random;

namespace {

// 12.4.1 as printed, in the order [w, x, y, z] of the text.
Quaternion axis_angle(double a, const Vector3& b) {
    const Vector3 vector = std::sin(0.5 * a) * b;
    return {std::cos(0.5 * a), vector.x(), vector.y(), vector.z()};
}

// q(t0 + h) of 12.5.
Quaternion turned(const Quaternion& q, const Vector3& w, double h) {
    return axis_angle(w.norm() * h, w.normalized()) * q;
}

// 12.5.1: [0, w/2] q.
Eigen::Vector4d derivative(const Quaternion& q, const Vector3& w) {
    return (Quaternion(0.0, 0.5 * w.x(), 0.5 * w.y(), 0.5 * w.z()) * q).coeffs();
}

Eigen::Vector4d forward_quotient(const Quaternion& q, const Vector3& w, double h) {
    return (turned(q, w, h).coeffs() - q.coeffs()) / h;
}

Eigen::Vector4d central_quotient(const Quaternion& q, const Vector3& w, double h) {
    return (turned(q, w, h).coeffs() - turned(q, w, -h).coeffs()) / (2.0 * h);
}

// A cube has I^-1 l = w l in every orientation.
Body cube_at(const Quaternion& q) {
    return box_body(6.0, Vector3::Ones(), Vector3::Zero(), q);  // 1 kg m^2
}

}  // namespace

TEST_CASE("12.4: [cos a/2, sin a/2 b] turns by a about b") {
    Random random(124);
    for (int i = 0; i < 100; ++i) {
        const double a = random.in(-3, 3);
        const Vector3 b = random.rotation() * Vector3::UnitX(), x = random.vector(-2, 2);
        const Quaternion q = axis_angle(a, b);
        REQUIRE(q.norm() == Approx(1.0).epsilon(1e-14));
        // Rodrigues' formula
        const Vector3 expected = x * std::cos(a) + b.cross(x) * std::sin(a) + b * (b.dot(x) * (1.0 - std::cos(a)));
        REQUIRE((q * x - expected).norm() < 1e-14);
        // 12.5 multiplies b by the time step as well: that is no unit vector, and no rotation.
        REQUIRE(std::abs(axis_angle(a, b / 60.0).norm() - 1.0) > std::min(0.1, 0.1 * a * a));
    }
}

TEST_CASE("12.4.1: the quaternion's derivative and its limit") {
    Random random(125);
    for (int i = 0; i < 100; ++i) {
        const Quaternion q = random.rotation();
        const Vector3 w = random.vector(-5, 5);
        const double rate = w.norm();
        const Eigen::Vector4d exact = derivative(q, w);

        // 12.5.1 by its definition: the second difference of q is (rate/2)^2, the third (rate/2)^3.
        const double h = 1e-3;
        REQUIRE((central_quotient(q, w, h) - exact).norm() < 1.01 * h * h * std::pow(0.5 * rate, 3) / 6.0 + 1e-12);
        // The limit: half the step, half the error.
        const double error = (forward_quotient(q, w, h) - exact).norm();
        REQUIRE(error == Approx(0.5 * h * 0.25 * rate * rate).epsilon(0.01));
        REQUIRE((forward_quotient(q, w, 0.5 * h) - exact).norm() == Approx(0.5 * error).epsilon(0.01));

        // Row by row as at the end of the limit. [-z, w, x] is missing from the list before it, where [y, -x, w]
        // appears twice.
        const double s = q.w(), x = q.x(), y = q.y(), z = q.z();
        REQUIRE(exact.w() == Approx(-0.5 * w.dot(Vector3(x, y, z))).margin(1e-14));
        REQUIRE(exact.x() == Approx(0.5 * w.dot(Vector3(s, z, -y))).margin(1e-14));
        REQUIRE(exact.y() == Approx(0.5 * w.dot(Vector3(-z, s, x))).margin(1e-14));
        REQUIRE(exact.z() == Approx(0.5 * w.dot(Vector3(y, -x, s))).margin(1e-14));
        REQUIRE(exact.dot(q.coeffs()) == Approx(0.0).margin(1e-14));  // q keeps its length

        // From the left, w is in world axes: a point r of the body moves with w x r. From the right it is in body
        // axes.
        const Vector3 r = random.vector(-1, 1);
        const Vector3 moved = (turned(q, w, h) * r - turned(q, w, -h) * r) / (2.0 * h);
        REQUIRE((moved - w.cross(q * r)).norm() < 1e-3);
        const Quaternion right = q * axis_angle(rate * h, w / rate);
        REQUIRE((right.coeffs() - turned(q, q * w, h).coeffs()).norm() < 1e-15);
    }
}

TEST_CASE("12.5.1 is the rate at t0 alone: at another time it is that of q then") {
    // The text has the bracket of 12.4.1, undifferentiated, as the middle term; it is a rotation and no rate.
    const Quaternion q = Quaternion(0.5, 0.1, -0.7, 0.5).normalized();
    const Vector3 w(3, -1, 2);
    const Quaternion later = turned(q, w, 0.4);
    const double h = 1e-4;
    const Eigen::Vector4d rate = (turned(q, w, 0.4 + h).coeffs() - turned(q, w, 0.4 - h).coeffs()) / (2.0 * h);
    CHECK((rate - derivative(later, w)).norm() < 1e-7);
    CHECK((rate - derivative(q, w)).norm() > 1.0);
    CHECK((turned(q, w, 0.0).coeffs() - q.coeffs()).norm() < 1e-15);
}

TEST_CASE("3.2.4 and 12.4.1 in the engine are the formulas of the appendix, and one in the limit") {
    Random random(126);
    for (int i = 0; i < 100; ++i) {
        const Quaternion q = random.rotation();
        const Vector3 direction = random.rotation() * Vector3::UnitX();
        const Body cube = cube_at(q);
        for (const double angle : {1e-1, 1e-2, 1e-3}) {
            const double dt = 1.0 / 60.0;
            const Vector3 w = direction * (angle / dt);
            const Quaternion exact = turned(q, w, dt);
            REQUIRE((rotate_exponential(cube, w, dt).coeffs() - exact.coeffs()).norm() < 1e-15);
            // 3.2.4 is the tangent of 12.5.1, brought back to length one.
            Quaternion euler;
            euler.coeffs() = q.coeffs() + dt * derivative(q, w);
            REQUIRE((rotate_euler(cube, w, dt).coeffs() - euler.normalized().coeffs()).norm() < 1e-15);
            // It turns by 2 atan(a/2) about the right axis, a^3/12 too little.
            const Quaternion short_of = axis_angle(2.0 * std::atan(0.5 * angle), direction) * q;
            REQUIRE((rotate_euler(cube, w, dt).coeffs() - short_of.coeffs()).norm() < 1e-15);
            const double missing = (rotate_euler(cube, w, dt).coeffs() - exact.coeffs()).norm();
            REQUIRE(missing == Approx(std::pow(angle, 3) / 24.0).epsilon(0.01).margin(1e-15));
        }
    }
}

TEST_CASE("12.4.1 in the engine has the limit of no rotation, where the formula divides zero by zero") {
    const Quaternion q = Quaternion(0.5, 0.1, -0.7, 0.5).normalized();
    const Body cube = cube_at(q);
    CHECK(rotate_exponential(cube, Vector3::Zero(), 1.0).coeffs() == q.normalized().coeffs());
    // On both sides of 1e-6 rad, where the engine changes from the formula to its series.
    for (const double angle : {1e-12, 1e-9, 0.999e-6, 1.001e-6, 1e-5}) {
        const Vector3 w(0.6 * angle, 0.0, -0.8 * angle);
        const Eigen::Vector4d change = rotate_exponential(cube, w, 1.0).coeffs() - q.coeffs();
        CHECK((change - derivative(q, w)).norm() < 0.13 * angle * angle + 3e-16);
        CHECK(change.norm() == Approx(0.5 * angle).margin(3e-16));
    }
    // Half a turn and a whole one.
    const Vector3 axis(0.6, 0.0, -0.8);
    const double pi = std::numbers::pi;
    CHECK((rotate_exponential(cube, pi * axis, 1.0) * (q.conjugate() * axis) - axis).norm() < 1e-15);
    CHECK((rotate_exponential(cube, 2.0 * pi * axis, 1.0).coeffs() + q.coeffs()).norm() < 1e-15);
}
