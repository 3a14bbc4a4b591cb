// The box-constrained problem of 6.2.9 by changes of the active set, in the space of the bodies' velocities, whose
// matrix has a 6 x 6 block per body (body_matrix.h). A few changes lead from the forces of the last step to those
// of this one; interior_point.h is for when they do not.
//
// Rows that one Jacobi step would leave between their bounds are solved exactly, all others are set to the bound
// that it would clamp them to (the primal-dual active set method of Hintermueller, Ito & Kunisch 2003). A row that
// is clamped to c times the force of its leader (Coulomb friction that slides) follows it, also within the step:
// of the free rows f and the rows k that follow them, with d = U^T (y' - y),
//
//   y'_f = y_f + rho (r_f - u_f . d),   y'_k = c_k y'_f
//   (I + sum_f rho (u_f + sum_k c_k u_k) u_f^T) d = sum_f rho r_f (u_f + sum_k c_k u_k) + what the others change
//
// which is the exact solution but for the proximal term |y' - y|^2 / (2 rho): it makes singular A harmless
// (redundant contacts) and vanishes with y' - y, so that a few steps with the same matrix reach rounding. All is
// written in differences, so that large rho costs no digits. While nothing slides the matrix is symmetric.
//
// Symbols as in unit_problem.h; d velocities [sqrt(kg) m/s], rho [1] proximal parameter.
#pragma once

#include "engine/solvers/body_matrix.h"
#include "engine/solvers/effort.h"
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
    // `changes` factorisations or the effort are used up. Returns the residual that was reached [m/s]; y is the
    // best that was seen among those that give the bodies no more energy than the guess or no force at all, and
    // never worse than it was.
    // `order` must connect the bodies of every row.
    double solve(const Elimination& order, const UnitProblem& problem, double tolerance, int changes,
                 std::vector<double>& y, Effort& effort, SolveCount& count);

  private:
    // What becomes of a row in a change.
    enum class State : char {
        set,           // to a bound that is known
        free,          // solved for
        follows_low,   // its leader, which is free, times the factor of its lower bound
        follows_high,  // of its upper one
    };

    void find_states(const UnitProblem& problem, const std::vector<double>& y);
    double factor_of(const UnitProblem::Row& row, State state) const;
    bool change(const Elimination& order, const UnitProblem& problem, std::vector<double>& y, Effort& effort,
                SolveCount& count);
    void factor(const Elimination& order, const UnitProblem& problem, Effort& effort, SolveCount& count);

    BodyMatrix matrix_;
    BodyVelocities x_, d_;
    std::vector<double> r_, moved_;
    BestForces best_;
    std::vector<Jacobian> pushed_;          // u_f + sum_k c_k u_k, by row
    std::vector<State> states_, factored_;  // now, and in the factor
};

}  // namespace pushfactor::engine::solvers
