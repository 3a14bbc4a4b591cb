#include "engine/collision/broad_phase.h"

#include <algorithm>

namespace pushfactor::engine::collision {

namespace {

const Body& body_of(const Collider& collider, std::span<const Body> bodies) {
    return bodies[static_cast<std::size_t>(collider.body)];
}

const Collider& at(std::span<const Collider> colliders, int index) {
    return colliders[static_cast<std::size_t>(index)];
}

bool may_restrict(const Collider& a, const Collider& b, std::span<const Body> bodies) {
    return a.body != b.body && !(body_of(a, bodies).is_static() && body_of(b, bodies).is_static());
}

}  // namespace

void BroadPhase::bound(std::span<const Collider> colliders, std::span<const Body> bodies, double margin) {
    bounds_.clear();
    planes_.clear();
    for (int i = 0; i < static_cast<int>(colliders.size()); ++i) {
        const Collider& collider = at(colliders, i);
        const auto* box = std::get_if<Box>(&collider.shape);
        if (!box) {
            planes_.push_back(i);
            continue;
        }
        const Pose pose = pose_of(body_of(collider, bodies));
        const Vector3 reach =
            pose.rotation.cwiseAbs() * box->half_size + Vector3::Constant(margin * size_of(collider.shape));
        bounds_.push_back({pose.position - reach, pose.position + reach, i});
    }
}

void BroadPhase::pair_with_planes(std::span<const Collider> colliders, std::span<const Body> bodies) {
    for (const int plane : planes_) {
        const Body& body = body_of(at(colliders, plane), bodies);
        const Vector3 up = body.orientation * Vector3::UnitY();
        for (const Bounds& box : bounds_) {
            const Vector3 centre = 0.5 * (box.low + box.high);
            const double reach = up.cwiseAbs().dot(0.5 * (box.high - box.low));
            if (up.dot(centre - body.position) >= reach) continue;
            if (may_restrict(at(colliders, plane), at(colliders, box.collider), bodies)) {
                pairs_.push_back({std::min(plane, box.collider), std::max(plane, box.collider)});
            }
        }
    }
}

void BroadPhase::sweep(std::span<const Collider> colliders, std::span<const Body> bodies) {
    if (bounds_.empty()) return;
    Vector3 low = bounds_.front().low;
    Vector3 high = low;
    for (const Bounds& box : bounds_) {
        low = low.cwiseMin(box.low);
        high = high.cwiseMax(box.low);
    }
    int axis = 0;
    (high - low).maxCoeff(&axis);

    std::sort(bounds_.begin(), bounds_.end(), [axis](const Bounds& p, const Bounds& q) {
        return p.low[axis] != q.low[axis] ? p.low[axis] < q.low[axis] : p.collider < q.collider;
    });
    for (std::size_t i = 0; i < bounds_.size(); ++i) {
        for (std::size_t j = i + 1; j < bounds_.size() && bounds_[j].low[axis] < bounds_[i].high[axis]; ++j) {
            const bool overlap = (bounds_[i].low.array() < bounds_[j].high.array()).all() &&
                                 (bounds_[j].low.array() < bounds_[i].high.array()).all();
            const auto [a, b] = std::minmax(bounds_[i].collider, bounds_[j].collider);
            if (overlap && may_restrict(at(colliders, a), at(colliders, b), bodies)) pairs_.push_back({a, b});
        }
    }
}

std::span<const Pair> BroadPhase::find_pairs(std::span<const Collider> colliders, std::span<const Body> bodies,
                                             double margin) {
    pairs_.clear();
    bound(colliders, bodies, margin);
    pair_with_planes(colliders, bodies);
    sweep(colliders, bodies);
    std::sort(pairs_.begin(), pairs_.end());
    return pairs_;
}

}  // namespace pushfactor::engine::collision
