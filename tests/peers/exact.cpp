#include "tests/peers/exact.h"

#include "demos/scenes/exact_motions/ball_on_bar.h"
#include "demos/scenes/exact_motions/hanging_chain.h"

#include <cmath>

namespace pushfactor::tests::peers {

namespace {

constexpr int fine = 16;  // steps of a reference in one of ours

// angle'' = -g / L sin angle, L = arm + k^2 / arm, by the Runge-Kutta-Nystroem method of order 4.
std::vector<double> rigid_pendulum(double gravity_per_length, double amplitude, std::size_t steps) {
    const double h = step_length / fine;
    const auto pull = [&](double angle) { return -gravity_per_length * std::sin(angle); };
    std::vector<double> angles{amplitude};
    double angle = amplitude, rate = 0.0;
    for (std::size_t n = 0; n < steps; ++n) {
        for (int i = 0; i < fine; ++i) {
            const double first = pull(angle);
            const double middle = pull(angle + 0.5 * h * rate + 0.125 * h * h * first);
            const double end = pull(angle + h * rate + 0.5 * h * h * middle);
            angle += h * rate + h * h / 6.0 * (first + 2.0 * middle);
            rate += h / 6.0 * (first + 4.0 * middle + end);
        }
        angles.push_back(angle);
    }
    return angles;
}

struct Turning {
    Vector3 l;          // angular momentum, body frame
    Eigen::Vector4d q;  // x y z w
};

Turning moved(const Turning& t, const Turning& rate, double h) {
    return {t.l + h * rate.l, t.q + h * rate.q};
}

}  // namespace

std::vector<double> exact_angles(const Body& ball, const Link& link, double gravity, double amplitude, Joint joint,
                                 std::size_t steps) {
    if (joint == Joint::rigid_arm) {
        const double arm = link.length + ball.radius;
        return rigid_pendulum(gravity / (arm + inertia(ball).x() / (ball.mass * arm)), amplitude, steps);
    }
    const demos::scenes::BallOnBar pendulum{.length = link.length, .radius = ball.radius, .gravity = gravity};
    demos::scenes::Swing swing{.a = amplitude, .b = amplitude};
    std::vector<double> angles{amplitude};
    for (std::size_t n = 0; n < steps; ++n) {
        swing = advance(pendulum, swing, step_length, fine);
        angles.push_back(centre_angle(pendulum, swing));
    }
    return angles;
}

std::vector<std::vector<Vector3>> exact_chain(const Scene& scene, Joint joint, std::size_t steps) {
    constexpr int finer = 256;  // below the errors of the finest runs
    const auto count = static_cast<Eigen::Index>(scene.movable.size());
    demos::scenes::HangingChain chain{.lengths = Eigen::VectorXd(count),
                                      .masses = Eigen::VectorXd(count),
                                      .moments = Eigen::VectorXd::Zero(count),
                                      .gravity = scene.gravity.norm()};
    demos::scenes::ChainSwing swing{.angles = Eigen::VectorXd(count), .rates = Eigen::VectorXd::Zero(count)};
    Vector3 above = Vector3::Zero();
    for (Eigen::Index i = 0; i < count; ++i) {
        const Body& ball = scene.movable[static_cast<std::size_t>(i)];
        const Vector3 bar = ball.start.position - above;
        above = ball.start.position;
        chain.lengths[i] = bar.norm();
        chain.masses[i] = ball.mass;
        if (joint == Joint::rigid_arm) chain.moments[i] = inertia(ball).z();
        swing.angles[i] = std::atan2(bar.x(), -bar.y());
    }
    std::vector<std::vector<Vector3>> result;
    for (std::size_t n = 0; n <= steps; ++n) {
        if (n > 0) swing = advance(chain, std::move(swing), step_length, finer);
        std::vector<Vector3>& now = result.emplace_back();
        for (const Eigen::Vector2d& place : places(chain, swing)) now.emplace_back(place.x(), place.y(), 0.0);
    }
    return result;
}

// l' = l x w and q' = q w / 2 in the body's frame, by the classical Runge-Kutta method.
Quaternion exact_attitude(const Body& body, double time) {
    const Vector3 moments = inertia(body);
    const auto rates = [&](const Turning& t) {
        const Vector3 w = t.l.cwiseQuotient(moments);
        return Turning{t.l.cross(w), 0.5 * (Quaternion(t.q) * Quaternion(0.0, w.x(), w.y(), w.z())).coeffs()};
    };
    Turning t{moments.cwiseProduct(body.start.orientation.conjugate() * body.start.angular_velocity),
              body.start.orientation.coeffs()};
    const long steps = std::lround(time * 3840.0);
    const double h = time / static_cast<double>(steps);
    for (long n = 0; n < steps; ++n) {
        const Turning k1 = rates(t);
        const Turning k2 = rates(moved(t, k1, 0.5 * h));
        const Turning k3 = rates(moved(t, k2, 0.5 * h));
        const Turning k4 = rates(moved(t, k3, h));
        t = moved(moved(moved(moved(t, k1, h / 6.0), k2, h / 3.0), k3, h / 3.0), k4, h / 6.0);
    }
    return Quaternion(t.q).normalized();
}

}  // namespace pushfactor::tests::peers
