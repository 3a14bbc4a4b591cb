#include "engine/collision/box_grid.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace pushfactor::engine::collision {

namespace {

// Level of the cells for boxes with this longest edge.
int level_of(double edge) {
    return std::isfinite(edge) && edge > 0.0 ? std::ilogb(edge) + 1 : 0;
}

}  // namespace

void BoxGrid::clear(std::size_t count) {
    levels_.clear();
    cells_.resize(count);
    held_.assign(count, 0);
    next_.resize(count);
    heads_.assign(std::bit_ceil(2 * count + 1), -1);
}

// Beyond 2^52 cells from the origin neighbours share a cell, which costs only time. Non-finite bodies get no
// pairs; the caller's check reports them.
BoxGrid::Cell BoxGrid::cell_of(const Vector3& point, int level) {
    const auto index = [level](double x) {
        constexpr double farthest = 4503599627370496.0;
        const double cell = std::floor(std::ldexp(x, -level));
        return std::isnan(cell) ? std::int64_t{0}
                                : static_cast<std::int64_t>(std::clamp(cell, -farthest, farthest));
    };
    return {level, index(point.x()), index(point.y()), index(point.z())};
}

std::size_t BoxGrid::bucket_of(const Cell& cell) const {
    auto hash = static_cast<std::uint64_t>(cell.level);
    for (const std::int64_t coordinate : {cell.x, cell.y, cell.z}) {
        hash = (hash ^ static_cast<std::uint64_t>(coordinate)) * 0x9e3779b97f4a7c15u;
        hash ^= hash >> 29;
    }
    return hash & (heads_.size() - 1);
}

BoxGrid::Level& BoxGrid::level_at(int level) {
    const auto found =
        std::lower_bound(levels_.begin(), levels_.end(), level, [](const Level& a, int b) { return a.level < b; });
    if (found != levels_.end() && found->level == level) return *found;
    return *levels_.insert(found, {level, 0, Vector3::Constant(infinity), Vector3::Constant(-infinity)});
}

void BoxGrid::insert(int index, const BoundingBox& box) {
    Level& level = level_at(level_of(2.0 * box.reach.maxCoeff()));
    ++level.count;
    for (int axis = 0; axis < 3; ++axis) {
        // With this order of arguments a NaN changes nothing.
        level.low[axis] = std::min(level.low[axis], box.centre[axis] - box.reach[axis]);
        level.high[axis] = std::max(level.high[axis], box.centre[axis] + box.reach[axis]);
    }
    cells_[at(index)] = cell_of(box.centre, level.level);
    held_[at(index)] = 1;
    int& head = heads_[bucket_of(cells_[at(index)])];
    next_[at(index)] = head;
    head = index;
}

void BoxGrid::remove(int index) {
    --level_at(cells_[at(index)].level).count;
    held_[at(index)] = 0;
    int* link = &heads_[bucket_of(cells_[at(index)])];
    while (*link != index) link = &next_[at(*link)];
    *link = next_[at(index)];
}

bool BoxGrid::may_overlap(const Level& level, const BoundingBox& box) const {
    return ((box.centre - box.reach).array() < level.high.array()).all() &&
           ((box.centre + box.reach).array() > level.low.array()).all();
}

// Whether visiting all cells of this lower level takes longer than visiting all boxes.
bool BoxGrid::covers_many_cells(const BoundingBox& box, int level) const {
    const auto cells = [&](int axis) { return 2.0 * std::ldexp(box.reach[axis], -level) + 2.0; };
    return !(cells(0) * cells(1) * cells(2) < 0.25 * static_cast<double>(cells_.size()));
}

}  // namespace pushfactor::engine::collision
