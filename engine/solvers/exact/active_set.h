// The box-constrained problem of 6.2.9 by an active set method in the space of the bodies' velocities, whose matrix
// has a 6 x 6 block per body (body_matrix.h). A few steps lead from the forces of the last time step to those of
// this one; if not, see interior_point.h.
//
// Rows that a Jacobi step would leave between their bounds are solved exactly, all others are set to the bound that
// it would clamp them to (the primal-dual active set method of Hintermueller, Ito & Kunisch 2003). A row clamped to
// c times the force of its leader (sliding Coulomb friction) follows it also within the step: for the free rows f
// and the rows k that follow them, with d = U^T (y' - y),
//
//   y'_f = y_f + rho (r_f - u_f . d),   y'_k = c_k y'_f
//   (I + sum_f rho (u_f + sum_k c_k u_k) u_f^T) d = sum_f rho r_f (u_f + sum_k c_k u_k) + changes of the other rows
//
// which is the exact solution except for the proximal term |y' - y|^2 / (2 rho): it regularises singular A
// (redundant contacts) and vanishes with y' - y, so that a few steps with the same matrix converge to rounding.
// Everything is written in differences, so that large rho costs no digits. Without sliding the matrix is symmetric.
//
// Where no forces are known, all rows that touch are free at first; and where a contact has carried nothing yet,
// its friction is. Most structures are solved by that factor; from zero forces the natural map would load one layer
// of bodies per step, and slide in the direction of rounding errors.
//
// For a soft row rho becomes rho / (1 + rho soft): its softness is a proximal term that stays.
//
// Both rows of a disc are free while a Jacobi step would leave them inside. On the circle the natural map is
// linearised (Alart & Curnier 1991): a force along the sliding direction, which follows the leader, and a damper
// across it.
//
// Discs often need proximal points (Rockafellar 1976): the proximal term stays around a fixed y until its problem,
// with r - (y' - y) / rho in place of r, is solved, and only then moves there. Between sticking contacts there may
// be forces that hardly move any body: they have to grow until one of the contacts slides or opens, and meanwhile
// the residual does not fall. Steps that have to lower the residual get stuck there.
//
// Symbols as in unit_problem.h; d velocities [sqrt(kg) m/s], rho [1] proximal parameter.
#pragma once

#include "engine/solvers/exact/body_matrix.h"
#include "engine/solvers/exact/effort.h"
#include "engine/solvers/exact/pushed_axes.h"
#include "engine/solvers/exact/unit_problem.h"
#include "engine/solvers/solver.h"

#include <vector>

namespace pushfactor::engine::solvers {

class ActiveSet {
  public:
    // Discards the factor; required if the order or the axes have changed. Problems solved without a start() in
    // between may differ only in t and bounds.
    void start() { factored_.clear(); }

    // Improves y (within its bounds) until the natural residual is at most `tolerance` [m/s], stops falling, or
    // `changes` factorisations or the effort are used up. Returns the final residual [m/s]; y is the best iterate
    // among those that give the bodies no more energy than the warm start or zero force, and never worse than
    // before. `order` must connect the bodies of every row.
    double solve(const Elimination& order, const UnitProblem& problem, double tolerance, int changes,
                 std::vector<double>& y, Effort& effort, SolveCount& count);

    // The same by proximal points, which go on where the residual stops falling.
    double solve_by_proximal_points(const Elimination& order, const UnitProblem& problem, double tolerance,
                                    int changes, std::vector<double>& y, Effort& effort, SolveCount& count);

  private:
    // Treatment of a row in a step.
    enum class State : char {
        set,           // to a known bound
        free,          // solved for
        follows_low,   // the force of its free leader times the factor of its lower bound
        follows_high,  // the same with the upper bound
        slides,        // on the circle of its disc
    };

    // A disc whose force is on its circle; 1 and 2 are its rows.
    struct Slide {
        std::size_t second = 0;       // second row of the disc
        bool follows = false;         // its radius follows a free leader
        double d_1 = 0.0, d_2 = 0.0;  // direction of the force
        double k = 0.0;               // coefficient of the damper
        double own = 1.0;             // share of the damper in the force that is already there
        Jacobian along{}, across{};   // d_1 u_1 + d_2 u_2, and d_1 u_2 - d_2 u_1
    };

    void find_states(const UnitProblem& problem, const std::vector<double>& y);
    void find_disc_state(const UnitProblem& problem, const std::vector<double>& y, std::size_t j, bool may_follow);
    bool is_symmetric() const;
    double factor_of(const UnitRow& row, State state) const;
    void set_rho(const UnitProblem& problem, double rho);
    // Step size of the natural map that finds the states of the rows. With rho every small residual would look like
    // a change of the active set, except around a fixed proximal point.
    double step_size(std::size_t row) const { return around_a_point_ ? rhos_[row] : 1.0; }
    bool take_proximal_step(const Elimination& order, const UnitProblem& problem, int most, std::vector<double>& y,
                            Effort& effort, SolveCount& count);
    bool look(const UnitProblem& problem, const std::vector<double>& y, Effort& effort, SolveCount& count);
    bool change(const Elimination& order, const UnitProblem& problem, std::vector<double>& y, Effort& effort,
                SolveCount& count);
    void start_slide(const UnitProblem& problem, const Slide& slide, const std::vector<double>& y);
    void end_slide(const UnitProblem& problem, const Slide& slide, std::vector<double>& y);
    void factor(const Elimination& order, const UnitProblem& problem, Effort& effort, SolveCount& count);

    BodyMatrix matrix_;
    BodyVelocities x_, d_;
    std::vector<double> r_, moved_;
    std::vector<double> pushes_, speeds_;   // by row
    bool around_a_point_ = false;           // a proximal point, and r_ contains its term
    std::vector<double> centre_, closest_;  // the point, and the best y on the way to the next one
    BestForces best_;
    PushedAxes pushed_;                     // u_f + sum_k c_k u_k
    std::vector<State> states_, factored_;  // current, and of the factor
    double touching_ = 0.0;  // m/s, speed up to which a row without force touches; 0 where forces are known
    double rho_ = 0.0;
    std::vector<double> rhos_;   // by row
    std::vector<Slide> slides_;  // current, in row order
};

}  // namespace pushfactor::engine::solvers
