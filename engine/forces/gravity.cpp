#include "engine/forces/gravity.h"

namespace pushfactor::engine {

void Gravity::add_forces(const ForcedBodies& bodies, double, double) {
    for (Body& body : bodies) {
        if (!body.is_static()) body.force += body.mass() * acceleration_;
    }
}

}  // namespace pushfactor::engine
