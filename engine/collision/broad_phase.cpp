#include "engine/collision/broad_phase.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>

namespace pushfactor::engine::collision {

namespace {

// Buckets per thread task.
constexpr std::size_t buckets_of_a_part = 500;
// Pairs per thread task.
constexpr std::size_t near_pairs_of_a_part = 1000;

// Most boxes are no wider than a share of a column; those of more columns are tested with all others.
constexpr double usual = 0.9, columns_of_usual = 2.0, most_columns = 3.0;

// Room of a box in a search, as a share of the size of the shape.
constexpr double room = 0.01;

// Whether part of the box may be below the plane.
template <typename Plane>
bool reaches(const BoundingBox& box, const Plane& plane) {
    return !(plane.up.dot(box.centre - plane.point) >= plane.up.cwiseAbs().dot(box.reach));
}

double width_of(const BoundingBox& box) {
    return 2.0 * std::max(box.reach.x(), box.reach.z());
}

// Sorts stably by `key`, 0 .. keys - 1; afterwards items of key k are from begins[k] to begins[k + 1].
template <typename T, typename Key>
void sort_by(const Key& key, std::size_t keys, std::vector<T>& items, std::vector<T>& before,
             std::vector<int>& begins) {
    items.swap(before);
    items.resize(before.size());
    begins.assign(keys + 1, 0);
    for (const T& item : before) ++begins[key(item)];
    std::partial_sum(begins.begin(), begins.end(), begins.begin());
    for (std::size_t k = before.size(); k-- > 0;) {
        items[static_cast<std::size_t>(--begins[key(before[k])])] = before[k];
    }
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

std::span<const Pair> BroadPhase::find_pairs(std::span<const Collider> colliders, std::span<const Body> bodies,
                                             std::span<const Pose> poses, double margin, const StepMotions* step) {
    const Awake all(colliders.size());
    return find_pairs(colliders, bodies, poses, margin, step, all, all.members());
}

std::span<const Pair> BroadPhase::find_pairs(std::span<const Collider> colliders, std::span<const Body> bodies,
                                             std::span<const Pose> poses, double margin, const StepMotions* step,
                                             const Awake& awake, std::span<const int> moved, Threads* threads) {
    list_shapes(colliders, poses, step, moved);
    std::atomic<bool> stay = roomy_.size() == bounds_.size() && planes_ == planes_then_;
    share_each(threads, moved, bodies_of_a_part, [&](int i) {
        const Collider& collider = colliders[static_cast<std::size_t>(i)];
        if (!is_finite(collider.shape)) return;
        const auto body = static_cast<std::size_t>(collider.body);
        const auto place = static_cast<std::size_t>(place_[static_cast<std::size_t>(i)]);
        Bounds& bounds = bounds_[place];
        set(bounds, swept_box(collider.shape, poses[body], step ? step->path_of(collider.body) : Motion{},
                              step ? step->dt : 0.0, margin * size_of(collider.shape)));
        bounds.collider = i;
        bounds.body = collider.body;
        bounds.idle = bodies[body].is_static() || !awake.has(i);
        if (stay.load(std::memory_order_relaxed) && !stays_in_room(place))
            stay.store(false, std::memory_order_relaxed);
    });
    pairs_.clear();
    const auto can_move = [&](int i) {
        const int body = colliders[static_cast<std::size_t>(i)].body;
        return !bodies[static_cast<std::size_t>(body)].is_static();
    };
    if (std::none_of(awake.members().begin(), awake.members().end(), can_move)) {
        if (!stay) roomy_.clear();  // what has left is not among `moved` for ever
        return pairs_;
    }
    if (!stay) find_near(colliders, threads);
    pair_search_.append_to(pairs_, threads, near_.size(), near_pairs_of_a_part,
                           [this](std::size_t begin, std::size_t end, std::vector<Pair>& found) {
                               std::copy_if(near_.begin() + static_cast<std::ptrdiff_t>(begin),
                                            near_.begin() + static_cast<std::ptrdiff_t>(end),
                                            std::back_inserter(found),
                                            [this](const Pair& pair) { return is_near(pair); });
                           });
    return pairs_;
}

// Whether what the last search with room has found about the box is still true.
bool BroadPhase::stays_in_room(std::size_t box) const {
    const Bounds &now = bounds_[box], &then = roomy_[box];
    return now.collider == then.collider && now.idle == then.idle && now.finite && then.finite &&
           (now.low.array() >= then.low.array()).all() && (now.high.array() <= then.high.array()).all();
}

// Searches with room.
void BroadPhase::find_near(std::span<const Collider> colliders, Threads* threads) {
    roomy_ = bounds_;
    for (Bounds& box : roomy_) {
        const double size = size_of(colliders[static_cast<std::size_t>(box.collider)].shape);
        set(box, {box.centre, box.reach + Vector3::Constant(room * size)});
        box.wanted = !box.idle;
    }
    planes_then_ = planes_;
    search(roomy_, threads);
    near_.swap(pairs_);
    pairs_.clear();
}

// Whether the boxes of a pair that was found with room overlap.
bool BroadPhase::is_near(const Pair& pair) const {
    const auto place_of = [this](int collider) { return place_[static_cast<std::size_t>(collider)]; };
    const int a = place_of(pair.a), b = place_of(pair.b);
    if (a >= 0 && b >= 0)
        return overlap(bounds_[static_cast<std::size_t>(a)], bounds_[static_cast<std::size_t>(b)]);
    const auto plane = std::ranges::find(planes_, a < 0 ? pair.a : pair.b, &Plane::collider);
    return reaches(bounds_[static_cast<std::size_t>(std::max(a, b))], *plane);
}

std::span<const Pair> BroadPhase::find_pairs_of(std::span<const char> of, Threads* threads) {
    for (Bounds& bounds : bounds_) bounds.wanted = of[static_cast<std::size_t>(bounds.collider)] != 0;
    search(bounds_, threads);
    return pairs_;
}

void BroadPhase::put(int collider, const BoundingBox& box) {
    set(bounds_[static_cast<std::size_t>(place_[static_cast<std::size_t>(collider)])], box);
}

void BroadPhase::set(Bounds& bounds, const BoundingBox& box) {
    static_cast<BoundingBox&>(bounds) = box;
    constexpr double rounding = 4.0 * std::numeric_limits<double>::epsilon();
    const Vector3 reach = box.reach + rounding * (box.centre.cwiseAbs() + box.reach);
    bounds.low = box.centre - reach;
    bounds.high = box.centre + reach;
    bounds.finite = (bounds.high - bounds.low).allFinite();
}

// Collects the planes and the places in bounds_ of the finite shapes among `moved`.
void BroadPhase::list_shapes(std::span<const Collider> colliders, std::span<const Pose> poses,
                             const StepMotions* step, std::span<const int> moved) {
    const bool all = moved.size() == colliders.size();
    if (all) place_.assign(colliders.size(), -1);
    planes_.clear();  // always listed again: planes are static, and static ones are always in `moved`
    int place = 0;
    for (const int i : moved) {
        const Collider& collider = colliders[static_cast<std::size_t>(i)];
        if (is_finite(collider.shape)) {
            if (all) place_[static_cast<std::size_t>(i)] = place++;
            continue;
        }
        const Pose& pose = poses[static_cast<std::size_t>(collider.body)];
        const Vector3 up = pose.rotation.col(1);
        double path = 0.0;  // of a moved one; one that turns may meet all
        if (step) {
            const Motion& motion = step->path_of(collider.body);
            path =
                motion.angular_velocity.isZero(0.0) ? std::max(0.0, step->dt * up.dot(motion.velocity)) : infinity;
        }
        planes_.push_back({.point = pose.position + path * up, .up = up, .collider = i});
    }
    if (all) bounds_.resize(static_cast<std::size_t>(place));
}

// Finds the pairs of the wanted boxes.
void BroadPhase::search(std::vector<Bounds>& boxes, Threads* threads) {
    searched_ = boxes;
    pairs_.clear();
    choose_boxes();
    fill_columns();
    const auto find_in_columns = [this](std::size_t begin, std::size_t end, std::vector<Pair>& found) {
        for (std::size_t k = begin; k < end; ++k) {
            const auto first = static_cast<std::size_t>(begins_[k]),
                       last = static_cast<std::size_t>(begins_[k + 1]);
            if (last - first > 1) sweep(std::span(entries_).subspan(first, last - first), found);
        }
    };
    const auto find_others = [this](std::size_t begin, std::size_t end, std::vector<Pair>& found) {
        for (std::size_t k = begin; k < end; ++k) add_with_planes_and_wide(chosen_[k], found);
    };
    pair_search_.append_to(pairs_, threads, begins_.size() - 1, buckets_of_a_part, find_in_columns);
    pair_search_.append_to(pairs_, threads, chosen_.size(), bodies_of_a_part, find_others);
    const auto a = [](const Pair& pair) { return static_cast<std::size_t>(pair.a); };
    const auto b = [](const Pair& pair) { return static_cast<std::size_t>(pair.b); };
    sort_by(b, place_.size(), pairs_, pairs_before_, begins_);
    sort_by(a, place_.size(), pairs_, pairs_before_, begins_);
}

// The wanted boxes and the others that are where these are.
void BroadPhase::choose_boxes() {
    Vector3 low = Vector3::Constant(infinity), high = -low;
    for (const Bounds& box : searched_) {
        if (!box.wanted || !box.finite) continue;
        low = low.cwiseMin(box.low);
        high = high.cwiseMax(box.high);
    }
    chosen_.clear();
    for (std::size_t k = 0; k < searched_.size(); ++k) {
        const Bounds& box = searched_[k];
        const bool near = (box.low.array() <= high.array()).all() && (box.high.array() >= low.array()).all();
        if (box.finite && near) chosen_.push_back(static_cast<int>(k));
    }
}

double BroadPhase::column_width() {
    widths_.clear();
    for (const int k : chosen_) widths_.push_back(width_of(searched_[static_cast<std::size_t>(k)]));
    if (widths_.empty()) return 1.0;
    const auto middle =
        widths_.begin() + static_cast<std::ptrdiff_t>(usual * static_cast<double>(widths_.size() - 1));
    std::nth_element(widths_.begin(), middle, widths_.end());
    return std::max(columns_of_usual * *middle, std::numeric_limits<double>::min());
}

// Sorts the boxes into buckets of columns, and lists the wide ones.
void BroadPhase::fill_columns() {
    const double width = column_width();
    const auto column = [width](double x) {
        constexpr double farthest = 1e9;  // all boxes beyond share it, which costs only time
        return static_cast<int>(std::clamp(std::floor(x / width), -farthest, farthest));
    };
    entries_.clear();
    wide_.clear();
    for (const int k : chosen_) {
        Bounds& box = searched_[static_cast<std::size_t>(k)];
        box.wide = width_of(box) > most_columns * width;
        if (box.wide) {
            wide_.push_back(k);
            continue;
        }
        const int x = column(box.low.x()), z = column(box.low.z());
        const int last_x = column(box.high.x()), last_z = column(box.high.z());
        for (int i = x; i <= last_x; ++i) {
            for (int j = z; j <= last_z; ++j) {
                entries_.push_back({box.low.y(), box.high.y(), i, j, k, (i == x ? 1u : 0u) | (j == z ? 2u : 0u)});
            }
        }
    }
    const std::size_t buckets = std::bit_ceil(entries_.size() + 1);
    const auto bucket = [buckets](const Entry& entry) {
        auto hash = static_cast<std::uint64_t>(entry.x) * 0x9e3779b97f4a7c15u;
        hash = (hash ^ (hash >> 29) ^ static_cast<std::uint64_t>(entry.z)) * 0x9e3779b97f4a7c15u;
        return static_cast<std::size_t>(hash >> 32) & (buckets - 1);
    };
    sort_by(bucket, buckets, entries_, entries_before_, begins_);
}

// Finds the pairs within the columns of one bucket.
void BroadPhase::sweep(std::span<Entry> entries, std::vector<Pair>& found) const {
    std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
        return a.x != b.x ? a.x < b.x : a.z != b.z ? a.z < b.z : a.low < b.low;
    });
    for (std::size_t k = 0; k < entries.size(); ++k) {
        const Entry& one = entries[k];
        const Bounds& box = searched_[static_cast<std::size_t>(one.box)];
        for (const Entry& other : entries.subspan(k + 1)) {
            if (other.low > one.high || other.x != one.x || other.z != one.z) break;
            // Two boxes that share more than one column make their pair in the first of these.
            if ((one.first | other.first) != 3u) continue;
            add_if_near(box, searched_[static_cast<std::size_t>(other.box)], found);
        }
    }
}

void BroadPhase::add_with_planes_and_wide(int box, std::vector<Pair>& found) const {
    const Bounds& one = searched_[static_cast<std::size_t>(box)];
    if (one.wanted && !one.idle) {
        for (const Plane& plane : planes_) {
            if (reaches(one, plane)) add(plane.collider, one.collider, found);
        }
    }
    for (const int k : wide_) {
        if (!one.wide || box < k) add_if_near(one, searched_[static_cast<std::size_t>(k)], found);
    }
}

void BroadPhase::add_if_near(const Bounds& one, const Bounds& other, std::vector<Pair>& found) const {
    if (!(one.wanted || other.wanted) || (one.idle && other.idle)) return;
    if (overlap(one, other) && one.body != other.body) add(one.collider, other.collider, found);
}

void BroadPhase::add(int one, int other, std::vector<Pair>& found) const {
    const Pair pair{std::min(one, other), std::max(one, other)};
    if (!filter_ || !filter_->leaves_out(pair)) found.push_back(pair);
}

}  // namespace pushfactor::engine::collision
