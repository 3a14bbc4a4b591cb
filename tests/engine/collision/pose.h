// Poses for collision tests.
#pragma once

#include "engine/collision/collider.h"

namespace pushfactor::tests {

inline engine::collision::Pose at(const engine::Vector3& position,
                                  const engine::Quaternion& rotation = engine::Quaternion::Identity()) {
    return {position, rotation.toRotationMatrix()};
}

}  // namespace pushfactor::tests
