// The box-constrained problem of 6.2.9 by a primal-dual interior point method (Mehrotra 1992), in the space of the
// bodies' velocities like active_set.h, which is faster where it settles; this one goes its way through any number
// of clamped rows in about twenty factorisations.
//
//   (U U^T + Theta) dy = q      Theta = z_low / (y - low) + z_high / (high - y)
//   (I + U^T W U) d = U^T W q,  dy = W (q - U d),  W = 1 / Theta
//
// Symbols as in unit_problem.h; z_low, z_high >= 0 multipliers of the bounds. A row without bounds has W = 1e7, a
// proximal step, so that redundant rows do no harm.
#pragma once

#include "engine/solvers/body_matrix.h"
#include "engine/solvers/solver.h"
#include "engine/solvers/unit_problem.h"

#include <vector>

namespace pushfactor::engine::solvers {

class InteriorPoint {
  public:
    // Improves y (within its bounds) until the natural residual is at most `tolerance` [m/s], falls no further, or
    // `factorisations` are used up. Returns the residual that was reached [m/s]; y is the best that was seen
    // among those that give the bodies no more energy than the guess or no force at all, and never worse than it
    // was.
    // `matrix` must be connected for the rows of the problem.
    double solve(BodyMatrix& matrix, const UnitProblem& problem, double tolerance, int factorisations,
                 std::vector<double>& y, SolveCount& count);

  private:
    // A row on its way. Without a bound the multiplier is zero and stays it.
    struct Point {
        double y = 0.0;
        double z_low = 0.0, z_high = 0.0;
        double dy = 0.0, dz_low = 0.0, dz_high = 0.0;  // the step
        double w = 0.0;                                // W; 0 for a row that cannot move
        bool low = false, high = false;                // which bounds there are
    };

    void start(const UnitProblem& problem, const std::vector<double>& y);
    double gap(const UnitProblem& problem, double share) const;
    double longest_step(const UnitProblem& problem) const;
    void factor(BodyMatrix& matrix, const UnitProblem& problem, SolveCount& count);
    void aim(const BodyMatrix& matrix, const UnitProblem& problem, double target, bool second_order,
             SolveCount& count);
    void go(const UnitProblem& problem, double share);

    std::vector<Point> points_;
    std::vector<double> y_, r_, q_;
    BodyVelocities x_, d_;
    BestForces best_;
};

}  // namespace pushfactor::engine::solvers
