#include "engine/forces/poke.h"

namespace pushfactor::engine {

// The world's time is a sum of steps, so "from 2 s" must not miss the step that begins a rounding before it.
bool PokeForce::acts_at(double time) const {
    const double rounding = 1e-9 * time;
    return time >= poke_.from - rounding && time < poke_.until - rounding;
}

void PokeForce::add_forces(const ForcedBodies& bodies, double time) {
    if (acts_at(time)) bodies[static_cast<std::size_t>(poke_.body)].force += poke_.force;
}

SomeBodies PokeForce::pushed_anew(double from, double until) const {
    if (acts_at(from) == acts_at(until)) return {};
    return {.some = {poke_.body}};
}

}  // namespace pushfactor::engine
