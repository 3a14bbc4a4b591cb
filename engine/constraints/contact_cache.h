// Contact caching, paper section 6.2.3: the forces of the previous step as warm start of this one.
#pragma once

#include "engine/collision/detector.h"
#include "engine/constraints/constraint_row.h"

#include <algorithm>
#include <map>
#include <span>
#include <utility>
#include <vector>

namespace pushfactor::engine {

// Force at one contact point in both columns [N]. The friction part is a world-frame vector, because the
// tangents may turn from step to step.
struct ContactForce {
    Lambda normal;
    Vector3 friction_first = Vector3::Zero();
    Vector3 friction_last = Vector3::Zero();
};

class ContactCache {
  public:
    struct Point {
        // Not defaulted: a vector would zero-fill the object before its members are set.
        Point() {}  // NOLINT(modernize-use-equals-default)
        Point(std::uint32_t of, const Vector3& at, const ContactForce& with)
            : feature(of), position(at), force(with) {}

        std::uint32_t feature = 0;
        Vector3 position;  // m, world frame
        ContactForce force;
    };
    struct Entry {
        collision::Pair pair;
        std::size_t first = 0;  // into points()
        int count = 0;
    };

    // Appends the cached force of every point of `touches`, in ascending order of the pair; zero if nothing
    // matches. Points match by feature, otherwise by distance: the closest one within 2 % of the size. No force is
    // used twice.
    void recall(std::span<const collision::Touch> touches, std::vector<ContactForce>& forces);

    // Replace the cache, one touch after the other in ascending order of the pair. `forces`: one per point.
    void clear();
    void store(const collision::Touch& touch, std::span<const ContactForce> forces);

    // Stored entries, for saving and restoring a run: ascending pairs, and the points of all of them.
    std::span<const Entry> entries() const { return entries_; }
    std::span<const Point> points() const { return points_; }

    // Calls `visit(pair, points)` for the entries of two caches that have no pair in common, in ascending order.
    template <typename Visit>
    static void each_of_both(const ContactCache& a, const ContactCache& b, const Visit& visit) {
        for (auto p = a.entries_.begin(), q = b.entries_.begin(); p != a.entries_.end() || q != b.entries_.end();) {
            const bool of_a = q == b.entries_.end() || (p != a.entries_.end() && p->pair < q->pair);
            const Entry& entry = of_a ? *p++ : *q++;
            visit(entry.pair, (of_a ? a : b).of(entry));
        }
    }

    std::span<const Point> of(const Entry& entry) const {
        return std::span(points_).subspan(entry.first, static_cast<std::size_t>(entry.count));
    }

    // Appends an entry; its pair must be greater than all before.
    void add(const collision::Pair& pair, std::span<const Point> points);

  private:
    bool is_as_before(const Entry& entry, std::span<const collision::ContactPoint> points) const;
    void hand_out(const Entry& entry, std::span<const collision::ContactPoint> points, double reach,
                  std::span<ContactForce> forces);

    std::vector<Entry> entries_;  // ascending pairs
    std::vector<Point> points_;
    std::vector<char> taken_, given_;  // of the current touch: old forces that are used, new points that have one
};

// The forces between bodies at rest, by pair. To add and to take those of a collider costs the logarithm of all.
class RestingForces {
  public:
    void add(const collision::Pair& pair, std::span<const ContactCache::Point> points) {
        by_collider_[{pair.a, pair.b}].assign(points.begin(), points.end());
        by_collider_[{pair.b, pair.a}].clear();
    }

    // Removes the pairs of `colliders` that satisfy `belongs`, and returns them.
    template <typename Belongs>
    ContactCache take(std::span<const int> colliders, const Belongs& belongs) {
        std::map<collision::Pair, std::vector<ContactCache::Point>> taken;
        for (const int collider : colliders) {
            const auto begin = by_collider_.lower_bound({collider, 0});
            for (auto own = begin; own != by_collider_.end() && own->first.a == collider; ++own) {
                const collision::Pair pair = std::min(own->first, collision::Pair{own->first.b, collider});
                if (belongs(pair)) taken[pair];
            }
        }
        for (auto& [pair, points] : taken) {
            points = std::move(by_collider_[pair]);
            by_collider_.erase(pair);
            by_collider_.erase({pair.b, pair.a});
        }
        ContactCache all;
        for (const auto& [pair, points] : taken) all.add(pair, points);
        return all;
    }

    // Calls `visit(pair, points)` for each pair, ascending.
    template <typename Visit>
    void each(const Visit& visit) const {
        for (const auto& [pair, points] : by_collider_) {
            if (pair.a < pair.b) visit(pair, std::span(points));
        }
    }

  private:
    // Each pair twice: as it is, and turned around without points.
    std::map<collision::Pair, std::vector<ContactCache::Point>> by_collider_;
};

}  // namespace pushfactor::engine
