// A force on one body that begins and ends at given times.
#pragma once

#include "engine/forces/force_source.h"

#include <limits>

namespace pushfactor::engine {

struct Poke {
    int body = 0;
    Vector3 force = Vector3::Zero();  // N, world frame, at the centre of mass
    double from = 0.0;                // s of the world's time
    double until = std::numeric_limits<double>::infinity();
};

class PokeForce : public ForceSource {
  public:
    explicit PokeForce(const Poke& poke) : poke_(poke) {}
    void add_forces(const ForcedBodies& bodies, double time) override;
    SomeBodies pushed_anew(double from, double until) const override;

  private:
    bool acts_at(double time) const;

    Poke poke_;
};

}  // namespace pushfactor::engine
