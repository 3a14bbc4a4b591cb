// The push factor, paper sections 5.1, 5.2 and 8.1.
//
// Symbols: v push factor [m/s], the target velocity of a row along its axis; beta [1], the share of a violation
// corrected per step (called k in sections 8 and 10); dt time step [s].
#pragma once

#include "engine/base/math.h"

#include <algorithm>

namespace pushfactor::engine {

// The two parts of v. `lasting` stays in the momenta (restitution, motors, and the correction of the original
// method); `correcting` moves the bodies in this step only (8.1).
struct PushFactor {
    double correcting = 0.0;  // m/s
    double lasting = 0.0;     // m/s
};

enum class PushKind {
    none,          // violations are not corrected
    persistent,    // the original method: the correction becomes momentum
    single_frame,  // section 8.1: the correction moves the bodies and leaves no momentum
    curve,         // of bars and joints: what turning leaves becomes momentum, everything else is single-frame
};

// How a kind of constraint corrects its violations.
struct Correction {
    PushKind kind = PushKind::single_frame;
    double beta = 0.2;  // 0..1
    // m/s, > 0: limit on the correction speed, for any depth.
    double max_speed = infinity;
};

// 5.2.3, 5.3.1: `distance` [m] is the correction along the axis of the row, made in one step if beta is 1.
inline PushFactor correct(const Correction& correction, double distance, double dt) {
    const double wanted = correction.beta * distance / dt;
    const double speed = std::clamp(wanted, -correction.max_speed, correction.max_speed);
    switch (correction.kind) {
        case PushKind::persistent:
            return {.correcting = 0.0, .lasting = speed};
        case PushKind::single_frame:
        case PushKind::curve:
            return {.correcting = speed, .lasting = 0.0};
        case PushKind::none:
            break;
    }
    return {};
}

}  // namespace pushfactor::engine
