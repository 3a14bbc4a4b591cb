#include "engine/poke.h"

namespace pushfactor::engine {

void PokeForce::add_forces(std::span<Body> bodies, double time) {
    // The world's time is a sum of steps, so "from 2 s" must not miss the step that begins a rounding before it.
    const double rounding = 1e-9 * time;
    if (time < poke_.from - rounding || time >= poke_.until - rounding) return;
    bodies[static_cast<std::size_t>(poke_.body)].force += poke_.force;
}

}  // namespace pushfactor::engine
