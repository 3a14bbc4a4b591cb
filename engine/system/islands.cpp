#include "engine/system/islands.h"

#include "engine/base/index.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace pushfactor::engine {

namespace {

constexpr std::size_t bodies_of_an_island_part = 200;  // per thread task

// 2 if any row from `begin` up to `end` corrects, or acts on bodies that were hit. Whatever is left of its push:
// what other islands do may have them looked at again.
int columns_of(int begin, int end, const SystemEquation& system) {
    for (int j = begin; j < end; ++j) {
        if (system.digests[at(j)].has(RowDigest::corrects) || system.b(j, 0) != system.b(j, 1)) return 2;
    }
    return 1;
}

bool moves(const SystemEquation& system, int body) {
    return system.inverse_mass[at(body)].linear > 0.0;
}

}  // namespace

int Island::number_of(int row) const {
    const auto after =
        std::upper_bound(runs.begin(), runs.end(), row, [](int r, const RowRun& run) { return r < run.begin; });
    const RowRun& run = *std::prev(after);
    return run.first + row - run.begin;
}

void constraint_forces(const SystemEquation& system, const Island& island, const Columns& lambda,
                       Eigen::Index column, std::vector<Vector6>& forces) {
    for (const int body : island.bodies) forces[at(body)].setZero();
    for (const RowRun& run : island.runs) {
        Vector6 on_static = Vector6::Zero();
        const auto on = [&](int number) -> Vector6& {
            return number < island.movable() ? forces[at(island.bodies[at(number)])] : on_static;
        };
        add_forces_of_rows(system, lambda, column, run.begin, run.end, on(run.a), on(run.b));
    }
}

void RunsOfBodies::find(const Island& island) {
    const auto each_side = [&](const auto& visit) {
        for (std::size_t k = 0; k < island.runs.size(); ++k) {
            const RowRun& run = island.runs[k];
            if (run.a < island.movable()) visit(at(run.a), static_cast<int>(2 * k));
            if (run.b < island.movable()) visit(at(run.b), static_cast<int>(2 * k + 1));
        }
    };
    begin_.assign(island.bodies.size() + 1, 0);
    each_side([this](std::size_t body, int) { ++begin_[body + 1]; });
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    sides_.resize(at(begin_.back()));
    next_.assign(begin_.begin(), begin_.end());
    each_side([this](std::size_t body, int side) { sides_[at(next_[body]++)] = side; });
}

void constraint_forces(const SystemEquation& system, const Island& island, const RunsOfBodies& runs_of,
                       const Columns& lambda, Eigen::Index column, Threads& threads, std::vector<Vector6>& forces) {
    threads.share(island.bodies.size(), bodies_of_an_island_part, [&](std::size_t begin, std::size_t end, int) {
        for (std::size_t k = begin; k < end; ++k) {
            Vector6 sum = Vector6::Zero();
            for (const int side : runs_of.of(k)) {
                const RowRun& run = island.runs[at(side / 2)];
                for (int j = run.begin; j < run.end; ++j) {
                    const Jacobian& jacobian = system.rows[at(j)].jacobian;
                    sum += (side % 2 == 0 ? jacobian.a : jacobian.b) * lambda(j, column);
                }
            }
            forces[at(island.bodies[k])] = sum;
        }
    });
}

namespace {

// Of the rows of some runs. Whether soft rows are among them is decided here, because a test per row costs all
// scenes.
template <bool any_soft>
[[gnu::always_inline]] inline double largest_of(const SystemEquation& system, const Columns& lambda,
                                                Eigen::Index column, std::span<const RowRun> runs,
                                                std::span<const Vector6> accelerations) {
    double largest = 0.0;
    RowResiduals residuals(system, lambda, column);
    for (const RowRun& run : runs) {
        const Vector6 &of_a = accelerations[at(run.a)], &of_b = accelerations[at(run.b)];
        for (int j = run.begin; j < run.end; ++j) {
            const ConstraintRow& row = system.rows[at(j)];
            double w = row.jacobian.a.dot(of_a) + row.jacobian.b.dot(of_b) - system.b(j, column);
            if constexpr (any_soft) w += soft_part(row, lambda, j, column);
            const double miss = residuals.next(j, w);
            if (!(miss <= largest)) largest = miss;
        }
    }
    return largest;
}

[[gnu::noinline]] double largest_of_soft(const SystemEquation& system, const Columns& lambda, Eigen::Index column,
                                         std::span<const RowRun> runs, std::span<const Vector6> accelerations) {
    return largest_of<true>(system, lambda, column, runs, accelerations);
}

}  // namespace

