#include "engine/collision/broad_phase.h"

#include <algorithm>
#include <cmath>

namespace pushfactor::engine::collision {

namespace {

const Collider& at(std::span<const Collider> colliders, int index) {
    return colliders[static_cast<std::size_t>(index)];
}

// Up to this many boxes all pairs are tested: faster than filling and searching a grid.
constexpr std::size_t few = 96;

// Work items per thread task.
constexpr std::size_t boxes_of_a_part = 250, left_of_a_part = 50, candidates_of_a_part = 2000;

// Share of boxes that have left their wide boxes above which all candidates are found again.
constexpr double most_left = 0.5;

// Extra reach of a wide box as a fraction of the size: some steps of a slow body.
constexpr double slack_share = 0.1;

// Whether part of the box may be below the plane.
template <typename Plane>
bool reaches(const BoundingBox& box, const Plane& plane) {
    return !(plane.up.dot(box.centre - plane.point) >= plane.up.cwiseAbs().dot(box.reach));
}

// Limit on how much wider than needed a wide box may be: one made for a fast body is too wide once it has come
// to rest.
constexpr double far_too_wide = 3.0;

// Whether the wide box still encloses `box` and is not far too wide for it; `slack` [m] is its extra reach.
bool holds(const BoundingBox& wide, const BoundingBox& box, double slack) {
    const auto along = [&](int axis) {
        return std::abs(box.centre[axis] - wide.centre[axis]) + box.reach[axis] <= wide.reach[axis] &&
               wide.reach[axis] <= far_too_wide * (box.reach[axis] + slack);
    };
    return along(0) && along(1) && along(2);
}

}  // namespace

BoundingBox swept_box(const Shape& shape, const Pose& pose, const Motion& motion, double dt, double room) {
    const double radius = std::sqrt(squared_turning_radius(shape));
    const Vector3 path = dt * motion.velocity;
    Vector3 reach = half_extents(shape, pose.rotation);
    // Turning moves no point by more than its arc, nor out of the ball that the shape turns in.
    const double turned = dt * motion.angular_velocity.norm() * radius;
    if (turned > 0.0) reach = (reach.array() + turned).cwiseMin(std::max(radius, reach.maxCoeff()));
    return {pose.position + 0.5 * path, reach + 0.5 * path.cwiseAbs() + Vector3::Constant(room)};
}

PairFilter::PairFilter(std::vector<int> groups, std::vector<Pair> pairs)
    : groups_(std::move(groups)), pairs_(std::move(pairs)) {
    for (Pair& pair : pairs_) pair = {std::min(pair.a, pair.b), std::max(pair.a, pair.b)};
    std::sort(pairs_.begin(), pairs_.end());
}

bool PairFilter::leaves_out(const Pair& pair) const {
    if (!groups_.empty()) {
        const int group = groups_[static_cast<std::size_t>(pair.a)];
        if (group >= 0 && group == groups_[static_cast<std::size_t>(pair.b)]) return true;
    }
    return std::binary_search(pairs_.begin(), pairs_.end(), pair);
}

// Collects the planes and the places in bounds_ of the finite shapes among `moved`.
void BroadPhase::list_shapes(std::span<const Collider> colliders, std::span<const Pose> poses,
                             const StepMotions* step, std::span<const int> moved) {
    const bool all = moved.size() == colliders.size();
    if (all) place_.assign(colliders.size(), -1);
    planes_.clear();  // always listed again: planes are static, and static ones are always in `moved`
    looked_at_.clear();
    int place = 0;
    for (const int i : moved) {
        const Collider& collider = at(colliders, i);
        if (!is_finite(collider.shape)) {
            const Pose& pose = poses[static_cast<std::size_t>(collider.body)];
            const Vector3 up = pose.rotation.col(1);
            double path = 0.0;  // of a moved one; one that turns may meet all
            if (step) {
                const Motion& motion = step->path_of(collider.body);
                path = motion.angular_velocity.isZero(0.0) ? std::max(0.0, step->dt * up.dot(motion.velocity))
                                                           : infinity;
            }
            planes_.push_back({.point = pose.position + path * up, .up = up, .collider = i});
            continue;
        }
        if (all) place_[static_cast<std::size_t>(i)] = place++;
        looked_at_.push_back(place_[static_cast<std::size_t>(i)]);
    }
    if (all) bounds_.resize(static_cast<std::size_t>(place));
}

void BroadPhase::bound(std::span<const Collider> colliders, std::span<const Body> bodies,
                       std::span<const Pose> poses, double margin, const StepMotions* step, const Awake& awake,
                       std::span<const int> moved, Threads* threads) {
    list_shapes(colliders, poses, step, moved);
    share(threads, moved.size(), boxes_of_a_part, [&](std::size_t begin, std::size_t end) {
        for (const int i : moved.subspan(begin, end - begin)) {
            const Collider& collider = at(colliders, i);
            if (!is_finite(collider.shape)) continue;
            const auto body = static_cast<std::size_t>(collider.body);
            const Pose& pose = poses[body];
            const double size = size_of(collider.shape);
            Bounds& box = bounds_[static_cast<std::size_t>(place_[static_cast<std::size_t>(i)])];
            static_cast<BoundingBox&>(box) =
                swept_box(collider.shape, pose, step ? step->path_of(collider.body) : Motion{},
                          step ? step->dt : 0.0, margin * size);
            box.slack = slack_share * size;
            box.collider = i;
            box.body = collider.body;
            box.idle = bodies[body].is_static() || !awake.has(i);
        }
    });
}

// Whether the candidates were found for the same colliders and the same planes.
bool BroadPhase::has_same_shapes() const {
    const auto same_plane = [](const Plane& a, const Plane& b) {
        return a.collider == b.collider && a.point == b.point && a.up == b.up;
    };
    const auto same_box = [this](int place) {
        const Bounds &a = wide_[static_cast<std::size_t>(place)], &b = bounds_[static_cast<std::size_t>(place)];
        return a.collider == b.collider && a.body == b.body;
    };
    return wide_.size() == bounds_.size() &&
           std::equal(wide_planes_.begin(), wide_planes_.end(), planes_.begin(), planes_.end(), same_plane) &&
           std::all_of(looked_at_.begin(), looked_at_.end(), same_box);
}

bool BroadPhase::uses_grid() const {
    return wide_.size() > few;
}

void BroadPhase::update_candidates(Threads* threads) {
    if (!has_same_shapes()) {
        find_all_candidates(threads);
        return;
    }
    const bool some_came_to_rest = find_left(threads);
    if (some_came_to_rest) std::erase_if(candidates_, [this](const Candidate& c) { return !can_move(c); });
    if (left_.empty()) return;
    put_again_ += left_.size();
    // The level bounds of the grid only ever grow, until it is refilled.
    const bool many = static_cast<double>(left_.size()) > most_left * static_cast<double>(wide_.size());
    if (many || put_again_ > 8 * wide_.size()) {
        find_all_candidates(threads);
    } else {
        find_candidates_of_left(threads);
    }
}

// Lists the boxes that have left their wide box or have woken. Returns whether any have come to rest.
bool BroadPhase::find_left(Threads* threads) {
    has_left_.assign(wide_.size(), 0);  // by box, resting ones included
    share(threads, looked_at_.size(), boxes_of_a_part, [this](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            const auto place = static_cast<std::size_t>(looked_at_[k]);
            const bool woke = wide_[place].idle && !bounds_[place].idle;
            has_left_[place] = woke || !holds(wide_[place], bounds_[place], bounds_[place].slack);
        }
    });
    left_.clear();
    bool some_came_to_rest = false;
    for (const int place : looked_at_) {
        const auto box = static_cast<std::size_t>(place);
        some_came_to_rest = some_came_to_rest || (bounds_[box].idle && !wide_[box].idle);
        wide_[box].idle = bounds_[box].idle;
        if (has_left_[box]) left_.push_back(place);
    }
    return some_came_to_rest;
}

