#include "tests/fuzz/free_pair.h"

#include "engine/bodies/integrator.h"

#include <algorithm>
#include <cmath>

namespace pushfactor::tests {

namespace {

using engine::Body;
using engine::Quaternion;
using engine::Vector3;

constexpr double resolution = 1e-9;     // m
constexpr double same_normal = 1e-3;    // rad
constexpr double other_overlap = 1e-4;  // of the smaller size
constexpr double margin = 0.01;         // of the size, in which the engine has rows for what is near

double angle_between(const Vector3& a, const Vector3& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

// The number of turns of rotate_by_small_turns.
double turns_of(const Body& body, double dt) {
    constexpr double largest_turn = 0.1;
    return std::max(1.0,
                    std::ceil(body.angular_momentum.norm() * body.inverse_inertia.maxCoeff() * dt / largest_turn));
}

// rad/s, of the uniform turn that ends where the engine's step does; of more than half a turn the other way round
// would be shorter, so there it is that of the start.
Vector3 steady_spin(const Body& body, double dt) {
    const Vector3 spin = angular_velocity(body);
    if (dt * spin.norm() > 3.0) return spin;
    const Quaternion end = engine::rotate_by_small_turns(body, body.angular_momentum, dt);
    const Eigen::AngleAxisd turn(end * body.orientation.conjugate());
    return (turn.angle() / dt) * turn.axis();
}

Quaternion turned(const Body& body, double time, double dt, Turning turning) {
    if (turning == Turning::steady) return engine::exponential(time * steady_spin(body, dt)) * body.orientation;
    const double turns = turns_of(body, dt);
    Body now = body;
    for (double turn = 0.0; turn < turns; ++turn) {
        now.orientation = engine::rotate_splitting(now, body.angular_momentum, time / turns);
    }
    return now.orientation;
}

// rad^2/s^2, of the fastest turning within the step: exact if it is steady, else by samples, with half as much
// again.
double fastest_turning(const Body& body, double dt, Turning turning) {
    if (turning == Turning::steady) return steady_spin(body, dt).squaredNorm();
    double fastest = angular_velocity(body).squaredNorm();
    for (int i = 1; i <= 8; ++i) {
        fastest = std::max(fastest, angular_velocity(moved(body, i * dt / 8.0, dt, turning)).squaredNorm());
    }
    return 1.5 * fastest;
}

// m/s^2, of the fastest point. The angular acceleration of a free body is at most the square of its angular
// velocity.
double bend_of(const FreeBody& body, double dt, Turning turning) {
    const double square = fastest_turning(body.body, dt, turning);
    return (turning == Turning::steady ? 1.0 : 2.0) * square * body.solid->turning_radius;
}

void advance(FreeBody& body, double dt) {
    body.body.orientation = engine::rotate_by_small_turns(body.body, body.body.angular_momentum, dt);
    body.body.position += dt * velocity(body.body);
}

bool is_ball(const FreeBody& body) {
    return body.solid->faces.empty();
}

struct Touching {
    double time = 0.0;  // s within the step
    double next_gap = -engine::infinity;
    std::optional<Vector3> normal{};
};

// How a pair touches that overlaps by more than `graze` within the step.
Touching touching(const PairStep& step, double size) {
    const double time = step.first_at(0.0).value();
    const Vector3 before = step.at(step.first_at(1e-5 * size).value()).normal;
    const Vector3 normal = step.at(step.first_at(1e-7).value()).normal;
    const bool turns = angle_between(before, normal) > same_normal;
    const double other = next_gap(step.placed(0, time), step.placed(1, time), normal, same_normal);
    Touching touch{.time = time, .next_gap = other};
    if (!turns && other < -other_overlap * size) touch.normal = normal;
    return touch;
}

// rad, from the start of the step to `time`: of the normal, if one is a ball, or of the bodies.
double turned_until(double time, const PairStep& step, const FreeBody& a, const FreeBody& b) {
    if (is_ball(a) || is_ball(b)) return angle_between(step.at(0.0).normal, step.at(time).normal);
    return time * (angular_velocity(a.body).norm() + angular_velocity(b.body).norm());
}

// Of the step that may be the first with a touch; `passes` is that of this step alone.
Prediction predict_step(const FreeBody& a, const FreeBody& b, double dt) {
    Prediction found;
    const double size = std::min(a.solid->size, b.solid->size);
    std::optional<Vector3> normal;
    for (const Turning turning : {Turning::steady, Turning::torque_free}) {
        const PairStep step(a, b, dt, turning);
        const bool passes = !step.first_at(graze);
        if (!passes && (step.at(0.0).distance <= graze || !step.first_at(-graze))) return {};
        const Prediction::Kind kind = passes ? Prediction::Kind::passes : Prediction::Kind::touches;
        if (turning == Turning::torque_free && kind != found.kind) return {};
        found.kind = kind;
        if (passes) continue;
        const Touching touch = touching(step, size);
        found.time = touch.time;
        found.gap = step.at(0.0).distance;
        found.next_gap = std::max(found.next_gap, touch.next_gap);
        found.in_margin = found.gap < margin * std::max(a.solid->size, b.solid->size);
        found.turned = std::max(found.turned, turned_until(touch.time, step, a, b));
        if (turning == Turning::steady) {
            normal = touch.normal;
        } else if (normal && touch.normal && angle_between(*normal, *touch.normal) < same_normal) {
            found.normal = normal;
        }
    }
    return found;
}

}  // namespace

Body moved(const Body& body, double time, double dt, Turning turning) {
    Body now = body;
    now.position += time * velocity(body);
    now.orientation = turned(body, time, dt, turning);
    return now;
}

PairStep::PairStep(const FreeBody& a, const FreeBody& b, double dt, Turning turning)
    : bodies_{a, b}, dt_(dt), turning_(turning), relative_velocity_(velocity(b.body) - velocity(a.body)) {
    double speed = relative_velocity_.norm();
    for (const FreeBody& body : bodies_) {
        bend_ += bend_of(body, dt, turning);
        speed += std::sqrt(fastest_turning(body.body, dt, turning)) * body.solid->turning_radius;
    }
    short_ = speed > 0.0 ? resolution / speed : dt;
}

PlacedSolid PairStep::placed(int which, double time) const {
    const FreeBody& body = bodies_[static_cast<std::size_t>(which)];
    const Body now = moved(body.body, time, dt_, turning_);
    return {*body.solid, now.position, now.orientation};
}

Closeness PairStep::at(double time) const {
    return closeness(placed(0, time), placed(1, time));
}

bool PairStep::stays_above(double level, double from, double until) const {
    const double middle = 0.5 * (from + until), length = until - from;
    const auto& [a, b] = bodies_;
    const Vector3 between = b.body.position - a.body.position + middle * relative_velocity_;
    const double apart = between.norm() - a.reach() - b.reach() - 0.5 * length * relative_velocity_.norm();
    if (apart > level) return true;
    const Closeness now = at(middle);
    if (now.distance <= level) return false;
    const auto gap = [&](double time) { return gap_along(placed(0, time), placed(1, time), now.normal); };
    const double room = level + bend_ * length * length / 8.0;
    return gap(from) > room && gap(until) > room;
}

std::optional<double> PairStep::first_at(double level, double from, double until) const {
    if (stays_above(level, from, until)) return std::nullopt;
    if (until - from <= short_) return from;
    const double middle = 0.5 * (from + until);
    const auto found = first_at(level, from, middle);
    return found ? found : first_at(level, middle, until);
}

Prediction predict(FreeBody a, FreeBody b, double dt, long steps) {
    for (long step = 1; step <= steps; ++step) {
        Prediction found = predict_step(a, b, dt);
        found.step = step;
        if (found.kind != Prediction::Kind::passes) return found;
        advance(a, dt);
        advance(b, dt);
    }
    return {.kind = Prediction::Kind::passes};
}

bool stays_above(double level, FreeBody a, FreeBody b, double dt, long steps, Turning turning) {
    for (long step = 1; step <= steps; ++step) {
        if (PairStep(a, b, dt, turning).first_at(level)) return false;
        advance(a, dt);
        advance(b, dt);
    }
    return true;
}

}  // namespace pushfactor::tests
