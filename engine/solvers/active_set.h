// The box-constrained problem of 6.2.9 by changes of the active set, in the space of the bodies' velocities, whose
// matrix has a 6 x 6 block a body (body_matrix.h). A few changes lead from the forces of the last step to those of
// this one; interior_point.h is for when they do not.
//
// Rows that one Jacobi step would leave between their bounds are solved exactly, all others are set to the bound
// that it would clamp them to (the primal-dual active set method of Hintermueller, Ito & Kunisch 2003). Of the free
// rows f, with d = U^T (y' - y),
//
//   y'_f = y_f + rho (r_f - U_f d)       (I + rho U_f^T U_f) d = rho U_f^T r_f + U_c^T (y'_c - y_c)
//
// which is the exact solution but for the proximal term |y' - y|^2 / (2 rho): it makes singular A harmless
// (redundant contacts) and vanishes with y' - y, so that a few steps with the same matrix reach rounding. All is
// written in differences, so that large rho costs no digits.
//
// Symbols as in unit_problem.h; d velocities [sqrt(kg) m/s], rho [1] proximal parameter.
#pragma once

#include "engine/solvers/body_matrix.h"
#include "engine/solvers/solver.h"
#include "engine/solvers/unit_problem.h"

#include <vector>

namespace pushfactor::engine::solvers {

class ActiveSet {
  public:
    // Forgets the factor: the matrix or the axes are others now. Problems that follow each other without a start()
    // in between may differ in t and in bounds alone.
    void start() { factored_.clear(); }

    // Improves y (within its bounds) until the natural residual is at most `tolerance` [m/s], falls no further, or
    // `factorisations` are used up. Returns the residual that was reached [m/s]; y is the best that was seen
    // among those that give the bodies no more energy than the guess or no force at all, and never worse than it
    // was.
    // `matrix` must be connected for the rows of the problem.
    double solve(BodyMatrix& matrix, const UnitProblem& problem, double tolerance, int factorisations,
                 std::vector<double>& y, SolveCount& count);

    // Factorisations of the last solve that were left unused.
    int left() const { return left_; }

  private:
    bool change(BodyMatrix& matrix, const UnitProblem& problem, std::vector<double>& y, SolveCount& count);
    void factor(BodyMatrix& matrix, const UnitProblem& problem, SolveCount& count);

    int left_ = 0;
    BodyVelocities x_, d_;
    std::vector<double> r_;
    BestForces best_;
    std::vector<char> free_, factored_;  // rows between their bounds, now and in the factor
};

}  // namespace pushfactor::engine::solvers