void BroadPhase::widen(std::size_t index) {
    Bounds& box = wide_[index];
    box = bounds_[index];
    box.reach += Vector3::Constant(box.slack);
}

void BroadPhase::find_all_candidates(Threads* threads) {
    wide_.resize(bounds_.size());
    wide_planes_ = planes_;
    candidates_.clear();
    put_again_ = 0;
    const int count = static_cast<int>(wide_.size());
    for (std::size_t i = 0; i < wide_.size(); ++i) widen(i);
    if (uses_grid()) {
        grid_.clear(wide_.size());
        for (int i = 0; i < count; ++i) grid_.insert(i, wide_[static_cast<std::size_t>(i)]);
    }
    const auto find = [&](std::size_t begin, std::size_t end, std::vector<Candidate>& found) {
        for (int i = static_cast<int>(begin); i < static_cast<int>(end); ++i) {
            add_with_planes(i, found);
            const auto add = [&](int j) { add_if_near(i, j, found); };
            if (uses_grid()) {
                grid_.visit_pairs_from(i, wide_[static_cast<std::size_t>(i)], add);
            } else {
                for (int j = 0; j < i; ++j) add(j);
            }
        }
    };
    candidate_search_.append_to(candidates_, threads, wide_.size(), boxes_of_a_part, find);
    sort_distinct(threads, std::span(candidates_),
                  [](const Candidate& a, const Candidate& b) { return a.pair < b.pair; });
}

