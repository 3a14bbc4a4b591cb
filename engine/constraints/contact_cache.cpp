#include "engine/constraints/contact_cache.h"

#include "engine/base/constants.h"

#include <algorithm>
#include <cassert>

namespace pushfactor::engine {

namespace {

constexpr std::size_t touches_of_a_part = 256;  // per thread task

}  // namespace

bool ContactCache::is_as_before(const Entry& entry, std::span<const collision::ContactPoint> points) const {
    return points.size() == static_cast<std::size_t>(entry.count) &&
           std::equal(points.begin(), points.end(), points_.begin() + static_cast<std::ptrdiff_t>(entry.first),
                      [](const auto& now, const auto& before) { return now.feature == before.feature; });
}

// Assigns each force once: first to points with the same feature, then to the closest remaining points, in
// ascending order of distance.
void ContactCache::hand_out(const Entry& entry, std::span<const collision::ContactPoint> points, double reach,
                            std::span<ContactForce> forces, Matched& matched) const {
    const std::span known(points_.data() + entry.first, static_cast<std::size_t>(entry.count));
    std::vector<char>&taken = matched.taken, &given = matched.given;
    taken.assign(known.size(), 0);
    given.assign(points.size(), 0);
    const auto give = [&](std::size_t point, std::size_t from) {
        forces[point] = known[from].force;
        given[point] = taken[from] = 1;
    };
    for (std::size_t p = 0; p < points.size(); ++p) {
        for (std::size_t k = 0; k < known.size() && !given[p]; ++k) {
            if (!taken[k] && known[k].feature == points[p].feature) give(p, k);
        }
    }
    for (;;) {
        double nearest = reach;
        std::size_t point = points.size(), from = 0;
        for (std::size_t p = 0; p < points.size(); ++p) {
            for (std::size_t k = 0; k < known.size() && !given[p]; ++k) {
                const double distance = (known[k].position - points[p].position).norm();
                if (taken[k] || !(distance < nearest)) continue;
                nearest = distance;
                point = p;
                from = k;
            }
        }
        if (point == points.size()) return;
        give(point, from);
    }
}

void ContactCache::recall(std::span<const collision::Touch> touches, std::vector<ContactForce>& forces,
                          Threads* threads) {
    const std::size_t before = forces.size();
    first_force_.resize(parts_of(threads, touches.size(), touches_of_a_part));
    std::size_t count = before;
    for (std::size_t k = 0; k < touches.size(); ++k) {
        if (k % touches_of_a_part == 0 && k / touches_of_a_part < first_force_.size()) {
            first_force_[k / touches_of_a_part] = count;
        }
        count += touches[k].points.size();
    }
    forces.resize(count);
    matched_.resize(std::max(matched_.size(), first_force_.size()));
    share_parts(threads, touches.size(), touches_of_a_part,
                [&](std::size_t part, std::size_t begin, std::size_t end) {
                    if (begin == end) return;
                    recall(touches.subspan(begin, end - begin), std::span(forces).subspan(first_force_[part]),
                           matched_[part]);
                });
}

// Writes the forces of a range of touches.
void ContactCache::recall(std::span<const collision::Touch> touches, std::span<ContactForce> forces,
                          Matched& matched) const {
    auto entry = std::lower_bound(entries_.begin(), entries_.end(), touches.front().pair,
                                  [](const Entry& a, const collision::Pair& pair) { return a.pair < pair; });
    for (const collision::Touch& touch : touches) {
        while (entry != entries_.end() && entry->pair < touch.pair) ++entry;
        const std::span<ContactForce> own = forces.first(touch.points.size());
        forces = forces.subspan(own.size());
        if (entry == entries_.end() || entry->pair != touch.pair) continue;
        if (is_as_before(*entry, touch.points)) {
            for (std::size_t i = 0; i < own.size(); ++i) own[i] = points_[entry->first + i].force;
        } else {
            hand_out(*entry, touch.points, constants::rows::same_point * touch.size, own, matched);
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

void ContactCache::store(std::span<const collision::Touch> touches, std::span<const ContactForce> forces,
                         Threads* threads) {
    entries_.resize(touches.size());
    points_.resize(forces.size());
    std::size_t count = 0;
    for (std::size_t k = 0; k < touches.size(); ++k) {
        const auto points = static_cast<int>(touches[k].points.size());
        entries_[k] = {touches[k].pair, count, points};
        count += touches[k].points.size();
    }
    share(threads, touches.size(), touches_of_a_part, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            const std::size_t first = entries_[k].first;
            for (std::size_t i = 0; i < touches[k].points.size(); ++i) {
                const collision::ContactPoint& point = touches[k].points[i];
                points_[first + i] = {point.feature, point.position, forces[first + i]};
            }
        }
    });
}

}  // namespace pushfactor::engine
