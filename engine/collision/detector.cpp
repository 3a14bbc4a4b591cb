#include "engine/collision/detector.h"

#include "engine/collision/pair_table.h"

#include <algorithm>
#include <cmath>

namespace pushfactor::engine::collision {

namespace {

double size_of_pair(const Collider& a, const Body& body_a, const Collider& b, const Body& body_b) {
    const double size_a = body_a.is_static() ? std::numeric_limits<double>::infinity() : size_of(a.shape);
    const double size_b = body_b.is_static() ? std::numeric_limits<double>::infinity() : size_of(b.shape);
    return std::min(size_a, size_b);
}

}  // namespace

std::span<const Touch> Detector::detect(std::span<const Collider> colliders, std::span<const Body> bodies,
                                        const Detection& detection) {
    poses_.clear();
    for (const Body& body : bodies) poses_.push_back(pose_of(body));

    touches_.clear();
    for (const Pair& pair : broad_phase_.find_pairs(colliders, bodies, poses_, detection.margin)) {
        const Collider& a = colliders[static_cast<std::size_t>(pair.a)];
        const Collider& b = colliders[static_cast<std::size_t>(pair.b)];
        const auto body_a = static_cast<std::size_t>(a.body);
        const auto body_b = static_cast<std::size_t>(b.body);

        Touch& touch = touches_.emplace_back();
        touch.pair = pair;
        touch.body_a = a.body;
        touch.body_b = b.body;
        touch.size = size_of_pair(a, bodies[body_a], b, bodies[body_b]);
        touch.friction = std::sqrt(a.friction * b.friction);
        touch.restitution = std::max(a.restitution, b.restitution);
        collide(a.shape, poses_[body_a], b.shape, poses_[body_b], detection.margin * touch.size, touch.manifold);
        if (detection.reduce_to_four_points) reduce_to_four(touch.manifold, poses_[body_a].rotation);
        if (touch.manifold.count == 0) touches_.pop_back();
    }
    return touches_;
}

}  // namespace pushfactor::engine::collision