void BroadPhase::find_candidates_of_left(Threads* threads) {
    const auto left = [this](int box) { return box >= 0 && has_left_[static_cast<std::size_t>(box)]; };
    std::erase_if(candidates_, [&](const Candidate& c) { return left(c.box) || left(c.other); });

    for (const int i : left_) {
        if (uses_grid()) grid_.remove(i);
        widen(static_cast<std::size_t>(i));
        if (uses_grid()) grid_.insert(i, wide_[static_cast<std::size_t>(i)]);
    }
    const auto find = [&](std::size_t begin, std::size_t end, std::vector<Candidate>& found) {
        for (const int i : std::span(left_).subspan(begin, end - begin)) {
            add_with_planes(i, found);
            // A pair of two moved boxes is found from both.
            const auto add = [&](int j) {
                if (j != i && !(left(j) && j < i)) add_if_near(i, j, found);
            };
            if (uses_grid()) {
                grid_.visit_neighbours(i, wide_[static_cast<std::size_t>(i)], add);
            } else {
                for (int j = 0; j < static_cast<int>(wide_.size()); ++j) add(j);
            }
        }
    };
    const auto others = static_cast<std::ptrdiff_t>(candidates_.size());
    candidate_search_.append_to(candidates_, threads, left_.size(), left_of_a_part, find);
    const auto before = [](const Candidate& a, const Candidate& b) { return a.pair < b.pair; };
    sort_distinct(threads, std::span(candidates_).subspan(static_cast<std::size_t>(others)), before);
    std::inplace_merge(candidates_.begin(), candidates_.begin() + others, candidates_.end(), before);
}

void BroadPhase::add_with_planes(int index, std::vector<Candidate>& found) const {
    const Bounds& box = wide_[static_cast<std::size_t>(index)];
    for (int p = 0; p < static_cast<int>(wide_planes_.size()); ++p) {
        const Plane& plane = wide_planes_[static_cast<std::size_t>(p)];
        if (box.idle || !reaches(box, plane)) continue;
        const auto [a, b] = std::minmax(plane.collider, box.collider);
        if (filter_ && filter_->leaves_out({a, b})) continue;
        found.push_back({{a, b}, index, -1 - p});
    }
}

void BroadPhase::add_if_near(int index, int other, std::vector<Candidate>& found) const {
    const Bounds& box = wide_[static_cast<std::size_t>(index)];
    const Bounds& near = wide_[static_cast<std::size_t>(other)];
    if (!overlap(box, near) || (box.idle && near.idle) || box.body == near.body) return;
    const auto [a, b] = std::minmax(box.collider, near.collider);
    if (filter_ && filter_->leaves_out({a, b})) return;
    found.push_back({{a, b}, index, other});
}

std::span<const Pair> BroadPhase::find_pairs(std::span<const Collider> colliders, std::span<const Body> bodies,
                                             std::span<const Pose> poses, double margin, const StepMotions* step) {
    const Awake all(colliders.size());
    return find_pairs(colliders, bodies, poses, margin, step, all, all.members());
}

std::span<const Pair> BroadPhase::find_pairs(std::span<const Collider> colliders, std::span<const Body> bodies,
                                             std::span<const Pose> poses, double margin, const StepMotions* step,
                                             const Awake& awake, std::span<const int> moved, Threads* threads) {
    bound(colliders, bodies, poses, margin, step, awake, moved, threads);
    update_candidates(threads);
    pairs_.clear();
    const auto find = [this](std::size_t begin, std::size_t end, std::vector<Pair>& found) {
        for (const Candidate& candidate : std::span(candidates_).subspan(begin, end - begin)) {
            if (is_near(candidate)) found.push_back(candidate.pair);
        }
    };
    pair_search_.append_to(pairs_, threads, candidates_.size(), candidates_of_a_part, find);
    return pairs_;
}

bool BroadPhase::can_move(const Candidate& candidate) const {
    const auto moves = [this](int box) { return box >= 0 && !wide_[static_cast<std::size_t>(box)].idle; };
    return moves(candidate.box) || moves(candidate.other);
}

bool BroadPhase::is_near(const Candidate& candidate) const {
    const Bounds& box = bounds_[static_cast<std::size_t>(candidate.box)];
    return candidate.other >= 0 ? overlap(box, bounds_[static_cast<std::size_t>(candidate.other)])
                                : reaches(box, planes_[static_cast<std::size_t>(-1 - candidate.other)]);
}

void BroadPhase::put(int collider, const BoundingBox& box) {
    Bounds& own = bounds_[static_cast<std::size_t>(place_[static_cast<std::size_t>(collider)])];
    own.centre = box.centre;
    own.reach = box.reach;
}

std::span<const Pair> BroadPhase::find_pairs_of(const std::vector<bool>& of) {
    update_candidates(nullptr);
    pairs_.clear();
    const auto is_of = [&of](int collider) { return of[static_cast<std::size_t>(collider)]; };
    for (const Candidate& candidate : candidates_) {
        if ((is_of(candidate.pair.a) || is_of(candidate.pair.b)) && is_near(candidate)) {
            pairs_.push_back(candidate.pair);
        }
    }
    return pairs_;
}

}  // namespace pushfactor::engine::collision
