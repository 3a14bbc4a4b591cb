// A force and a torque on one body between two given times.
#pragma once

#include "engine/forces/force_source.h"

namespace pushfactor::engine {

struct Poke {
    enum class Frame {
        world,
        body,  // force and torque turn with the body
    };

    int body = 0;
    Vector3 force = Vector3::Zero();   // N
    Vector3 torque = Vector3::Zero();  // N m, beside that of the force about the centre of mass
    Vector3 point = Vector3::Zero();   // m, body frame, from the centre of mass: where the force acts
    Frame frame = Frame::world;        // of force and torque
    double from = 0.0;                 // s, world time
    double until = infinity;
};

class PokeForce : public ForceSource {
  public:
    explicit PokeForce(const Poke& poke) : poke_(poke) {}
    void add_forces(const ForcedBodies& bodies, double from, double until) override;
    SomeBodies pushed_anew(double from, double until) const override;
    bool turns_unseen(int body) const override;

    const Poke& poke() const { return poke_; }
    bool acts_at(double time) const { return share_of(time, time) > 0.0; }  // s

    // Force and torque beside it in the world frame [N, N m], for a body with this orientation.
    Vector3 force(const Quaternion& orientation) const { return in_world(poke_.force, orientation); }
    Vector3 torque(const Quaternion& orientation) const { return in_world(poke_.torque, orientation); }

  private:
    // Share of the time from `from` to `until` [s] in which it acts; of an instant 0 or 1.
    double share_of(double from, double until) const;
    Vector3 in_world(const Vector3& vector, const Quaternion& orientation) const {
        return poke_.frame == Poke::Frame::body ? Vector3(orientation * vector) : vector;
    }

    Poke poke_;
};

}  // namespace pushfactor::engine
