#include "engine/forces/poke.h"

namespace pushfactor::engine {

// The world's time is a sum of steps, so "from 2 s" must include a step that begins a rounding error before it.
bool PokeForce::acts_at(double time) const {
    const double rounding = 1e-9 * time;
    return time >= poke_.from - rounding && time < poke_.until - rounding;
}

void PokeForce::add_forces(const ForcedBodies& bodies, double time) {
    if (!acts_at(time)) return;
    Body& body = bodies[static_cast<std::size_t>(poke_.body)];
    const Vector3 force = this->force(body.orientation);
    body.force += force;
    body.torque += torque(body.orientation);
    if (!poke_.point.isZero(0.0)) body.torque += (body.orientation * poke_.point).cross(force);
}

SomeBodies PokeForce::pushed_anew(double from, double until) const {
    if (acts_at(from) == acts_at(until)) return {};
    return {.some = {poke_.body}};
}

bool PokeForce::turns_unseen(int body) const {
    return body != poke_.body || (poke_.frame == Poke::Frame::world && poke_.point.isZero(0.0));
}

}  // namespace pushfactor::engine
