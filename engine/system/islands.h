// Islands: bodies that rows join, directly or through others. Static bodies join nothing.
//
// Ordered by island, A of the system equation (6.2.9) is block diagonal: no row of one island changes the velocity
// of a body of another. So each island is a system of its own, and whatever is decided about a solve (method,
// columns, iterations, tolerances) is decided for one island and depends on nothing outside of it.
//
// Not from the paper, which solves one system.
#pragma once

#include "engine/base/threads.h"
#include "engine/system/system_equation.h"

#include <cstdint>
#include <span>
#include <vector>

namespace pushfactor::engine {

// Rows that follow each other in the step and act on the same two bodies.
struct RowRun {
    int begin = 0, end = 0;  // of the rows of the step, which `end` is not part of
    int first = 0;           // number of row `begin` in the island
    int a = 0, b = 0;        // numbers in the island of body_a and body_b of the rows
};

// Bodies and rows are numbered in the island as they are in the world: ascending. The static bodies that rows of
// the island touch come after the movable ones, in the order in which rows name them.
struct Island {
    std::span<const int> bodies{};   // the movable ones: number k is body bodies[k] of the world; at least one
    std::span<const RowRun> runs{};  // at least one
    int rows = 0;
    int body_count = 0;           // static ones included
    int columns = 1;              // 2 when some row corrects for a single frame (8.1)
    bool follows_others = false;  // whether the bounds of some row follow a row of another run
    std::uint8_t traits = 0;      // of any of its rows (RowDigest)

    bool has(RowDigest::Trait trait) const { return (traits & trait) != 0; }
    int movable() const { return static_cast<int>(bodies.size()); }
    // The number in the island of `row` of the step, which must be one of the island's.
    int number_of(int row) const;
};

// 6.2.1 for the rows of one island: writes f_c = J^T lambda of column `column` for its movable bodies into `forces`
// [N and N m, one per body of the world] and leaves those of other bodies as they are.
void constraint_forces(const SystemEquation& system, const Island& island, const Columns& lambda,
                       Eigen::Index column, std::vector<Vector6>& forces);

// Which runs of an island act on each of its movable bodies, so that threads can go through these body by body.
class RunsOfBodies {
  public:
    void find(const Island& island);

    // Of one body; ascending. Twice the place of the run in island.runs, and one more where it is its body b.
    std::span<const int> of(std::size_t body) const {
        return std::span(sides_).subspan(static_cast<std::size_t>(begin_[body]),
                                         static_cast<std::size_t>(begin_[body + 1] - begin_[body]));
    }

  private:
    std::vector<int> begin_;  // by movable body, into sides_, and where the last one's end
    std::vector<int> sides_, next_;
};

// constraint_forces() of an island on threads, to the same bits.
void constraint_forces(const SystemEquation& system, const Island& island, const RunsOfBodies& runs_of,
                       const Columns& lambda, Eigen::Index column, Threads& threads, std::vector<Vector6>& forces);

// Natural-map residual of one island [m/s], as that of the system.
double natural_residual(const SystemEquation& system, const Island& island, const Columns& lambda);

// The same of one column, whose `forces` constraint_forces() has written. `accelerations` is memory to be reused.
// `threads` share the work; null: one thread.
double natural_residual(const SystemEquation& system, const Island& island, const Columns& lambda,
                        Eigen::Index column, std::span<const Vector6> forces, std::vector<Vector6>& accelerations,
                        Threads* threads = nullptr);

class Islands {
  public:
    // Finds the islands of `system`, in time linear in its rows and bodies; while the same rows act on the same
    // bodies as in the last call, they are found again at a glance. A row that no movable body takes part in
    // belongs to none.
    // `threads` share the work; null: one thread.
    void find(const SystemEquation& system, Threads* threads = nullptr) { find(system, 0, threads); }

    // The same when rows have come behind those of the last call, the first of them row `first_new`.
    void find_again(const SystemEquation& system, std::size_t first_new) {
        find(system, static_cast<int>(first_new), nullptr);
    }

    // In ascending order of their first bodies; good until the next find().
    std::span<const Island> all() const { return islands_; }

    // The island of a body, by its place in all(); below zero for a static body and for one without rows.
    int of_body(int body) const { return island_of_[static_cast<std::size_t>(body)]; }

    // Whether every row of the system belongs to an island.
    bool hold_all_rows() const { return hold_all_rows_; }

  private:
    struct Found {
        int begin, end;      // rows of the step
        int body_a, body_b;  // of the world
        int movable;         // one of them, -1 when both are static
        bool joins;          // whether both can move
        int columns = 1;
        bool follows = false;     // as in Island
        std::uint8_t traits = 0;  // of any of its rows
        friend bool operator==(const Found&, const Found&) = default;
    };
    struct Follower {
        int body;    // a movable one, of a row whose bounds follow
        int leader;  // a row of other bodies
    };

    void find(const SystemEquation& system, int first_new, Threads* threads);
    bool find_runs(const SystemEquation& system, int first_new, Threads* threads);
    static Found run_from(const SystemEquation& system, int begin);
    void join_bodies(const SystemEquation& system);
    void gather_bodies(const SystemEquation& system);
    void gather_runs();
    void number_static_bodies();
    void join(int a, int b);
    int root_of(int body);

    // What the islands follow from, as it was in the last find().
    std::size_t body_count_ = 0;
    std::vector<Found> found_, new_found_;
    Search<Found> run_search_;
    std::vector<Follower> followers_;
    std::vector<int> joined_;     // movable bodies with rows
    std::vector<int> parent_;     // by body, in the forest of joined bodies; -1 without rows
    std::vector<int> island_of_;  // by body
    std::vector<int> number_of_;  // by body, in its island; of a static one in the island that has named it last
    std::vector<int> named_by_;   // by body, the island that has named this static one last
    std::vector<int> begin_;      // by island, where its bodies or its runs begin, and where the last one's end
    std::vector<Island> islands_;
    std::vector<int> bodies_;   // of all islands
    std::vector<RowRun> runs_;  // of all islands
    bool hold_all_rows_ = true;
};

}  // namespace pushfactor::engine
