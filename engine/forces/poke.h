// A force and a torque on one body between two given times.
#pragma once

#include "engine/forces/force_source.h"

#include <limits>

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
    double until = std::numeric_limits<double>::infinity();
};

class PokeForce : public ForceSource {
  public:
    explicit PokeForce(const Poke& poke) : poke_(poke) {}
    void add_forces(const ForcedBodies& bodies, double time) override;
    SomeBodies pushed_anew(double from, double until) const override;
    bool turns_unseen(int body) const override;

  private:
    bool acts_at(double time) const;

    Poke poke_;
};

}  // namespace pushfactor::engine
