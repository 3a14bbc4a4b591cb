#include "engine/constraints/contact_cache.h"

#include "engine/base/constants.h"

#include <algorithm>
#include <cassert>

namespace pushfactor::engine {

bool ContactCache::is_as_before(const Entry& entry, std::span<const collision::ContactPoint> points) const {
    return std::ranges::equal(points, of(entry), {}, &collision::ContactPoint::feature, &Point::feature);
}

// Assigns each force once: first to points with the same feature, then to the closest remaining points, in
// ascending order of distance.
void ContactCache::hand_out(const Entry& entry, std::span<const collision::ContactPoint> points, double reach,
                            std::span<ContactForce> forces) {
    const std::span<const Point> known = of(entry);
    taken_.assign(known.size(), 0);
    given_.assign(points.size(), 0);
    const auto give = [&](std::size_t point, std::size_t from) {
        forces[point] = known[from].force;
        given_[point] = taken_[from] = 1;
    };
    for (std::size_t p = 0; p < points.size(); ++p) {
        for (std::size_t k = 0; k < known.size() && !given_[p]; ++k) {
            if (!taken_[k] && known[k].feature == points[p].feature) give(p, k);
        }
    }
    for (;;) {
        double nearest = reach;
        std::size_t point = points.size(), from = 0;
        for (std::size_t p = 0; p < points.size(); ++p) {
            for (std::size_t k = 0; k < known.size() && !given_[p]; ++k) {
                const double distance = (known[k].position - points[p].position).norm();
                if (taken_[k] || !(distance < nearest)) continue;
                nearest = distance;
                point = p;
                from = k;
            }
        }
        if (point == points.size()) return;
        give(point, from);
    }
}

void ContactCache::recall(std::span<const collision::Touch> touches, std::vector<ContactForce>& forces) {
    auto entry = entries_.begin();
    for (const collision::Touch& touch : touches) {
        while (entry != entries_.end() && entry->pair < touch.pair) ++entry;
        forces.resize(forces.size() + touch.points.size());
        if (entry == entries_.end() || entry->pair != touch.pair) continue;
        const std::span<ContactForce> own = std::span(forces).last(touch.points.size());
        if (is_as_before(*entry, touch.points)) {
            for (std::size_t i = 0; i < own.size(); ++i) own[i] = points_[entry->first + i].force;
        } else {
            hand_out(*entry, touch.points, constants::rows::same_point * touch.size, own);
        }
    }
}

void ContactCache::add(const collision::Pair& pair, std::span<const Point> points) {
    assert(entries_.empty() || entries_.back().pair < pair);
    entries_.push_back({pair, points_.size(), static_cast<int>(points.size())});
    points_.insert(points_.end(), points.begin(), points.end());
}

void ContactCache::clear() {
    entries_.clear();
    points_.clear();
}

void ContactCache::store(const collision::Touch& touch, std::span<const ContactForce> forces) {
    entries_.push_back({touch.pair, points_.size(), static_cast<int>(touch.points.size())});
    for (std::size_t i = 0; i < forces.size(); ++i) {
        points_.push_back({touch.points[i].feature, touch.points[i].position, forces[i]});
    }
}

}  // namespace pushfactor::engine
