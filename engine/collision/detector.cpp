#include "engine/collision/detector.h"

#include "engine/collision/meeting.h"
#include "engine/collision/pairs/collide.h"

#include <algorithm>
#include <cmath>

namespace pushfactor::engine::collision {

namespace {

// Pairs per thread task.
constexpr std::size_t pairs_of_a_part = 64;

}  // namespace

void name_touch(const Pair& pair, const StepScene& scene, Touch& touch) {
    const Collider& a = scene.colliders[static_cast<std::size_t>(pair.a)];
    const Collider& b = scene.colliders[static_cast<std::size_t>(pair.b)];
    touch.pair = pair;
    touch.body_a = a.body;
    touch.body_b = b.body;
    const auto size = [&](const Collider& own) {
        return scene.bodies[static_cast<std::size_t>(own.body)].is_static() ? infinity : size_of(own.shape);
    };
    touch.size = std::min(size(a), size(b));
    touch.friction = std::sqrt(a.friction * b.friction);
    touch.restitution = std::max(a.restitution, b.restitution);
    if (scene.detection.materials) scene.detection.materials->put(a.material, b.material, touch);
}

bool find_touch(const Pair& pair, const StepScene& scene, Manifold& manifold, Touch& touch) {
    name_touch(pair, scene, touch);
    if (scene.motions) {
        if (!meet(scene, touch, manifold)) return false;
    } else {
        const auto &a = scene.colliders[static_cast<std::size_t>(pair.a)],
                   &b = scene.colliders[static_cast<std::size_t>(pair.b)];
        collide(a.shape, scene.poses[static_cast<std::size_t>(a.body)], b.shape,
                scene.poses[static_cast<std::size_t>(b.body)], scene.detection.margin * touch.size, manifold);
        if (manifold.count == 0) return false;
    }
    touch.normal = manifold.normal;
    touch.doubtful = manifold.other_gap + scene.detection.permitted * touch.size >= 0.0;
    // Those of the manifold, until it is used again.
    touch.points = manifold.points();
    return true;
}

void MaterialPairs::put(int a, int b, Touch& touch) const {
    if (a < 0 || b < 0) return;
    const Surface& surface = surfaces_[index(a, b)];
    if (surface.friction) touch.friction = *surface.friction;
    if (surface.restitution) touch.restitution = *surface.restitution;
}

bool MaterialPairs::any(std::optional<double> Surface::*what) const {
    return std::any_of(surfaces_.begin(), surfaces_.end(),
                       [what](const Surface& surface) { return (surface.*what).value_or(0.0) > 0.0; });
}

std::vector<Touch>& Detector::detect(std::span<const Collider> colliders, std::span<const Body> bodies,
                                     const Detection& detection, const StepMotions* motions) {
    const Awake all_colliders(colliders.size()), all_bodies(bodies.size());
    return detect(colliders, bodies, detection, motions,
                  {all_colliders, all_colliders.members(), all_bodies.members()});
}

std::vector<Touch>& Detector::detect(std::span<const Collider> colliders, std::span<const Body> bodies,
                                     const Detection& detection, const StepMotions* motions,
                                     const AwakeColliders& awake, Threads* threads) {
    poses_.resize(bodies.size());
    share_each(threads, awake.moved_bodies, bodies_of_a_part, [&](int body) {
        poses_[static_cast<std::size_t>(body)] = pose_of(bodies[static_cast<std::size_t>(body)]);
    });
    const StepScene scene{colliders, bodies, poses_, detection, motions};
    const std::span<const Pair> pairs = broad_phase_.find_pairs(
        colliders, bodies, poses_, detection.margin, motions, awake.colliders, awake.moved_colliders, threads);
    return search_.among(pairs, threads, [&scene](const Pair& pair, Manifold& manifold, Touch& touch) {
        return find_touch(pair, scene, manifold, touch);
    });
}

std::vector<Touch>& TouchSearch::among(std::span<const Pair> pairs, Threads* threads, const Find& find) {
    found_.resize(std::max(found_.size(), parts_of(threads, pairs.size(), pairs_of_a_part)));
    const std::size_t parts =
        share_parts(threads, pairs.size(), pairs_of_a_part, [&](std::size_t k, std::size_t begin, std::size_t end) {
            search(pairs.subspan(begin, end - begin), find, found_[k]);
        });
    touches_.clear();
    for (const Found& found : std::span(found_).first(parts)) {
        touches_.insert(touches_.end(), found.touches.begin(), found.touches.end());
    }
    return touches_;
}

void TouchSearch::search(std::span<const Pair> pairs, const Find& find, Found& found) {
    found.touches.clear();
    found.points.clear();
    Manifold manifold;
    for (const Pair& pair : pairs) {
        Touch& touch = found.touches.emplace_back();
        if (find(pair, manifold, touch)) {
            touch.points = manifold.points();
            found.points.insert(found.points.end(), touch.points.begin(), touch.points.end());
        } else {
            found.touches.pop_back();
        }
    }
    std::span<const ContactPoint> left = found.points;
    for (Touch& touch : found.touches) {
        touch.points = left.first(touch.points.size());
        left = left.subspan(touch.points.size());
    }
}

}  // namespace pushfactor::engine::collision
