#include "engine/collision/pairs/separations.h"

#include <cmath>

namespace pushfactor::engine::collision {

Separations::Separations(const Box& a, const Pose& pose_a, const Box& b, const Pose& pose_b) {
    const Vector3 offset = pose_b.position - pose_a.position;
    const auto consider = [&](const Vector3& axis, int of_a, int of_b) {
        const double along = axis.dot(offset);
        const double reach = (pose_a.rotation.transpose() * axis).cwiseAbs().dot(a.half_size) +
                             (pose_b.rotation.transpose() * axis).cwiseAbs().dot(b.half_size);
        add({along < 0.0 ? Vector3(-axis) : axis, std::abs(along) - reach, of_a, of_b});
    };
    for (int k = 0; k < 3; ++k) {
        consider(pose_a.rotation.col(k), k, -1);
        consider(pose_b.rotation.col(k), -1, k);
    }
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            const Vector3 axis = pose_a.rotation.col(i).cross(pose_b.rotation.col(j));
            const double length = axis.norm();
            if (length > parallel_edges) consider(axis / length, i, j);
        }
    }
}

}  // namespace pushfactor::engine::collision
