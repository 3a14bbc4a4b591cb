// The half of j_c that belongs to one body, for every row that acts at a point (paper 5.2.1, 5.3, 5.4).
#pragma once

#include "engine/body.h"

namespace pushfactor::engine {

// [d, r x d] for `direction` d [1] at `point` [m], world frame, r the offset from the centre of mass. Zero for a
// static body: the simplification at the end of 5.3.
inline Vector6 point_axis(const Body& body, const Vector3& point, const Vector3& direction) {
    Vector6 axis = Vector6::Zero();
    if (!body.is_static()) axis << direction, (point - body.position).cross(direction);
    return axis;
}

}  // namespace pushfactor::engine
