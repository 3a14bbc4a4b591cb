#include "engine/collision/broad_phase.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace pushfactor::engine::collision {

namespace {

const Collider& at(std::span<const Collider> colliders, int index) {
    return colliders[static_cast<std::size_t>(index)];
}

// Half the edges of the box around a finite shape, world axes.
Vector3 reach_of(const Shape& shape, const Pose& pose) {
    if (const auto* sphere = std::get_if<Sphere>(&shape)) return Vector3::Constant(sphere->radius);
    return pose.rotation.cwiseAbs() * std::get<Box>(shape).half_size;
}

// So many are compared each with each in less time than a grid takes to fill and search.
constexpr std::size_t few = 48;

// Of the cells that hold a box with this longest edge.
int level_of(double edge) {
    return std::isfinite(edge) && edge > 0.0 ? std::ilogb(edge) + 1 : 0;
}

}  // namespace

// Beyond 2^52 cells from the origin neighbours are not told apart; they share a cell then, which costs time only.
// What is not finite is not found by anybody: the step that made it is reported by whoever looks at the state.
BroadPhase::Cell BroadPhase::cell_of(const Vector3& centre, int level) {
    const auto index = [level](double x) {
        constexpr double farthest = 4503599627370496.0;
        const double cell = std::floor(std::ldexp(x, -level));
        return std::isnan(cell) ? std::int64_t{0}
                                : static_cast<std::int64_t>(std::clamp(cell, -farthest, farthest));
    };
    return {level, index(centre.x()), index(centre.y()), index(centre.z())};
}

std::size_t BroadPhase::bucket_of(const Cell& cell) const {
    std::uint64_t hash = static_cast<std::uint64_t>(cell.level);
    for (const std::int64_t coordinate : {cell.x, cell.y, cell.z}) {
        hash = (hash ^ static_cast<std::uint64_t>(coordinate)) * 0x9e3779b97f4a7c15u;
        hash ^= hash >> 29;
    }
    return hash & (heads_.size() - 1);
}

void BroadPhase::bound(std::span<const Collider> colliders, std::span<const Body> bodies,
                       std::span<const Pose> poses, double margin) {
    bounds_.clear();
    planes_.clear();
    for (int i = 0; i < static_cast<int>(colliders.size()); ++i) {
        const Collider& collider = at(colliders, i);
        if (std::holds_alternative<Plane>(collider.shape)) {
            planes_.push_back(i);
            continue;
        }
        const auto body = static_cast<std::size_t>(collider.body);
        const Vector3& centre = poses[body].position;
        const Vector3 reach =
            reach_of(collider.shape, poses[body]) + Vector3::Constant(margin * size_of(collider.shape));
        bounds_.push_back({.low = centre - reach,
                           .high = centre + reach,
                           .collider = i,
                           .body = collider.body,
                           .fixed = bodies[body].is_static(),
                           .cell = {}});
    }
}

void BroadPhase::fill_grid() {
    levels_.clear();
    heads_.assign(std::bit_ceil(2 * bounds_.size() + 1), -1);
    next_.resize(bounds_.size());
    for (std::size_t i = 0; i < bounds_.size(); ++i) {
        Bounds& box = bounds_[i];
        const int level = level_of((box.high - box.low).maxCoeff());
        if (std::find(levels_.begin(), levels_.end(), level) == levels_.end()) levels_.push_back(level);
        box.cell = cell_of(0.5 * (box.low + box.high), level);
        int& head = heads_[bucket_of(box.cell)];
        next_[i] = head;
        head = static_cast<int>(i);
    }
    std::sort(levels_.begin(), levels_.end());
}

void BroadPhase::pair_with_planes(std::span<const Collider> colliders, std::span<const Pose> poses) {
    for (const int plane : planes_) {
        const Pose& pose = poses[static_cast<std::size_t>(at(colliders, plane).body)];
        const Vector3 up = pose.rotation.col(1);
        for (const Bounds& box : bounds_) {
            if (box.fixed) continue;
            const Vector3 centre = 0.5 * (box.low + box.high);
            const double reach = up.cwiseAbs().dot(0.5 * (box.high - box.low));
            if (up.dot(centre - pose.position) >= reach) continue;
            pairs_.push_back({std::min(plane, box.collider), std::max(plane, box.collider)});
        }
    }
}

void BroadPhase::pair_with_cell(int index, const Cell& cell) {
    const Bounds& box = bounds_[static_cast<std::size_t>(index)];
    for (int i = heads_[bucket_of(cell)]; i >= 0; i = next_[static_cast<std::size_t>(i)]) {
        const Bounds& other = bounds_[static_cast<std::size_t>(i)];
        if (other.cell != cell) continue;  // another cell of the same bucket
        // Within a level each pair is met from both sides.
        if (cell.level == box.cell.level && i <= index) continue;
        pair_if_near(box, other);
    }
}

void BroadPhase::pair_if_near(const Bounds& box, const Bounds& other) {
    for (int axis = 0; axis < 3; ++axis) {
        if (!(box.low[axis] < other.high[axis] && other.low[axis] < box.high[axis])) return;
    }
    if ((box.fixed && other.fixed) || box.body == other.body) return;
    pairs_.push_back({std::min(box.collider, other.collider), std::max(box.collider, other.collider)});
}

// Boxes no longer than a cell overlap only when their centres lie in the same or in adjacent cells, so it is enough
// to look around one's own centre on one's own level and on those with larger cells.
void BroadPhase::pair_with_neighbours(int index) {
    const Bounds& box = bounds_[static_cast<std::size_t>(index)];
    const Vector3 centre = 0.5 * (box.low + box.high);
    for (const int level : levels_) {
        if (level < box.cell.level) continue;
        const Cell home = level == box.cell.level ? box.cell : cell_of(centre, level);
        for (std::int64_t x = home.x - 1; x <= home.x + 1; ++x) {
            for (std::int64_t y = home.y - 1; y <= home.y + 1; ++y) {
                for (std::int64_t z = home.z - 1; z <= home.z + 1; ++z) {
                    pair_with_cell(index, {level, x, y, z});
                }
            }
        }
    }
}

std::span<const Pair> BroadPhase::find_pairs(std::span<const Collider> colliders, std::span<const Body> bodies,
                                             std::span<const Pose> poses, double margin) {
    pairs_.clear();
    bound(colliders, bodies, poses, margin);
    pair_with_planes(colliders, poses);
    if (bounds_.size() <= few) {
        for (std::size_t i = 0; i < bounds_.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j) pair_if_near(bounds_[i], bounds_[j]);
        }
    } else {
        fill_grid();
        for (int i = 0; i < static_cast<int>(bounds_.size()); ++i) pair_with_neighbours(i);
    }
    std::sort(pairs_.begin(), pairs_.end());
    return pairs_;
}

}  // namespace pushfactor::engine::collision
