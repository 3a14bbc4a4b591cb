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

// By which a wide box reaches farther, as a fraction of the size: some steps of a slow body.
constexpr double slack_share = 0.1;

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
    auto hash = static_cast<std::uint64_t>(cell.level);
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
        const auto body = static_cast<std::size_t>(collider.body);
        const Pose& pose = poses[body];
        if (std::holds_alternative<collision::Plane>(collider.shape)) {
            planes_.push_back({.point = pose.position, .up = pose.rotation.col(1), .collider = i});
            continue;
        }
        const double size = size_of(collider.shape);
        bounds_.push_back({.centre = pose.position,
                           .reach = reach_of(collider.shape, pose) + Vector3::Constant(margin * size),
                           .slack = slack_share * size,
                           .collider = i,
                           .body = collider.body,
                           .fixed = bodies[body].is_static()});
    }
}

namespace {

template <typename Box>
bool overlap(const Box& a, const Box& b) {
    const auto near = [&](int axis) {
        return std::abs(a.centre[axis] - b.centre[axis]) < a.reach[axis] + b.reach[axis];
    };
    return near(0) && near(1) && near(2);
}

// Whether some of the box may be below the plane.
template <typename Box, typename Plane>
bool reaches(const Box& box, const Plane& plane) {
    return !(plane.up.dot(box.centre - plane.point) >= plane.up.cwiseAbs().dot(box.reach));
}

}  // namespace

// Whether the candidates are still all that there can be.
bool BroadPhase::within_wide() const {
    const auto same_plane = [](const Plane& a, const Plane& b) {
        return a.collider == b.collider && a.point == b.point && a.up == b.up;
    };
    const auto holds = [](const Bounds& wide, const Bounds& box) {
        const auto along = [&](int axis) {
            return std::abs(box.centre[axis] - wide.centre[axis]) + box.reach[axis] <= wide.reach[axis];
        };
        return wide.collider == box.collider && wide.body == box.body && wide.fixed == box.fixed && along(0) &&
               along(1) && along(2);
    };
    return std::equal(wide_planes_.begin(), wide_planes_.end(), planes_.begin(), planes_.end(), same_plane) &&
           std::equal(wide_.begin(), wide_.end(), bounds_.begin(), bounds_.end(), holds);
}

void BroadPhase::find_candidates() {
    wide_ = bounds_;
    for (Bounds& box : wide_) box.reach += Vector3::Constant(box.slack);
    wide_planes_ = planes_;

    candidates_.clear();
    add_with_planes();
    if (wide_.size() <= few) {
        for (int i = 0; i < static_cast<int>(wide_.size()); ++i) {
            for (int j = 0; j < i; ++j) add_if_near(i, j);
        }
    } else {
        fill_grid();
        for (int i = 0; i < static_cast<int>(wide_.size()); ++i) add_with_neighbours(i);
    }
    std::sort(candidates_.begin(), candidates_.end(),
              [](const Candidate& a, const Candidate& b) { return a.pair < b.pair; });
}

void BroadPhase::fill_grid() {
    levels_.clear();
    heads_.assign(std::bit_ceil(2 * wide_.size() + 1), -1);
    next_.resize(wide_.size());
    cells_.resize(wide_.size());
    for (std::size_t i = 0; i < wide_.size(); ++i) {
        const int level = level_of(2.0 * wide_[i].reach.maxCoeff());
        if (std::find(levels_.begin(), levels_.end(), level) == levels_.end()) levels_.push_back(level);
        cells_[i] = cell_of(wide_[i].centre, level);
        int& head = heads_[bucket_of(cells_[i])];
        next_[i] = head;
        head = static_cast<int>(i);
    }
    std::sort(levels_.begin(), levels_.end());
}

void BroadPhase::add_with_planes() {
    for (int p = 0; p < static_cast<int>(wide_planes_.size()); ++p) {
        const Plane& plane = wide_planes_[static_cast<std::size_t>(p)];
        for (int i = 0; i < static_cast<int>(wide_.size()); ++i) {
            const Bounds& box = wide_[static_cast<std::size_t>(i)];
            if (box.fixed || !reaches(box, plane)) continue;
            const auto [a, b] = std::minmax(plane.collider, box.collider);
            candidates_.push_back({{a, b}, i, -1 - p});
        }
    }
}

void BroadPhase::add_if_near(int index, int other) {
    const Bounds& box = wide_[static_cast<std::size_t>(index)];
    const Bounds& near = wide_[static_cast<std::size_t>(other)];
    if (!overlap(box, near) || (box.fixed && near.fixed) || box.body == near.body) return;
    const auto [a, b] = std::minmax(box.collider, near.collider);
    candidates_.push_back({{a, b}, index, other});
}

void BroadPhase::add_with_cell(int index, const Cell& cell) {
    for (int i = heads_[bucket_of(cell)]; i >= 0; i = next_[static_cast<std::size_t>(i)]) {
        // Others may have come into the same bucket.
        if (cells_[static_cast<std::size_t>(i)] == cell) add_if_near(index, i);
    }
}

// Boxes no longer than a cell overlap only when their centres lie in the same or in adjacent cells, so it is enough
// to look around one's own centre on one's own level and on those with larger cells. Within a level each pair of
// cells is looked at from one side only, and each pair of boxes of a cell once.
void BroadPhase::add_with_neighbours(int index) {
    const Cell& own = cells_[static_cast<std::size_t>(index)];
    for (int i = next_[static_cast<std::size_t>(index)]; i >= 0; i = next_[static_cast<std::size_t>(i)]) {
        if (cells_[static_cast<std::size_t>(i)] == own) add_if_near(index, i);
    }
    for (const int level : levels_) {
        if (level < own.level) continue;
        const bool same = level == own.level;
        const Cell home = same ? own : cell_of(wide_[static_cast<std::size_t>(index)].centre, level);
        for (int k = same ? 14 : 0; k < 27; ++k) {
            add_with_cell(index, {level, home.x + k / 9 - 1, home.y + k / 3 % 3 - 1, home.z + k % 3 - 1});
        }
    }
}

std::span<const Pair> BroadPhase::find_pairs(std::span<const Collider> colliders, std::span<const Body> bodies,
                                             std::span<const Pose> poses, double margin) {
    bound(colliders, bodies, poses, margin);
    if (!within_wide()) find_candidates();
    pairs_.clear();
    for (const Candidate& candidate : candidates_) {
        const Bounds& box = bounds_[static_cast<std::size_t>(candidate.box)];
        const bool near = candidate.other >= 0
                              ? overlap(box, bounds_[static_cast<std::size_t>(candidate.other)])
                              : reaches(box, planes_[static_cast<std::size_t>(-1 - candidate.other)]);
        if (near) pairs_.push_back(candidate.pair);
    }
    return pairs_;
}

}  // namespace pushfactor::engine::collision
