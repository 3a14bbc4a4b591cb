// The target of a row in a solve of small steps (small_steps.h): one formula for numbers and for lanes of vectors.
// Internal to the step.
#pragma once

#include "engine/base/constants.h"

namespace pushfactor::engine {

// What a solve of small steps aims at.
struct Aim {
    bool pushes = false;   // else the momenta are set
    double h = 0.0;        // s, of a small step
    double steps = 1.0;    // in the whole step
    double fastest = 0.0;  // m/s, push of one-sided rows
    double elapsed = 0.0;  // s, of the step
};

// Numbers of one row that holds a place, or in the lanes of a vector those of several.
template <typename Number>
struct Target {
    Number speed;  // m/s
    Number keeps;  // share of its force that a row does not give way to
};

// Of rows with this error [m] and the share of it that a step corrects; `open_side` as in SmallSteps::Holding,
// `most` the fastest push [m/s]; see small_steps.h.
template <typename Number>
[[gnu::always_inline]] inline Target<Number> target_of(const Aim& aim, const Number& error, const Number& beta,
                                                       const Number& open_side, const Number& most) {
    using constants::small_steps::stiffness;
    const Number none = error - error, to_zero = -error / aim.h;
    const auto is_open = open_side * error > 0.0;
    if (!aim.pushes) return {is_open ? to_zero : none, none + 1.0};
    const Number magnitude = error < 0.0 ? -error : error + 0.0;  // not -0, by which it divides
    const Number wanted = beta / aim.steps, at_most = most * aim.h / magnitude;
    const Number share = at_most < wanted ? at_most : wanted;
    return {is_open ? to_zero : -share * error / aim.h, stiffness / (stiffness + share)};
}

// What is left of the correction of a step `dt` after small steps of `h` [s].
struct Apart {
    double dt = 0.0, h = 0.0;
};

// Displacement [m] that a one-sided row wants at the end of a step that began with the error `before` and has moved
// it by `moved` [m]: what is left of the correction of its source, `correcting` [m/s], and no way into each other.
// `force` as y s [m/s]. All of these positive towards the open side.
template <typename Number>
[[gnu::always_inline]] inline void find_left(const Apart& step, const Number& before, const Number& moved,
                                             const Number& correcting, const Number& force, Number& left) {
    using constants::small_steps::stiffness;
    const Number error = before + moved, none = error - error, size = force < 0.0 ? -force : force;
    // By what its force compresses it, it would be compressed again, and what it carries would creep.
    const Number deep = -before - size * step.h / stiffness, all = step.dt * correcting;
    const Number most = none < deep ? deep : none, wanted = none < all ? all : none;
    const Number rest = (most < wanted ? most : wanted) - (none < moved ? moved : none);
    left = error > 0.0 ? -error : none < rest ? rest : none;
}

}  // namespace pushfactor::engine
