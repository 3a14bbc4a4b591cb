// The way of a body through a step in which it is hit: it flies freely from impact to impact.
//
// Between impacts its position is the parabola through those of 3.2.3, whose momenta belong half a step earlier:
// t after the start of the step it has v1 + a (t + dt / 2), and a body that nothing hits ends where 3.2 lets it
// end. It turns freely, with the mean of its angular momentum, l1 + tau (t + dt / 2).
//
// Symbols: v1, l1 velocity and angular momentum before the step [m/s, kg m^2/s], a acceleration [m/s^2], tau torque
// [N m], dt time step [s].
#pragma once

#include "engine/bodies/motion.h"
#include "engine/bodies/path.h"

namespace pushfactor::engine {

class Flight {
  public:
    // `body` with its external forces; `by_rows` are the accelerations that constraints will add [m/s^2, rad/s^2].
    Flight(const Body& body, const Vector6& by_rows, double dt, OrientationStep rotate);

    // The body at `time` [s] of the step, not before the last impact: its place, and the momenta that it has then.
    Body at(double time) const;
    // The same without its turning, which changes nothing for balls.
    Body shifted(double time) const;

    Vector3 position_at(double time) const;
    Vector3 velocity_at(double time) const;
    const Vector3& acceleration() const { return acceleration_; }

    // Constant velocities that take it from its place at `time` to that at `until` [s], and until when they are
    // near its motion: bodies with unequal moments turn about another axis all the time.
    Motion motion(double time, double until) const;
    double steady_until(double time) const;

    // An impulse [N s, N m s] at `time`, not before the last one.
    void hit(double time, const Vector6& impulse);

    // The momenta before the step together with all impulses.
    const Vector3& linear_momentum() const { return linear_momentum_; }
    const Vector3& angular_momentum() const { return angular_momentum_; }
    // Where it ends with the external forces alone.
    Place end() const;

    bool is_hit() const { return is_hit_; }
    Vector3 fall() const { return first_.inverse_mass * first_.force; }  // m/s^2

  private:
    bool turns_steadily() const;

    Body first_;          // at the start of the step
    Body latest_;         // after the last impact, with the momenta of that time
    double since_ = 0.0;  // s, time of the last impact
    Vector6 by_rows_;
    Vector3 acceleration_;              // m/s^2
    Vector3 torque_ = Vector3::Zero();  // N m
    double dt_;
    OrientationStep rotate_;
    Vector3 linear_momentum_, angular_momentum_;
    Vector3 lag_ = Vector3::Zero();  // m, by which it would be farther if all impulses acted at the start
    bool is_hit_ = false;
    mutable double looked_at_ = 0.0;  // s, the last look, and how it was turned then
    mutable Quaternion turned_ = Quaternion::Identity();
};

}  // namespace pushfactor::engine
