#include "engine/system/dissection.h"

#include "engine/base/index.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pushfactor::engine {

namespace {

// Least rows per leaf, most bisections, and largest share of rows across planes. Those rows are swept after all
// others: with 64 leaves a heap of 20,000 balls jitters and does not settle.
constexpr int least_rows_of_leaf = 1000;
constexpr int most_halvings = 3;
constexpr double most_crossing = 0.2;
// Least share of the bodies on either side of a plane.
constexpr double least_share = 0.25;
// Distance from a plane up to which bodies are on one vertical line in it, as a share of the extent of the island:
// less than a body's size and far above rounding.
constexpr double one_line = 1e-3;
// The sum of the external forces has a direction if it is larger than this share of the sum of their norms.
constexpr double least_force = 1e-6;

// Replaces non-finite coordinates, so that there is a strict order.
Vector3 finite(const Vector3& position) {
    return position.unaryExpr([](double place) { return std::isfinite(place) ? place : 0.0; });
}

// Unit length; zero if the forces are none or cancel each other.
Vector3 vertical_of(std::span<const Body> bodies, const Island& island) {
    Vector3 sum = Vector3::Zero();
    double norms = 0.0;
    for (const int body : island.bodies) {
        const Vector3& force = bodies[at(body)].force;
        sum += force;
        norms += force.norm();
    }
    const double norm = sum.norm();
    return norm > least_force * norms ? Vector3(sum / norm) : Vector3(Vector3::Zero());
}

// Unit vector in the direction of the largest eigenvalue of a symmetric, positive semidefinite matrix, by powers of
// it; the sign is arbitrary. Zero for a matrix of zeros.
Vector3 main_direction(Matrix3 matrix) {
    constexpr int squarings = 30;  // tells eigenvalues apart that differ by 1e-8
    for (int k = 0; k < squarings; ++k) {
        const double trace = matrix.trace();
        if (!(trace > 0.0)) return Vector3::Zero();
        matrix /= trace;
        matrix = Matrix3(matrix * matrix);
    }
    Eigen::Index longest = 0;
    matrix.diagonal().maxCoeff(&longest);
    return matrix.col(longest).normalized();
}

int halvings_for(int rows) {
    int halvings = 0;
    while (halvings < most_halvings && (rows >> (halvings + 1)) >= least_rows_of_leaf) ++halvings;
    return halvings;
}

// Index of the first part of this height; parts of lower heights come first.
int parts_below(int height, int halvings) {
    return (2 << halvings) - (2 << (halvings - height));
}

}  // namespace

void Dissection::cut(std::span<const Body> bodies, const Island& island) {
    int halvings = island.rows < least_rows || island.follows_others ? 0 : halvings_for(island.rows);
    if (halvings > 0) {
        find_spots(bodies, island);
        leaf_of_.resize(spots_.size());
    }
    while (halvings > 0 && !(halve(0, island.movable(), halvings, 0) && put_runs(island, halvings))) --halvings;
    if (halvings == 0) {
        leave_whole(island);
    } else {
        put_bodies(island, halvings);
    }
    rounds_.clear();
    std::span<const Part> left = parts_;
    for (int height = 0; height <= halvings; ++height) {
        rounds_.push_back(left.first(std::size_t{1} << (halvings - height)));
        left = left.subspan(rounds_.back().size());
    }
}

void Dissection::leave_whole(const Island& island) {
    island_ = island;
    leaves_.assign(1, {0, island.movable()});
    parts_.assign(1, {island.runs});
}

void Dissection::find_spots(std::span<const Body> bodies, const Island& island) {
    const Vector3 vertical = vertical_of(bodies, island);
    const Vector3 origin = finite(bodies[at(island.bodies.front())].position);
    spots_.clear();
    reach_ = 0.0;
    for (int k = 0; k < island.movable(); ++k) {
        const Vector3 position = finite(bodies[at(island.bodies[at(k)])].position) - origin;
        reach_ = std::max(reach_, position.norm());
        spots_.push_back({.position = position - vertical.dot(position) * vertical, .body = k});
    }
}

// The main axis of the bodies' positions, away from the body of the lowest number. Bodies weigh by their numbers,
// so that symmetric scenes have one too.
Vector3 Dissection::long_axis(std::span<const Spot> spots) {
    Vector3 sum = Vector3::Zero();
    double weights = 0.0;
    const Spot* lowest = &spots.front();
    for (const Spot& spot : spots) {
        const double weight = spot.body + 1;
        sum += weight * spot.position;
        weights += weight;
        if (spot.body < lowest->body) lowest = &spot;
    }
    const Vector3 mean = sum / weights;
    Matrix3 spread = Matrix3::Zero();
    for (const Spot& spot : spots) {
        const Vector3 offset = spot.position - mean;
        spread += (spot.body + 1) / weights * offset * offset.transpose();
    }
    const Vector3 axis = main_direction(spread);
    return axis.dot(lowest->position - mean) > 0.0 ? Vector3(-axis) : axis;
}

