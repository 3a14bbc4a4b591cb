#include "engine/impacts/flight.h"

#include <algorithm>

namespace pushfactor::engine {

namespace {

// rad
constexpr double steady_turn = 0.3;

// I alpha [N m], world frame.
Vector3 moment_of(const Body& body, const Vector3& acceleration) {
    const Vector3 own = body.orientation.conjugate() * acceleration;
    return body.orientation * own.cwiseQuotient(body.inverse_inertia);
}

}  // namespace

Flight::Flight(const Body& body, const Vector6& by_rows, double dt, OrientationStep rotate)
    : first_(body),
      latest_(body),
      by_rows_(by_rows),
      acceleration_(body.inverse_mass * body.force + by_rows.head<3>()),
      dt_(dt),
      rotate_(rotate),
      linear_momentum_(body.linear_momentum),
      angular_momentum_(body.angular_momentum) {
    if (body.is_static()) return;
    latest_.linear_momentum += (0.5 * dt / body.inverse_mass) * acceleration_;
    torque_ = body.torque + moment_of(body, by_rows.tail<3>());
    latest_.angular_momentum += 0.5 * dt * torque_;
    latest_.force.setZero();
    latest_.torque.setZero();
}

Vector3 Flight::position_at(double time) const {
    const double flown = time - since_;
    return latest_.position + flown * (velocity(latest_) + (0.5 * flown) * acceleration_);
}

Vector3 Flight::velocity_at(double time) const {
    return velocity(latest_) + (time - since_) * acceleration_;
}

Body Flight::shifted(double time) const {
    Body body = latest_;
    if (body.is_static()) {
        body.position += (time - since_) * body.prescribed.velocity;
        return body;
    }
    body.position = position_at(time);
    body.linear_momentum += ((time - since_) / body.inverse_mass) * acceleration_;
    body.angular_momentum += (time - since_) * torque_;
    return body;
}

Body Flight::at(double time) const {
    Body body = shifted(time);
    const double flown = time - since_;
    if (!(flown > 0.0)) return body;
    body.orientation = body.is_static() ? exponential(flown * body.prescribed.angular_velocity) * body.orientation
                                        : rotate_(latest_, latest_.angular_momentum + 0.5 * flown * torque_, flown);
    return body;
}

Motion Flight::motion(double time, double until) const {
    Body body = at(time);
    if (body.is_static()) return motion_of(body);
    body.angular_momentum += (0.5 * (until - time)) * torque_;
    Motion motion = motion_in_step(body, until - time, rotate_);
    motion.velocity += (0.5 * (until - time)) * acceleration_;
    return motion;
}

double Flight::steady_until(double time) const {
    const Vector3& moments = first_.inverse_inertia;
    if (moments.minCoeff() == moments.maxCoeff()) return dt_;
    return std::min(dt_, time + steady_turn / angular_velocity(latest_).norm());
}

void Flight::hit(double time, const Vector6& impulse) {
    latest_ = at(time);
    since_ = time;
    latest_.linear_momentum += impulse.head<3>();
    latest_.angular_momentum += impulse.tail<3>();
    linear_momentum_ += impulse.head<3>();
    angular_momentum_ += impulse.tail<3>();
    lag_ += (time * first_.inverse_mass) * impulse.head<3>();
    is_hit_ = true;
}

Place Flight::end() const {
    const Vector3 momentum = linear_momentum_ + dt_ * first_.force;
    Place place{first_.position + (dt_ * first_.inverse_mass) * momentum - lag_, at(dt_).orientation};
    if (!by_rows_.tail<3>().isZero(0.0)) {
        place.orientation = exponential((-dt_ * dt_) * by_rows_.tail<3>()) * place.orientation;
    }
    return place;
}

}  // namespace pushfactor::engine
