#include "engine/contact_cache.h"

#include <cassert>

namespace pushfactor::engine {

namespace {

constexpr double position_tolerance = 0.02;  // of the size of the pair

}  // namespace

const ContactForce* ContactCache::find(const Entry& entry, const collision::ContactPoint& point,
                                       double reach) const {
    const std::span candidates(points_.data() + entry.first, static_cast<std::size_t>(entry.count));
    for (const Point& candidate : candidates) {
        if (candidate.feature == point.feature) return &candidate.force;
    }
    const Point* nearest = nullptr;
    double nearest_distance = reach;
    for (const Point& candidate : candidates) {
        const double distance = (candidate.position - point.position).norm();
        if (distance < nearest_distance) {
            nearest = &candidate;
            nearest_distance = distance;
        }
    }
    return nearest ? &nearest->force : nullptr;
}

void ContactCache::recall(std::span<const collision::Touch> touches, std::vector<ContactForce>& forces) const {
    auto entry = entries_.begin();
    for (const collision::Touch& touch : touches) {
        while (entry != entries_.end() && entry->pair < touch.pair) ++entry;
        const bool known = entry != entries_.end() && entry->pair == touch.pair;
        for (const collision::ContactPoint& point : touch.points) {
            const ContactForce* force = known ? find(*entry, point, position_tolerance * touch.size) : nullptr;
            forces.push_back(force ? *force : ContactForce{});
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

void ContactCache::store(std::span<const collision::Touch> touches, std::span<const ContactForce> forces) {
    clear();
    for (const collision::Touch& touch : touches) {
        store(touch, forces.first(touch.points.size()));
        forces = forces.subspan(touch.points.size());
    }
}

}  // namespace pushfactor::engine
