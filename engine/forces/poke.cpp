#include "engine/forces/poke.h"

namespace pushfactor::engine {

// The world's time is a sum of steps, so "from 2 s" must include a step that begins a rounding error before it.
double PokeForce::share_of(double from, double until) const {
    const double rounding = 1e-9 * until;
    const double begin = poke_.from <= from + rounding ? from : poke_.from;
    if (until <= from) return begin == from && from < poke_.until - rounding ? 1.0 : 0.0;
    const double end = poke_.until >= until - rounding ? until : poke_.until;
    return end > begin + rounding ? (end - begin) / (until - from) : 0.0;
}

void PokeForce::add_forces(const ForcedBodies& bodies, double from, double until) {
    const double share = share_of(from, until);
    if (!(share > 0.0)) return;
    Body& body = bodies[static_cast<std::size_t>(poke_.body)];
    const Vector3 force = share * this->force(body.orientation);
    body.force += force;
    body.torque += share * torque(body.orientation);
    if (!poke_.point.isZero(0.0)) body.torque += (body.orientation * poke_.point).cross(force);
}

SomeBodies PokeForce::pushed_anew(double from, double until) const {
    if (share_of(from, until) == share_of(until, until + (until - from))) return {};
    return {.some = {poke_.body}};
}

bool PokeForce::turns_unseen(int body) const {
    return body != poke_.body || (poke_.frame == Poke::Frame::world && poke_.point.isZero(0.0));
}

}  // namespace pushfactor::engine
