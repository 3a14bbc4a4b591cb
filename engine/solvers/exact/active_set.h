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
// Both rows of a disc are free while a Jacobi step would leave them inside. On the circle the natural map is taken
// to first order (Alart & Curnier 1991): a force along the direction in which it slides, which follows the leader,
// and a damper across it.
//
// Symbols as in unit_problem.h; d velocities [sqrt(kg) m/s], rho [1] proximal parameter.
#pragma once

#include "engine/solvers/exact/body_matrix.h"
#include "engine/solvers/exact/effort.h"
#include "engine/solvers/exact/unit_problem.h"
#include "engine/solvers/solver.h"

#include <vector>

namespace pushfactor::engine::solvers {

class ActiveSet {
  public:
    // Forgets the factor: the matrix or the axes are others now. Problems that follow each other without a start()
    // in between may differ in t and in bounds alone.
    void start() { factored_.clear(); }

    // How far a change may go: as far as the rows say; or only as far as the map of sliding discs, which is not
    // linear between its bounds, is likely to hold, in more changes.
    enum class Pace { bold, careful };

    // Improves y (within its bounds) until the natural residual is at most `tolerance` [m/s], falls no further, or
    // `changes` factorisations or the effort are used up. Returns the residual that was reached [m/s]; y is the
    // best that was seen among those that give the bodies no more energy than the guess or no force at all, and
    // never worse than it was.
    // `order` must connect the bodies of every row.
    double solve(const Elimination& order, const UnitProblem& problem, Pace pace, double tolerance, int changes,
                 std::vector<double>& y, Effort& effort, SolveCount& count);

  private:
    // What becomes of a row in a change.
    enum class State : char {
        set,           // to a bound that is known
        free,          // solved for
        follows_low,   // its leader, which is free, times the factor of its lower bound
        follows_high,  // of its upper one
        slides,        // on the circle of its disc
    };

    // A disc whose forces are on its circle; 1 and 2 are its rows.
    struct Slide {
        std::size_t second = 0;       // its second row
        bool follows = false;         // whether its radius follows a leader that is free
        double d_1 = 0.0, d_2 = 0.0;  // the direction of the force
        double k = 0.0;               // of the damper
        Jacobian along{}, across{};   // d_1 u_1 + d_2 u_2, and d_1 u_2 - d_2 u_1
    };

    void find_states(const UnitProblem& problem, const std::vector<double>& y);
    void find_disc_state(const UnitProblem& problem, const std::vector<double>& y, std::size_t j, bool may_follow);
    double factor_of(const UnitProblem::Row& row, State state) const;
    bool change(const Elimination& order, const UnitProblem& problem, std::vector<double>& y, Effort& effort,
                SolveCount& count);
    void start_slide(const UnitProblem& problem, const Slide& slide, const std::vector<double>& y);
    void end_slide(const UnitProblem& problem, const Slide& slide, std::vector<double>& y);
    void factor(const Elimination& order, const UnitProblem& problem, Effort& effort, SolveCount& count);

    BodyMatrix matrix_;
    BodyVelocities x_, d_;
    std::vector<double> r_, moved_;
    BestForces best_;
    std::vector<Jacobian> pushed_;          // u_f + sum_k c_k u_k, by row
    std::vector<State> states_, factored_;  // now, and in the factor
    double rho_ = 0.0;
    std::vector<Slide> slides_;  // now, in the order of their rows
};

}  // namespace pushfactor::engine::solvers