// Bodies on one vertical line stay on one side of a plane, so that towers are not cut. Returns whether there are
// planes that bisect well enough.
bool Dissection::halve(int begin, int end, int halvings, int leaf) {
    const auto first = spots_.begin() + begin, last = spots_.begin() + end;
    if (halvings == 0) {
        for (auto spot = first; spot != last; ++spot) leaf_of_[at(spot->body)] = leaf;
        return true;
    }
    const Vector3 axis = long_axis(std::span(spots_).subspan(at(begin), at(end - begin)));
    places_.clear();
    for (auto spot = first; spot != last; ++spot) places_.push_back(spot->place = axis.dot(spot->position));
    const auto half = (end - begin) / 2;
    std::nth_element(places_.begin(), places_.begin() + half, places_.end());
    const double plane = places_[at(half)], line = one_line * reach_;
    const auto is_before = [=](const Spot& spot) { return spot.place < plane - line; };
    const auto is_not_behind = [=](const Spot& spot) { return spot.place <= plane + line; };
    const auto before = std::count_if(first, last, is_before),
               not_behind = std::count_if(first, last, is_not_behind);
    const bool takes_line = not_behind - half < half - before;
    const auto middle = static_cast<int>(takes_line ? not_behind : before);
    if (std::min(middle, end - begin - middle) < least_share * (end - begin)) return false;
    // Stable, because sums over bodies in another order are other sums.
    if (takes_line) {
        std::stable_partition(first, last, is_not_behind);
    } else {
        std::stable_partition(first, last, is_before);
    }
    return halve(begin, begin + middle, halvings - 1, 2 * leaf) &&
           halve(begin + middle, end, halvings - 1, 2 * leaf + 1);
}

// Assigns runs to parts and counts them. Returns whether few enough rows cross planes.
bool Dissection::put_runs(const Island& island, int halvings) {
    const auto leaf = [&](int body) { return body < island.movable() ? leaf_of_[at(body)] : -1; };
    part_of_.resize(island.runs.size());
    begin_.assign(at(parts_below(halvings, halvings) + 2), 0);
    int crossing = 0;
    for (std::size_t k = 0; k < island.runs.size(); ++k) {
        const RowRun& run = island.runs[k];
        int a = leaf(run.a), b = leaf(run.b), height = 0;
        if (a < 0) a = b;
        if (b < 0) b = a;
        for (; a != b; ++height) {
            a /= 2;
            b /= 2;
        }
        if (height > 0) crossing += run.end - run.begin;
        part_of_[k] = parts_below(height, halvings) + a;
        ++begin_[at(part_of_[k]) + 1];
    }
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    return crossing <= most_crossing * island.rows;
}

// Writes the island in the new order, ascending within each part.
void Dissection::put_bodies(const Island& island, int halvings) {
    leaves_.assign(std::size_t{1} << halvings, {});
    for (const int leaf : leaf_of_) ++leaves_[at(leaf)].end;
    for (std::size_t k = 1; k < leaves_.size(); ++k) {
        leaves_[k].begin = leaves_[k - 1].end;
        leaves_[k].end += leaves_[k].begin;
    }
    next_.clear();
    for (const Leaf& leaf : leaves_) next_.push_back(leaf.begin);
    number_.resize(at(island.body_count));
    std::iota(number_.begin(), number_.end(), 0);  // static bodies keep their numbers
    bodies_.resize(leaf_of_.size());
    for (std::size_t k = 0; k < leaf_of_.size(); ++k) {
        number_[k] = next_[at(leaf_of_[k])]++;
        bodies_[at(number_[k])] = island.bodies[k];
    }

    const std::size_t parts = begin_.size() - 1;
    runs_.resize(island.runs.size());
    next_.assign(begin_.begin(), begin_.end());
    for (std::size_t k = 0; k < island.runs.size(); ++k) runs_[at(next_[at(part_of_[k])]++)] = island.runs[k];
    int rows = 0;
    for (RowRun& run : runs_) {
        run.first = rows;
        run.a = number_[at(run.a)];
        run.b = number_[at(run.b)];
        rows += run.end - run.begin;
    }
    parts_.clear();
    for (std::size_t k = 0; k < parts; ++k) {
        parts_.push_back({std::span(runs_).subspan(at(begin_[k]), at(begin_[k + 1] - begin_[k]))});
    }
    island_ = island;
    island_.bodies = bodies_;
    island_.runs = runs_;
}

}  // namespace pushfactor::engine
