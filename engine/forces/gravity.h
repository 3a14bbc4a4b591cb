// Uniform gravity, the external force of paper section 6.1.5.
#pragma once

#include "engine/forces/force_source.h"

namespace pushfactor::engine {

class Gravity : public ForceSource {
  public:
    explicit Gravity(const Vector3& acceleration) : acceleration_(acceleration) {}  // m/s^2, world frame
    void add_forces(const ForcedBodies& bodies, double, double) override {
        for (Body& body : bodies) {
            if (!body.is_static()) body.force += body.mass() * acceleration_;
        }
    }
    SomeBodies pushed_anew(double, double) const override { return {}; }
    bool turns_unseen(int) const override { return true; }
    Vector3 gravity() const override { return acceleration_; }

  private:
    Vector3 acceleration_;
};

}  // namespace pushfactor::engine