double island_residual(const SystemEquation& system, const Island& island, const Columns& lambda,
                       Eigen::Index column, std::span<const Vector6> forces, std::vector<Vector6>& accelerations,
                       Threads* threads) {
    accelerations.resize(at(island.body_count));
    for (std::size_t k = island.bodies.size(); k < accelerations.size(); ++k) accelerations[k].setZero();
    share(threads, island.bodies.size(), bodies_of_an_island_part, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            const auto body = at(island.bodies[k]);
            accelerations[k] = accelerate(system.inverse_mass[body], forces[body]);
        }
    });
    const auto of_runs = [&](std::span<const RowRun> runs) __attribute__((always_inline)) {
        return island.has(RowDigest::soft) ? largest_of_soft(system, lambda, column, runs, accelerations)
                                           : largest_of<false>(system, lambda, column, runs, accelerations);
    };
    if (!threads) return of_runs(island.runs);
    std::vector<double> of_parts(parts_of(threads, island.runs.size(), runs_of_a_part));
    share_parts(threads, island.runs.size(), runs_of_a_part,
                [&](std::size_t part, std::size_t begin, std::size_t end) {
                    of_parts[part] = of_runs(island.runs.subspan(begin, end - begin));
                });
    return *std::max_element(of_parts.begin(), of_parts.end());
}

double island_residual(const SystemEquation& system, const Island& island, const Columns& lambda) {
    double largest = 0.0;
    std::vector<Vector6> forces(system.inverse_mass.size()), accelerations;
    for (Eigen::Index column = 0; column < island.columns; ++column) {
        constraint_forces(system, island, lambda, column, forces);
        largest = std::max(largest, island_residual(system, island, lambda, column, forces, accelerations));
    }
    return largest;
}

void Islands::find(const SystemEquation& system, Threads* threads) {
    if (!find_runs(system, threads)) return;
    join_bodies(system);
    gather_bodies(system);
    gather_runs();
    number_static_bodies();
}

// The run of rows that starts at `begin`.
Islands::Found Islands::run_from(const SystemEquation& system, int begin) {
    const RowDigest* const rows = system.digests.data();
    const int a = rows[begin].body_a, b = rows[begin].body_b, row_count = static_cast<int>(system.digests.size());
    const bool a_moves = moves(system, a), b_moves = moves(system, b);
    Found run{begin, begin, a, b, a_moves ? a : b_moves ? b : -1, a_moves && b_moves};
    for (; run.end < row_count && rows[run.end].body_a == a && rows[run.end].body_b == b; ++run.end) {
        const RowDigest& row = rows[run.end];
        run.traits |= row.traits;
        if (row.has(RowDigest::follows) && system.rows[at(run.end)].bounds.of_row < begin) run.follows = true;
    }
    if (system.column_count() == 2) run.columns = columns_of(run.begin, run.end, system);
    return run;
}

// Returns whether the runs differ from those of the last call.
bool Islands::find_runs(const SystemEquation& system, Threads* threads) {
    const std::span<const RowDigest> rows = system.digests;
    const auto begins_run = [&](std::size_t j) {
        return j == 0 || rows[j].body_a != rows[j - 1].body_a || rows[j].body_b != rows[j - 1].body_b;
    };
    new_found_.clear();
    run_search_.append_to(new_found_, threads, rows.size(), rows_of_a_part,
                          [&](std::size_t begin, std::size_t end, std::vector<Found>& found) {
                              std::size_t j = begin;
                              while (j < end && !begins_run(j)) ++j;
                              for (; j < end; j = at(found.back().end)) {
                                  found.push_back(run_from(system, static_cast<int>(j)));
                              }
                          });
    // For runs that follow others the leaders may have changed, so treat them as different.
    const bool unchanged = body_count_ == system.inverse_mass.size() && found_ == new_found_ &&
                           std::ranges::none_of(new_found_, &Found::follows);
    if (unchanged) return false;
    body_count_ = system.inverse_mass.size();
    found_.swap(new_found_);
    followers_.clear();
    for (const Found& run : found_) {
        for (int j = run.begin; run.follows && run.movable >= 0 && j < run.end; ++j) {
            // A bound that follows another row needs that row's force.
            const int leader = system.rows[at(j)].bounds.of_row;
            if (leader >= 0 && leader < run.begin) followers_.push_back({run.movable, leader});
        }
    }
    return true;
}

