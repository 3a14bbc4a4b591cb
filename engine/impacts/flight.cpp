#include "engine/impacts/flight.h"

#include "engine/base/constants.h"

#include <algorithm>

namespace pushfactor::engine {

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
    torque_ = body.torque + angular_momentum_of(body, by_rows.tail<3>());
    latest_.angular_momentum += 0.5 * dt * torque_;
    turned_ = body.orientation;
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
    body.position = position_at(time);
    if (body.is_static()) return body;
    body.linear_momentum += ((time - since_) / body.inverse_mass) * acceleration_;
    body.angular_momentum += (time - since_) * torque_;
    return body;
}

// From the last look on, so that one look after the other does not turn it from the start each time.
Body Flight::at(double time) const {
    Body body = shifted(time);
    if (!(time > since_)) return body;
    if (body.is_static()) {
        body.orientation = exponential((time - since_) * body.prescribed.angular_velocity) * body.orientation;
        return body;
    }
    if (time < looked_at_) looked_at_ = since_, turned_ = latest_.orientation;
    Body turning = latest_;
    turning.orientation = turned_;
    const Vector3 mean = latest_.angular_momentum + (0.5 * (looked_at_ + time) - since_) * torque_;
    if (time > looked_at_) turned_ = rotate_(turning, mean, time - looked_at_);
    looked_at_ = time;
    body.orientation = turned_;
    return body;
}

Motion Flight::motion(double time, double until) const {
    const double rest = until - time;
    if (turns_steadily()) {
        Body mean = shifted(time);
        mean.angular_momentum += (0.5 * rest) * torque_;
        return {(position_at(until) - mean.position) / rest, angular_velocity(mean)};
    }
    const Body now = at(time), then = at(until);
    return motion_between({now.position, now.orientation}, {then.position, then.orientation}, rest);
}

bool Flight::turns_steadily() const {
    return first_.inverse_inertia.minCoeff() == first_.inverse_inertia.maxCoeff();
}

double Flight::steady_until(double time) const {
    if (turns_steadily()) return dt_;
    return std::min(dt_, time + constants::impacts::steady_turn / angular_velocity(latest_).norm());
}

void Flight::hit(double time, const Vector6& impulse) {
    latest_ = at(time);
    since_ = looked_at_ = time;
    turned_ = latest_.orientation;
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
