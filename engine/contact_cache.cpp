#include "engine/contact_cache.h"

#include <algorithm>
#include <cassert>

namespace pushfactor::engine {

namespace {

constexpr double position_tolerance = 0.02;  // of the size of the pair

}  // namespace

bool ContactCache::is_as_before(const Entry& entry, std::span<const collision::ContactPoint> points) const {
    return points.size() == static_cast<std::size_t>(entry.count) &&
           std::equal(points.begin(), points.end(), points_.begin() + static_cast<std::ptrdiff_t>(entry.first),
                      [](const auto& now, const auto& before) { return now.feature == before.feature; });
}

// Each force once: first to the points of the same feature, then to the nearest of the others, pair by pair in
// ascending order of their distances.
void ContactCache::hand_out(const Entry& entry, std::span<const collision::ContactPoint> points, double reach,
                            std::span<ContactForce> forces) {
    const std::span known(points_.data() + entry.first, static_cast<std::size_t>(entry.count));
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
        const bool known = entry != entries_.end() && entry->pair == touch.pair;
        if (known && is_as_before(*entry, touch.points)) {
            for (std::size_t i = 0; i < touch.points.size(); ++i) forces.push_back(points_[entry->first + i].force);
            continue;
        }
        const std::size_t first = forces.size();
        forces.resize(first + touch.points.size());
        if (known) {
            hand_out(*entry, touch.points, position_tolerance * touch.size, std::span(forces).subspan(first));
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