int Islands::root_of(int body) {
    while (parent_[at(body)] != body) {
        int& parent = parent_[at(body)];
        parent = parent_[at(parent)];
        body = parent;
    }
    return body;
}

// The lower body becomes the root, so that islands are numbered by their first body.
void Islands::join(int a, int b) {
    const auto [low, high] = std::minmax({root_of(a), root_of(b)});
    parent_[at(high)] = low;
}

void Islands::join_bodies(const SystemEquation& system) {
    if (parent_.size() != body_count_) {
        joined_.clear();
        parent_.assign(body_count_, -1);
        island_of_.assign(body_count_, -1);
    }
    for (const int body : joined_) parent_[at(body)] = island_of_[at(body)] = -1;
    joined_.clear();
    hold_all_rows_ = true;
    const auto take = [this](int body) {
        if (parent_[at(body)] >= 0) return;
        parent_[at(body)] = body;
        joined_.push_back(body);
    };
    for (const Found& run : found_) {
        hold_all_rows_ = hold_all_rows_ && run.movable >= 0;
        if (run.movable < 0) continue;
        take(run.movable);
        if (!run.joins) continue;
        take(run.body_b);
        join(run.body_a, run.body_b);
    }
    for (const auto& [body, leader] : followers_) {
        for (const int other : {system.rows[at(leader)].body_a, system.rows[at(leader)].body_b}) {
            if (moves(system, other)) join(body, other);
        }
    }
}

void Islands::gather_bodies(const SystemEquation& system) {
    islands_.clear();
    number_of_.resize(parent_.size());
    for (const int body : system.awake) {
        if (parent_[at(body)] < 0) continue;
        const int root = root_of(body);
        if (root == body) {
            island_of_[at(body)] = static_cast<int>(islands_.size());
            islands_.emplace_back();
        }
        island_of_[at(body)] = island_of_[at(root)];
        number_of_[at(body)] = islands_[at(of_body(body))].body_count++;
    }
    begin_.assign(1, 0);
    for (const Island& island : islands_) begin_.push_back(begin_.back() + island.body_count);
    bodies_.resize(at(begin_.back()));
    for (const int body : system.awake) {
        if (of_body(body) >= 0) bodies_[at(begin_[at(of_body(body))] + number_of_[at(body)])] = body;
    }
    for (std::size_t k = 0; k < islands_.size(); ++k) {
        islands_[k].bodies = std::span(bodies_).subspan(at(begin_[k]), at(islands_[k].body_count));
    }
}

// Groups the runs by island, in the order of the step.
void Islands::gather_runs() {
    begin_.assign(islands_.size() + 1, 0);
    for (const Found& run : found_) {
        if (run.movable >= 0) ++begin_[at(of_body(run.movable) + 1)];
    }
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    runs_.resize(at(begin_.back()));
    for (std::size_t k = 0; k < islands_.size(); ++k) {
        islands_[k].runs = std::span(runs_).subspan(at(begin_[k]), at(begin_[k + 1] - begin_[k]));
    }
    for (const Found& run : found_) {
        if (run.movable < 0) continue;
        Island& island = islands_[at(of_body(run.movable))];
        runs_[at(begin_[at(of_body(run.movable))]++)] = {run.begin, run.end, island.rows, run.body_a, run.body_b};
        island.rows += run.end - run.begin;
        island.columns = std::max(island.columns, run.columns);
        island.follows_others = island.follows_others || run.follows;
        island.traits |= run.traits;
    }
}

// Replaces the world indices of bodies in the runs by their numbers in the island.
void Islands::number_static_bodies() {
    named_by_.assign(parent_.size(), -1);
    RowRun* run = runs_.data();
    for (int k = 0; k < static_cast<int>(islands_.size()); ++k) {
        Island& island = islands_[at(k)];
        const auto number = [&](int body) {
            if (parent_[at(body)] < 0 && named_by_[at(body)] != k) {
                named_by_[at(body)] = k;
                number_of_[at(body)] = island.body_count++;
            }
            return number_of_[at(body)];
        };
        for (const RowRun* end = run + island.runs.size(); run != end; ++run) {
            run->a = number(run->a);
            run->b = number(run->b);
        }
    }
}

}  // namespace pushfactor::engine
