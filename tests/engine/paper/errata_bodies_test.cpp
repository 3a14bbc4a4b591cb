// Errata of paper section 3, of equation 6.1.6 and of the table of symbols: the printed version and the right one.
#include "engine/bodies/body.h"
#include "engine/bodies/diagnostics.h"
#include "engine/bodies/integrator.h"
#include "tests/catch.h"
#include "tests/random.h"

#include <algorithm>
#include <cmath>

using namespace pushfactor::engine;
using pushfactor::tests::Random;

namespace {

double energy(const Matrix3& inertia, const Vector3& omega) {
    return 0.5 * omega.dot(inertia * omega);
}

// Three possible moments of inertia: none is larger than the sum of the others.
bool fits_a_shape(Vector3 moments) {
    std::sort(moments.begin(), moments.end());
    return moments[2] <= (moments[0] + moments[1]) * (1.0 + 1e-12);
}

// Masses of 1 kg on both sides at these distances along each axis.
struct Cross {
    Vector3 arm{0.3, 1.0, 2.0};

    std::vector<Vector3> points(const Quaternion& turned) const {
        std::vector<Vector3> all;
        for (int axis = 0; axis < 3; ++axis) {
            for (const double side : {-1.0, 1.0}) all.push_back(turned * (side * arm[axis] * Vector3::Unit(axis)));
        }
        return all;
    }
    Body body(const Quaternion& turned) const {
        Body body;
        body.inverse_mass = 1.0 / 6.0;
        const Vector3 squares = 2.0 * arm.cwiseProduct(arm);
        body.inverse_inertia = (Vector3::Constant(squares.sum()) - squares).cwiseInverse();
        body.orientation = turned;
        return body;
    }
};

Body tumbling_box(Random& random) {
    Body body = box_body(2.0, {1.0, 0.4, 0.2}, Vector3::Zero(), random.rotation());
    body.angular_momentum = random.vector(-1, 1);
    return body;
}

}  // namespace

TEST_CASE("3.1: matrices with a non-zero diagonal whose energy is negative, that have no inverse or no shape") {
    Matrix3 negative = Matrix3::Identity();
    negative(0, 1) = negative(1, 0) = 2.0;
    CHECK(energy(negative, {1, -1, 0}) == -1.0);
    CHECK(Matrix3::Ones().eval().determinant() == 0.0);
    CHECK(!fits_a_shape({1, 1, 3}));

    Random random(31);
    for (int i = 0; i < 200; ++i) {
        const Body box = box_body(random.in(0.1, 5), random.vector(0.1, 3), Vector3::Zero(), random.rotation());
        CHECK(fits_a_shape(box.inverse_inertia.cwiseInverse()));
        CHECK(energy(world_inverse_inertia(box).inverse(), random.vector(-1, 1)) > 0.0);
    }
}

TEST_CASE(
    "3.1: read as a product of vectors p x r is the angular momentum of the opposite turn, r x p the right one") {
    Random random(32);
    for (int i = 0; i < 50; ++i) {
        const Cross cross;
        const Vector3 omega = random.vector(-2, 2);
        Body body = cross.body(random.rotation());
        Vector3 printed = Vector3::Zero();
        for (const Vector3& r : cross.points(body.orientation)) {
            const Vector3 p = omega.cross(r);
            printed += p.cross(r);
            body.angular_momentum += r.cross(p);
        }
        CHECK((angular_velocity(body) - omega).norm() < 1e-12);
        CHECK((world_inverse_inertia(body) * printed + omega).norm() < 1e-12);
    }
}

TEST_CASE("3.1: an orientation has length 1 whatever its angle, so it is not in radians") {
    Body body = ball_body(1.0, 1.0, Vector3::Zero());
    const double moment = 1.0 / body.inverse_inertia.x();
    for (const double angle : {0.1, 1.0, 3.0, 6.0}) {
        const Quaternion turned = rotate_exponential(body, {0, angle * moment, 0}, 1.0);
        CHECK(turned.norm() == Approx(1.0).epsilon(1e-15));
        CHECK(turned.w() == Approx(std::cos(0.5 * angle)).margin(1e-15));
    }
}

TEST_CASE("3.2.4: I^-1 is that of the world frame, and its rate stands left of the orientation") {
    Random random(33);
    for (int i = 0; i < 50; ++i) {
        const Body body = tumbling_box(random);
        const Vector3 corner(0.5, 0.2, 0.1);
        const double h = 1e-6;
        const Vector3 moved = rotate_euler(body, body.angular_momentum, h) * corner;
        const Vector3 velocity = (moved - body.orientation * corner) / h;
        const auto misses = [&](const Vector3& omega) {
            return (omega.cross(body.orientation * corner) - velocity).norm() / velocity.norm();
        };
        CHECK(misses(angular_velocity(body)) < 1e-4);
        CHECK(misses(body.inverse_inertia.cwiseProduct(body.angular_momentum)) > 0.01);  // body frame

        // On the right side the same rate turns about axes of the body.
        const Vector3 half = 0.5 * h * angular_velocity(body);
        const Quaternion rate(1.0, half.x(), half.y(), half.z());
        const Vector3 other = (body.orientation * rate).normalized() * corner;
        CHECK((other - moved).norm() > 0.01 * h * velocity.norm());
    }
}

TEST_CASE("6.1.6: without torque the angular acceleration is -I^-1 (w x I w) and not zero") {
    Random random(34);
    for (int i = 0; i < 50; ++i) {
        const Body body = tumbling_box(random);
        const auto omega_after = [&](double time) {
            Body later = body;
            later.orientation = rotate_splitting(body, body.angular_momentum, time);
            return angular_velocity(later);
        };
        const double h = 1e-5;
        const Vector3 measured = (omega_after(h) - omega_after(-h)) / (2.0 * h);
        const Vector3 gyroscopic =
            -(world_inverse_inertia(body) * angular_velocity(body).cross(body.angular_momentum));
        CHECK((measured - gyroscopic).norm() < 1e-5 * (1.0 + gyroscopic.norm()));
        CHECK(measured.norm() > 0.01);  // 6.1.6 as printed has zero here
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
