// Islands: bodies connected by rows, directly or through others. Static bodies connect nothing.
//
// Ordered by island, A of the system equation (6.2.9) is block diagonal: no row of one island changes the velocity
// of a body of another. So each island is a system of its own, and every decision about a solve (method, columns,
// iterations, tolerances) is made per island and depends on nothing outside it.
//
// Not from the paper, which solves one system.
#pragma once

#include "engine/base/threads.h"
#include "engine/system/system_equation.h"

#include <cstdint>
#include <span>
#include <vector>

namespace pushfactor::engine {

// Consecutive rows of the step that act on the same two bodies.
struct RowRun {
    int begin = 0, end = 0;  // rows of the step, half-open
    int first = 0;           // number of row `begin` in the island
    int a = 0, b = 0;        // numbers in the island of the rows' body_a and body_b
};

inline constexpr std::size_t runs_of_a_part = 400;  // per thread task

// Bodies and rows are numbered within the island in ascending order of their world indices. Static bodies come
// after the movable ones, in the order in which rows refer to them.
struct Island {
    std::span<const int> bodies{};   // movable bodies: number k is body bodies[k] of the world; at least one
    std::span<const RowRun> runs{};  // at least one
    int rows = 0;
    int body_count = 0;           // including static ones
    int columns = 1;              // 2 if any row has a single-frame correction (8.1)
    bool follows_others = false;  // the bounds of some row follow a row of another run
    std::uint16_t traits = 0;     // union over its rows (RowDigest)

    bool has(RowDigest::Trait trait) const { return (traits & trait) != 0; }
    int movable() const { return static_cast<int>(bodies.size()); }
    // Number in the island of `row` of the step, which must belong to it.
    int number_of(int row) const;
};

// 6.2.1 for the rows of one island: writes f_c = J^T lambda of column `column` for its movable bodies into `forces`
// [N and N m, one per body of the world] and leaves other bodies unchanged.
void constraint_forces(const SystemEquation& system, const Island& island, const Columns& lambda,
                       Eigen::Index column, std::vector<Vector6>& forces);

// Runs of an island by movable body, so that threads can sum forces body by body.
class RunsOfBodies {
  public:
    void find(const Island& island);

    // Ascending. Twice the index of the run in island.runs, plus one if the body is its body b.
    std::span<const int> of(std::size_t body) const {
        return std::span(sides_).subspan(static_cast<std::size_t>(begin_[body]),
                                         static_cast<std::size_t>(begin_[body + 1] - begin_[body]));
    }

  private:
    std::vector<int> begin_;  // by movable body, first index into sides_; and the end of the last one
    std::vector<int> sides_, next_;
};

// constraint_forces() of an island on several threads, bit-identical to the serial one.
void constraint_forces(const SystemEquation& system, const Island& island, const RunsOfBodies& runs_of,
                       const Columns& lambda, Eigen::Index column, Threads& threads, std::vector<Vector6>& forces);

// Natural-map residual [m/s] of one island in its columns, see RowResiduals.
double island_residual(const SystemEquation& system, const Island& island, const Columns& lambda);

// The same for one column, with `forces` from constraint_forces(). `accelerations` is scratch memory.
double island_residual(const SystemEquation& system, const Island& island, const Columns& lambda,
                       Eigen::Index column, std::span<const Vector6> forces, std::vector<Vector6>& accelerations,
                       Threads* threads = nullptr);

class Islands {
  public:
    // Finds the islands of `system`, in time linear in its rows and bodies; reuses the result of the last call if
    // the same rows act on the same bodies. A row without movable bodies belongs to no island.
    void find(const SystemEquation& system, Threads* threads = nullptr);

    // In ascending order of their first bodies; valid until the next find().
    std::span<const Island> all() const { return islands_; }

    // Index in all() of the island of a body; negative for static bodies and bodies without rows.
    int of_body(int body) const { return island_of_[static_cast<std::size_t>(body)]; }

    // Whether every row of the system belongs to an island.
    bool hold_all_rows() const { return hold_all_rows_; }

  private:
    struct Found {
        int begin, end;      // rows of the step
        int body_a, body_b;  // world indices
        int movable;         // one of them, -1 if both are static
        bool joins;          // both are movable
        int columns = 1;
        bool follows = false;      // see Island
        std::uint16_t traits = 0;  // union over its rows
        friend bool operator==(const Found&, const Found&) = default;
    };
    struct Follower {
        int body;    // movable body of a row whose bounds follow
        int leader;  // row of other bodies
    };

    bool find_runs(const SystemEquation& system, Threads* threads);
    static Found run_from(const SystemEquation& system, int begin);
    void join_bodies(const SystemEquation& system);
    void gather_bodies(const SystemEquation& system);
    void gather_runs();
    void number_static_bodies();
    void join(int a, int b);
    int root_of(int body);

    // Inputs that the islands depend on, from the last find().
    std::size_t body_count_ = 0;
    std::vector<Found> found_, new_found_;
    Search<Found> run_search_;
    std::vector<Follower> followers_;
    std::vector<int> joined_;     // movable bodies with rows
    std::vector<int> parent_;     // by body, union-find forest; -1 without rows
    std::vector<int> island_of_;  // by body
    std::vector<int> number_of_;  // by body, in its island; for static bodies in the one that numbered it last
    std::vector<int> named_by_;   // by body, the island that numbered this static body last
    std::vector<int> begin_;      // by island, first body or run; and the end of the last one
    std::vector<Island> islands_;
    std::vector<int> bodies_;   // of all islands
    std::vector<RowRun> runs_;  // of all islands
    bool hold_all_rows_ = true;
};

}  // namespace pushfactor::engine
