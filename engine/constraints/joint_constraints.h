// Joints, paper section 5.1 (constraints in general) and 8.1 (motors). A ball joint holds point p_a of body a and
// point p_b of body b together; a hinge also holds an axis u of a along an axis of b, and may have a motor and
// limits of its angle.
//
//   point, k = 1..3   c_k = p_ab . e_k          j_c = [-e_k, -r_a x e_k, e_k, r_b x e_k]   as in 5.2 with l = 0
//   axis, k = 1, 2    c_k = L theta . t_k       j_c = L [0, -t_k, 0, t_k]
//   motor             v = L omega               j_c = L [0, -u, 0, u],   -T / L <= lambda <= T / L
//   servo             v = -L k (phi - target) m, the same axis, softness L^2 m / dt with m = 1 / (k dt + d)
//   limits            c = L (phi - low) >= 0    j_c = L [0, -u, 0, u],   lambda >= 0
//                     c = L (high - phi) >= 0   j_c = L [0, u, 0, -u],   lambda >= 0
//
// Symbols: p_ab = p_b - p_a [m]; r_i = p_i - x_i lever arms [m], see point_jacobian.h; e_k the world's axes; u unit
// length; t_k two unit vectors across u, fixed in a; theta the rotation from u to the axis of b, along u x axis
// [rad]; phi angle of b about u, from where b is at angle 0, with all turns since the start [rad]; omega speed of
// the motor [rad/s]; T its largest torque [N m]; k and d stiffness and damping of a servo, which is a spring as in
// distance_constraints.h [N m/rad, N m s/rad]; v push factor, lambda force. L is a lever [m], the smaller radius of
// gyration of the bodies: with it rows that turn are in m/s and N like all others, and tolerances mean the same.
//
// The motor is one of the "constant speed motors" of 8.1: its push lasts. It is the bounds that make it stall.
// Where a limit is nearer than its speed reaches, it aims at the limit, so both agree; without a largest torque
// that is enough, and the limit has no rows. Limits are one-sided rows like contacts: open ones may close within
// the step, closed ones are corrected. Two equal limits are one row that acts both ways: the bodies are welded.
//
// The rows without bounds of joints that close a loop are soft (constraint_row.h).
#pragma once

#include "engine/constraints/held_pairs.h"

#include <optional>
#include <vector>

namespace pushfactor::engine {

// Turns a hinge towards an angle, or holds it there, like a spring: a load T turns it aside by T / stiffness.
struct Servo {
    double angle = 0.0;      // rad
    double stiffness = 0.0;  // N m/rad, >= 0
    double damping = 0.0;    // N m s/rad, >= 0; one of both above 0
};

struct Motor {
    double speed = 0.0;            // rad/s, of b about the axis relative to a
    double max_torque = infinity;  // N m, > 0
    std::optional<Servo> servo{};  // in the place of speed and largest torque
};

struct AngleLimits {
    double low = 0.0, high = 0.0;  // rad, low <= high, at most a turn apart
};

struct Hinge {
    Vector3 axis = Vector3::UnitZ();           // u, unit length, frame of a
    Quaternion zero = Quaternion::Identity();  // orientation of b in the frame of a at angle 0
    std::optional<Motor> motor{};
    std::optional<AngleLimits> limits{};
};

struct Joint {
    int body_a = 0;  // indices into the bodies of the world; a static body represents the world itself
    int body_b = 0;
    Vector3 point_a = Vector3::Zero();  // m, body frame, from the centre of mass
    Vector3 point_b = Vector3::Zero();
    std::optional<Hinge> hinge{};  // without: a ball joint
    bool closes_loop = false;      // part of a loop of joints and distances (loops.h); static bodies are one
};

// Angle of a hinge in (-pi, pi] [rad].
double angle_of(const Joint& joint, std::span<const Body> bodies);

// Rows of a joint, in their order: three of the point, two of the axis, motor, lower and upper limit.
inline constexpr std::size_t most_joint_rows = 8, motor_row = 5;
std::size_t row_count(const Joint& joint);

class JointConstraints : public HeldPairs<Joint, most_joint_rows> {
  public:
    JointConstraints(std::vector<Joint> joints, const Correction& correction, bool cached);

    void append_rows(const StepStart& step, RowList& rows) override;
    void append_rows_of(std::size_t index, const BodyPair& bodies, double dt, RowList& rows) const override;
    bool turns_unseen(int body) const override;
    double stored_energy(std::span<const Body> bodies) const override;

    std::span<const Joint> joints() const { return items_; }

    // phi of each joint at the start of the last step [rad]; NaN where it is not needed, or not known yet. Part of
    // the state of a run.
    const std::vector<double>& angles() const { return angles_; }
    void set_angles(std::vector<double> angles);

  private:
    void append_hinge(std::size_t index, const BodyPair& bodies, double dt, RowList& rows) const;
    void append_motor(std::size_t index, const BodyPair& bodies, double dt, double angle, RowList& rows) const;
    double angle_near(std::size_t index, const BodyPair& bodies) const;

    std::vector<double> angles_;
};

using JointForce = JointConstraints::Force;

}  // namespace pushfactor::engine
