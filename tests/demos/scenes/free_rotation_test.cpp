// The exact rotation of a free body against its equations of motion and against the engine.
#include "demos/scenes/exact_motions/free_rotation.h"

#include "engine/base/invalid_input.h"
#include "engine/bodies/integrator.h"
#include "tests/catch.h"

#include <array>
#include <cmath>

using namespace pushfactor;
using namespace pushfactor::demos::scenes;
using engine::Quaternion;
using engine::Vector3;

namespace {

// Orientation and, in the body frame, angular momentum.
struct State {
    Eigen::Vector4d orientation;  // x, y, z, w
    Vector3 momentum;

    State plus(const State& rate, double time) const {
        return {orientation + time * rate.orientation, momentum + time * rate.momentum};
    }
};

State rate_of(const State& s, const Vector3& inertia) {
    const Vector3 omega = s.momentum.cwiseQuotient(inertia);
    const Quaternion turn =
        Quaternion(s.orientation) * Quaternion(0.0, 0.5 * omega.x(), 0.5 * omega.y(), 0.5 * omega.z());
    return {turn.coeffs(), s.momentum.cross(omega)};
}

// Euler's equations by the classical Runge-Kutta method.
Quaternion integrated(const FreeBody& body, double time, int steps) {
    State s{body.start.coeffs(), body.inertia.cwiseProduct(body.angular_rate)};
    const double h = time / steps;
    for (int i = 0; i < steps; ++i) {
        const State k1 = rate_of(s, body.inertia);
        const State k2 = rate_of(s.plus(k1, 0.5 * h), body.inertia);
        const State k3 = rate_of(s.plus(k2, 0.5 * h), body.inertia);
        const State k4 = rate_of(s.plus(k3, h), body.inertia);
        s = s.plus(k1, h / 6.0).plus(k2, h / 3.0).plus(k3, h / 3.0).plus(k4, h / 6.0);
    }
    return Quaternion(s.orientation).normalized();
}

const Quaternion askew = Quaternion(0.3, -0.2, 0.9, 0.1).normalized();

}  // namespace

TEST_CASE("Jacobi's functions have the values of the tables, and their limits") {
    // Abramowitz & Stegun, chapter 16, example 1 and table 17.1: K(0.64) = 1.9953027776647.
    const Elliptic e = jacobi_elliptic(0.2, 0.81);
    CHECK(e.sn == Approx(0.19762).margin(2e-5));
    const Elliptic quarter = jacobi_elliptic(1.9953027776647296, 0.64);
    CHECK(quarter.sn == Approx(1.0).epsilon(1e-14));
    CHECK(std::abs(quarter.cn) < 1e-13);
    CHECK(quarter.dn == Approx(0.6).epsilon(1e-13));
    for (const double u : {-3.0, 0.0, 0.5, 20.0}) {
        CHECK(jacobi_elliptic(u, 0.0).sn == Approx(std::sin(u)).margin(1e-15));
        CHECK(jacobi_elliptic(u, 1.0 - 1e-15).cn == Approx(1.0 / std::cosh(u)).margin(1e-6));
    }
}

TEST_CASE("the exact rotation is what Euler's equations lead to, whichever axis is which") {
    // Each of the six orders of the moments, the middle one unturned; spins that precess about the smallest and the
    // largest axis, with all signs.
    for (const Vector3& inertia : {Vector3(1, 2, 3), Vector3(1, 3, 2), Vector3(2, 1, 3), Vector3(2, 3, 1),
                                   Vector3(3, 1, 2), Vector3(3, 2, 1)}) {
        for (const auto& [of_smallest, of_largest] :
             {std::pair{5.0, 1.0}, std::pair{1.0, 4.0}, std::pair{-3.0, 2.5}, std::pair{2.0, -2.0}}) {
            FreeBody body{inertia, askew, Vector3::Zero()};
            for (int axis = 0; axis < 3; ++axis) {
                if (inertia[axis] == 1.0) body.angular_rate[axis] = of_smallest;
                if (inertia[axis] == 3.0) body.angular_rate[axis] = of_largest;
            }
            INFO("inertia " << inertia.transpose() << " rate " << body.angular_rate.transpose());
            FreeRotation exact(body);
            CHECK(exact.at(0.0).angularDistance(askew) < 1e-14);
            CHECK(exact.at(0.4).angularDistance(integrated(body, 0.4, 4000)) < 1e-12);
            CHECK(exact.at(3.0).angularDistance(integrated(body, 3.0, 30000)) < 1e-12);
        }
    }
}

TEST_CASE("the splitting of the engine comes to the exact rotation with the square of the step") {
    const engine::Body box = engine::box_body(2.0, {1.0, 0.4, 0.2}, Vector3::Zero(), askew);
    const FreeBody free{box.inverse_inertia.cwiseInverse(), askew, {5.0, 0.0, 4.5}};
    const auto error = [&](int steps) {
        engine::Body body = box;
        const Vector3 momentum = askew * free.inertia.cwiseProduct(free.angular_rate);
        for (int i = 0; i < steps; ++i) body.orientation = engine::rotate_splitting(body, momentum, 1.0 / steps);
        return FreeRotation(free).at(1.0).angularDistance(body.orientation);
    };
    CHECK(std::log2(error(480) / error(960)) == Approx(2.0).margin(0.01));
    CHECK(error(960) < 1e-3);
}

TEST_CASE("motions that the closed form leaves out are refused") {
    const Vector3 inertia(1, 2, 3);
    CHECK_THROWS_AS(FreeRotation({inertia, askew, {1, 1, 1}}), engine::InvalidInput);
    CHECK_THROWS_AS(FreeRotation({inertia, askew, {1, 0, 0}}), engine::InvalidInput);
    CHECK_THROWS_AS(FreeRotation({{1, 1, 2}, askew, {1, 0, 1}}), engine::InvalidInput);
    CHECK_THROWS_WITH(FreeRotation({{1, 1, 2}, askew, {1, 0, 1}}), Catch::Contains("inertia 1.0"));
}
