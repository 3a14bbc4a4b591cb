// Errata of paper section 12 and of the table of symbols: what the text gives, and what is right.
#include "engine/integrator.h"
#include "tests/catch.h"
#include "tests/engine/paper/literal.h"
#include "tests/random.h"

#include <cmath>

using namespace pushfactor;
using namespace pushfactor::engine;
using tests::Random;
using tests::row_along;

namespace {

// 12.4.1 with angle a and axis b, whatever the length of b.
Quaternion axis_angle(double a, const Vector3& b) {
    Quaternion q;
    q.w() = std::cos(0.5 * a);
    q.vec() = std::sin(0.5 * a) * b;
    return q;
}

// q(t) of section 12.5.
Quaternion turned(const Vector3& omega, double t, const Quaternion& start) {
    return axis_angle(omega.norm() * t, omega / omega.norm()) * start;
}

}  // namespace

TEST_CASE("12.1: 2 v v' is the rate of the squared length in any dimension; that of the length is v v' / |v|") {
    Random random(121);
    for (int i = 0; i < 50; ++i) {
        const Vector3 v = random.vector(-2, 2), rate = random.vector(-1, 1);
        const double h = 1e-6;
        const auto measured = [&](auto&& of) { return (of(v + h * rate) - of(v - h * rate)) / (2 * h); };
        CHECK(measured([](const Vector3& x) { return x.squaredNorm(); }) == Approx(2.0 * v.dot(rate)).margin(1e-8));
        CHECK(measured([](const Vector3& x) { return x.norm(); }) == Approx(v.dot(rate) / v.norm()).margin(1e-8));
    }
}

TEST_CASE("12.3.2: J has no inverse: v2 is not J^-1 v, and where rows are redundant J J^-1 is not 1 either") {
    std::vector<Body> bodies{static_body(Vector3::Zero()), ball_body(2.0, 0.1, {1, 0, 0})};
    bodies[1].linear_momentum = {-6, 2, 0};
    const auto pseudo_inverse = [](const MatrixX& J) {
        return MatrixX(J.completeOrthogonalDecomposition().pseudoInverse());
    };
    const tests::Literal step = tests::step_with(bodies, std::vector{row_along(Vector3::UnitX(), 0.5)}, 0.1);
    MatrixX J(1, 6);
    J.row(0) = step.frozen.rows[0].jacobian.b.transpose();
    CHECK((J * step.after[1])[0] == Approx(0.5));                           // J v2 = v
    const VectorX printed = pseudo_inverse(J) * VectorX::Constant(1, 0.5);  // v2 = J^-1 v
    CHECK((printed - step.after[1]).norm() == Approx(1.0));                 // lacks the flight along the bar's side
    CHECK((J * pseudo_inverse(J) - MatrixX::Identity(1, 1)).norm() < 1e-15);

    MatrixX twice(2, 6);
    twice << J, J;
    CHECK((twice * pseudo_inverse(twice) - MatrixX::Identity(2, 2)).norm() == Approx(1.0));
}

TEST_CASE("12.5: the axis is w / |w|; with the stray dt the quaternion is no rotation") {
    const Vector3 omega(1, 2, -2);
    for (const double dt : {1.0 / 60.0, 0.5}) {
        const double angle = omega.norm() * dt;
        const Vector3 unit = omega / omega.norm();
        CHECK(axis_angle(angle, unit).norm() == Approx(1.0).epsilon(1e-15));
        CHECK(axis_angle(angle, unit * dt).norm() < 1.0 - 1e-4);
        const Body ball = ball_body(1.0, 1.0, Vector3::Zero());
        const Quaternion engine = rotate_exponential(ball, omega / ball.inverse_inertia.x(), dt);
        CHECK(engine.angularDistance(axis_angle(angle, unit)) < 1e-14);
    }
}

TEST_CASE("12.5.1: the product in the middle is q itself; [0, w/2] q(t0) is its derivative, at t0 and not later") {
    Random random(125);
    for (int i = 0; i < 50; ++i) {
        const Quaternion start = random.rotation();
        const Vector3 omega = random.vector(1, 3);
        const auto rate = [&](double t) {
            const double h = 1e-6;
            return Eigen::Vector4d((turned(omega, t + h, start).coeffs() - turned(omega, t - h, start).coeffs()) /
                                   (2 * h));
        };
        const Quaternion half(0.0, 0.5 * omega.x(), 0.5 * omega.y(), 0.5 * omega.z());
        const Eigen::Vector4d right = (half * start).coeffs();
        CHECK((rate(0.0) - right).norm() < 1e-8);
        CHECK((turned(omega, 0.0, start).coeffs() - start.coeffs()).norm() < 1e-15);
        CHECK((start.coeffs() - right).norm() > 0.1);  // as printed without d/dt
        CHECK((rate(0.2) - right).norm() > 0.1);
        CHECK((rate(0.2) - (half * turned(omega, 0.2, start)).coeffs()).norm() < 1e-8);
    }
}

TEST_CASE("12.5: a body at rest has no axis w / |w|: 0 / 0 as printed, the same orientation in the limit") {
    Random random(126);
    Body ball = ball_body(1.0, 1.0, Vector3::Zero(), random.rotation());
    CHECK(std::isnan(turned(Vector3::Zero(), 0.1, ball.orientation).x()));
    CHECK(rotate_exponential(ball, Vector3::Zero(), 0.1).angularDistance(ball.orientation) == 0.0);
    for (const double w : {1e-300, 1e-12, 1e-6, 1.01e-5}) {  // on both sides of where the series takes over
        const Vector3 momentum = w / ball.inverse_inertia.x() * Vector3::UnitX();
        const Quaternion change = rotate_exponential(ball, momentum, 0.1) * ball.orientation.conjugate();
        CHECK(change.x() == Approx(0.05 * w).margin(1e-16));
    }
}

TEST_CASE("the table of symbols: v_ab times dt is what the bodies move and turn, so its units are m/s and rad/s") {
    Body body = ball_body(2.0, 1.0, Vector3::Zero());
    body.linear_momentum = {2, 4, -6};
    body.angular_momentum = Vector3(0.3, 0, 0) / body.inverse_inertia.x();
    for (const double dt : {0.5, 0.25}) {
        const Vector3 moved = advance_position(body, body.linear_momentum, dt) - body.position;
        CHECK((moved - velocity(body) * dt).norm() < 1e-15);
        CHECK((moved - velocity(body) * dt * dt).norm() > 0.1);
        const double angle = rotate_exponential(body, body.angular_momentum, dt).angularDistance(body.orientation);
        CHECK(angle == Approx(angular_velocity(body).norm() * dt));
    }
}
