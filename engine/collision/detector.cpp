#include "engine/collision/detector.h"

#include "engine/collision/pairs/pair_table.h"

#include <algorithm>
#include <cmath>

namespace pushfactor::engine::collision {

namespace {

double size_of_pair(const Collider& a, const Body& body_a, const Collider& b, const Body& body_b) {
    const double size_a = body_a.is_static() ? infinity : size_of(a.shape);
    const double size_b = body_b.is_static() ? infinity : size_of(b.shape);
    return std::min(size_a, size_b);
}

// Work items per thread task.
constexpr std::size_t bodies_of_a_part = 250, pairs_of_a_part = 64;

// Removes the points beyond the margin that the step does not close.
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

// Whether the step may close the gap between two boxes beside each other.
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

void MaterialPairs::put(int a, int b, Touch& touch) const {
    if (a < 0 || b < 0) return;
    const Surface& surface = surfaces_[index(a, b)];
    if (surface.friction) touch.friction = *surface.friction;
    if (surface.restitution) touch.restitution = *surface.restitution;
}

bool MaterialPairs::any_friction() const {
    return std::any_of(surfaces_.begin(), surfaces_.end(),
                       [](const Surface& surface) { return surface.friction.value_or(0.0) > 0.0; });
}

bool MaterialPairs::bounces(int material) const {
    if (material < 0) return false;
    const auto row = std::span(surfaces_).subspan(index(material, 0), materials_);
    return std::any_of(row.begin(), row.end(),
                       [](const Surface& surface) { return surface.restitution.value_or(0.0) > 0.0; });
}

bool MaterialPairs::any_bounces() const {
    return std::any_of(surfaces_.begin(), surfaces_.end(),
                       [](const Surface& surface) { return surface.restitution.value_or(0.0) > 0.0; });
}

void combine_surfaces(std::span<const Collider> colliders, const MaterialPairs* materials, Touch& touch) {
    const Collider& a = colliders[static_cast<std::size_t>(touch.pair.a)];
    const Collider& b = colliders[static_cast<std::size_t>(touch.pair.b)];
    touch.friction = std::sqrt(a.friction * b.friction);
    touch.restitution = std::max(a.restitution, b.restitution);
    if (materials) materials->put(a.material, b.material, touch);
}

std::vector<Touch>& Detector::detect(std::span<const Collider> colliders, std::span<const Body> bodies,
                                     const Detection& detection, const Foresight* foresight) {
    const Awake all_colliders(colliders.size()), all_bodies(bodies.size());
    return detect(colliders, bodies, detection, foresight,
                  {all_colliders, all_colliders.members(), all_bodies.members()});
}

std::vector<Touch>& Detector::detect(std::span<const Collider> colliders, std::span<const Body> bodies,
                                     const Detection& detection, const Foresight* foresight,
                                     const AwakeColliders& awake, Threads* threads) {
    poses_.resize(bodies.size());
    share(threads, awake.moved_bodies.size(), bodies_of_a_part, [&](std::size_t begin, std::size_t end) {
        for (const int body : awake.moved_bodies.subspan(begin, end - begin)) {
            poses_[static_cast<std::size_t>(body)] = pose_of(bodies[static_cast<std::size_t>(body)]);
        }
    });
    const Scene scene{colliders, bodies, detection, foresight};
    const std::span<const Pair> pairs = broad_phase_.find_pairs(
        colliders, bodies, poses_, detection.margin, foresight, awake.colliders, awake.moved_colliders, threads);
    found_.resize(std::max(found_.size(), parts_of(threads, pairs.size(), pairs_of_a_part)));
    const std::size_t parts =
        share_parts(threads, pairs.size(), pairs_of_a_part, [&](std::size_t k, std::size_t begin, std::size_t end) {
            find(scene, pairs.subspan(begin, end - begin), found_[k]);
        });
    put_together(threads, parts);
    return touches_;
}

void Detector::find(const Scene& scene, std::span<const Pair> pairs, Found& found) const {
    const std::span<const Collider> colliders = scene.colliders;
    const Foresight* const foresight = scene.foresight;
    Manifold& manifold = found.manifold;
    found.touches.clear();
    found.points.clear();
    found.beside.clear();
    for (const Pair& pair : pairs) {
        Touch& touch = found.touches.emplace_back();
        name_pair(pair, colliders, scene.bodies, touch);
        const Pose& pose_a = poses_[static_cast<std::size_t>(touch.body_a)];
        const Pose& pose_b = poses_[static_cast<std::size_t>(touch.body_b)];
        combine_surfaces(colliders, scene.detection.materials, touch);
        const double margin = scene.detection.margin * touch.size;
        const bool foreseen = foresight && touch.restitution <= 0.0;
        collide(colliders[static_cast<std::size_t>(pair.a)].shape, pose_a,
                colliders[static_cast<std::size_t>(pair.b)].shape, pose_b,
                foreseen ? margin + foresight->path(pair.a) + foresight->path(pair.b) : margin, manifold);
        if (foreseen) keep_closing_points(touch, margin, *foresight, manifold);
        if (manifold.count == 0) {
            if (foreseen && may_meet(pair, colliders, margin, *foresight, manifold)) found.beside.push_back(pair);
            found.touches.pop_back();
            continue;
        }
        if (scene.detection.reduce_to_four_points) reduce_to_four(manifold, pose_a.rotation);
        touch.normal = manifold.normal;
        touch.doubtful = manifold.other_gap + scene.detection.permitted * touch.size >= 0.0;
        // Only the count is valid here; put_together() sets the spans, once points_ no longer grows.
        touch.points = manifold.points();
        found.points.insert(found.points.end(), touch.points.begin(), touch.points.end());
    }
}

// Merges the first `parts` results in order.
void Detector::put_together(Threads* threads, std::size_t parts) {
    std::size_t touches = 0, points = 0;
    beside_.clear();
    for (Found& found : std::span(found_).first(parts)) {
        found.first_touch = touches;
        found.first_point = points;
        touches += found.touches.size();
        points += found.points.size();
        beside_.insert(beside_.end(), found.beside.begin(), found.beside.end());
    }
    if (parts == 1) {
        touches_.swap(found_.front().touches);
        points_.swap(found_.front().points);
    } else {
        touches_.resize(touches);
        points_.resize(points);
    }
    share(parts > 1 ? threads : nullptr, parts, 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            const Found& found = found_[k];
            if (parts > 1) {
                std::copy(found.touches.begin(), found.touches.end(),
                          touches_.begin() + static_cast<std::ptrdiff_t>(found.first_touch));
                std::copy(found.points.begin(), found.points.end(),
                          points_.begin() + static_cast<std::ptrdiff_t>(found.first_point));
            }
            const std::size_t count = parts > 1 ? found.touches.size() : touches;
            std::span<const ContactPoint> left = std::span(points_).subspan(found.first_point);
            for (Touch& touch : std::span(touches_).subspan(found.first_touch, count)) {
                touch.points = left.first(touch.points.size());
                left = left.subspan(touch.points.size());
            }
        }
    });
}

}  // namespace pushfactor::engine::collision
