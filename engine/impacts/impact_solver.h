// The impulses of one impact: of two bodies, or of all pairs that hit each other at once, and of all that holds
// them.
//
// Each point that approaches fast enough leaves with epsilon times the speed of its approach, Newton's law (8.2.1),
// in the system equation of 6.2.9 with impulses in the place of forces. What holds the bodies takes part: joints
// and bars get back the velocity that they had at the start of the step, since which the bodies have flown without
// them, and bodies without restitution that lie on each other do not go further in.
//
// With friction Newton's law can make energy, where the impulse of the rebound works in the direction in which the
// point then moves (Kane 1984, Stronge 1990), and so can joints. So the work of the impact may not be positive:
//
//   W = sum over the rows of P (w + w') / 2 <= 0
//
// Symbols: P impulse of a row [N s]; w and w' velocities along the row before and after the impact, relative to
// what moves the surfaces [m/s].
//
// W is not positive where nothing rebounds. Bounds are convex, so between the solution without and the one with
// rebounds, P(k) = P(0) + k (P(1) - P(0)), everything keeps its bounds, and W is quadratic in k: the largest k from
// 0 to 1 that makes no energy is taken.
#pragma once

#include "engine/constraints/row_list.h"
#include "engine/solvers/solver.h"
#include "engine/system/system_equation.h"

#include <memory>
#include <span>
#include <vector>

namespace pushfactor::engine {

// An impact as rows: first those of the contact points and their friction, pair by pair, then those that hold. Body
// indices are those of `bodies`, which have the momenta before the impact.
struct ImpactProblem {
    struct Pair {
        std::size_t rows_end = 0;    // behind its last row
        double restitution = 0.0;    // epsilon
        double least_rebound = 0.0;  // m/s, what is slower does not rebound
    };

    std::vector<Body> bodies{};
    RowList rows{};
    std::vector<Pair> pairs{};
    std::vector<double> carried{};  // m/s, by row, see SystemEquation
};

class ImpactSolver {
  public:
    ImpactSolver();

    // Impulses on the bodies [N s, N m s], by body of the problem; valid until the next call.
    std::span<const Vector6> solve(ImpactProblem& problem);

    // Whether those of the last solve are an answer: with friction between bodies that are held there may be none.
    bool is_solved() const { return is_solved_; }

    // J, that belts and moved bodies have added in the last solve.
    double external_work() const { return external_work_; }

  private:
    struct Aim {
        double before = 0.0;    // m/s, along the row
        double rebounds = 0.0;  // m/s, speed that it leaves with; 0 if it does not rebound
    };
    void aim(ImpactProblem& problem);
    void find(const ImpactProblem& problem, bool with_rebounds, Columns& impulses);
    bool gains(const ImpactProblem& problem) const;
    double share_without_gain(const ImpactProblem& problem) const;

    std::unique_ptr<solvers::Solver> solver_;
    SystemEquation system_;
    std::vector<Aim> aims_;  // by row
    double fastest_ = 0.0;   // m/s, approach of the pairs
    Columns impulses_, stopped_;
    std::vector<Vector6> on_bodies_, on_bodies_stopped_;
    bool is_solved_ = true;
    double external_work_ = 0.0;
};

}  // namespace pushfactor::engine
