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

// Takes out those points beyond the margin that the step does not bring together.
void keep_closing_points(const Touch& touch, double margin, const Foresight& foresight, Manifold& manifold) {
    int kept = 0;
    for (int i = 0; i < manifold.count; ++i) {
        const ContactPoint& point = manifold.storage[static_cast<std::size_t>(i)];
        const bool closes =
            point.gap < margin ||
            point.gap < margin + foresight.closing(touch.body_a, touch.body_b, manifold.normal, point.position);
        if (closes) manifold.storage[static_cast<std::size_t>(kept++)] = point;
    }
    manifold.count = kept;
}

// Whether the step may close the gap between two boxes that are beside each other.
bool may_meet(const Pair& pair, std::span<const Collider> colliders, double margin, const Foresight& foresight,
              const Manifold& manifold) {
    if (std::isinf(manifold.separation)) return false;
    const Collider& a = colliders[static_cast<std::size_t>(pair.a)];
    const Collider& b = colliders[static_cast<std::size_t>(pair.b)];
    return manifold.separation < margin + foresight.most_closing(a, b, manifold.normal);
}

}  // namespace

void name_pair(const Pair& pair, std::span<const Collider> colliders, std::span<const Body> bodies, Touch& touch) {
    const Collider& a = colliders[static_cast<std::size_t>(pair.a)];
    const Collider& b = colliders[static_cast<std::size_t>(pair.b)];
    touch.pair = pair;
    touch.body_a = a.body;
    touch.body_b = b.body;
    touch.size =
        size_of_pair(a, bodies[static_cast<std::size_t>(a.body)], b, bodies[static_cast<std::size_t>(b.body)]);
}

void combine_surfaces(std::span<const Collider> colliders, Touch& touch) {
    const Collider& a = colliders[static_cast<std::size_t>(touch.pair.a)];
    const Collider& b = colliders[static_cast<std::size_t>(touch.pair.b)];
    touch.friction = std::sqrt(a.friction * b.friction);
    touch.restitution = std::max(a.restitution, b.restitution);
}

std::vector<Touch>& Detector::detect(std::span<const Collider> colliders, std::span<const Body> bodies,
                                     const Detection& detection, const Foresight* foresight) {
    const Awake all_colliders(colliders.size()), all_bodies(bodies.size());
    return detect(colliders, bodies, detection, foresight,
                  {all_colliders, all_colliders.members(), all_bodies.members()});
}

std::vector<Touch>& Detector::detect(std::span<const Collider> colliders, std::span<const Body> bodies,
                                     const Detection& detection, const Foresight* foresight,
                                     const AwakeColliders& awake) {
    poses_.resize(bodies.size());
    for (const int body : awake.moved_bodies) {
        poses_[static_cast<std::size_t>(body)] = pose_of(bodies[static_cast<std::size_t>(body)]);
    }

    touches_.clear();
    points_.clear();
    beside_.clear();
    for (const Pair& pair : broad_phase_.find_pairs(colliders, bodies, poses_, detection.margin, foresight,
                                                    awake.colliders, awake.moved_colliders)) {
        Touch& touch = touches_.emplace_back();
        name_pair(pair, colliders, bodies, touch);
        const Pose& pose_a = poses_[static_cast<std::size_t>(touch.body_a)];
        const Pose& pose_b = poses_[static_cast<std::size_t>(touch.body_b)];
        combine_surfaces(colliders, touch);
        const double margin = detection.margin * touch.size;
        const bool foreseen = foresight && touch.restitution <= 0.0;
        collide(colliders[static_cast<std::size_t>(pair.a)].shape, pose_a,
                colliders[static_cast<std::size_t>(pair.b)].shape, pose_b,
                foreseen ? margin + foresight->path(pair.a) + foresight->path(pair.b) : margin, manifold_);
        if (foreseen) keep_closing_points(touch, margin, *foresight, manifold_);
        if (manifold_.count == 0) {
            if (foreseen && may_meet(pair, colliders, margin, *foresight, manifold_)) beside_.push_back(pair);
            touches_.pop_back();
            continue;
        }
        if (detection.reduce_to_four_points) reduce_to_four(manifold_, pose_a.rotation);
        touch.normal = manifold_.normal;
        touch.doubtful = manifold_.other_gap + detection.permitted * touch.size >= 0.0;
        touch.points = manifold_.points();  // as many; where they are is said below, when all have been found
        points_.insert(points_.end(), touch.points.begin(), touch.points.end());
    }
    std::span<const ContactPoint> left = points_;
    for (Touch& touch : touches_) {
        touch.points = left.first(touch.points.size());
        left = left.subspan(touch.points.size());
    }
    return touches_;
}

}  // namespace pushfactor::engine::collision
