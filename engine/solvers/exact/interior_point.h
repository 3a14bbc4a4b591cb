// The box-constrained problem of 6.2.9 by a primal-dual interior point method (Mehrotra 1992), in the space of the
// bodies' velocities like active_set.h. That one is faster where it converges; this one handles any number of
// clamped rows in some twenty factorisations.
//
// The distances s of a force from its bounds are separate unknowns that meet the bounds only at convergence, and a
// bound that follows another row (Coulomb friction, 5.4) moves with it in every Newton step. With the bounds l =
// low y_i, h = high y_i of a row j that follows row i (y_i is 1 for any other row):
//
//   y - s_l = l,  y + s_h = h          both up to an error p that each step reduces
//   s_l z_l = s_h z_h = target         which goes to zero
//   U x - t = z_l - z_h
//
// and with Theta = delta + soft + z_l/s_l + z_h/s_h, W = 1/Theta, c_j = low z_l/s_l + high z_h/s_h, q the
// right-hand side after elimination of s and z:
//
//   dy_j = W_j (q_j - u_j . d + c_j dy_i)
//   (I + sum_j W_j u_j u_j^T + sum_i sum_j W_i W_j c_j u_j u_i^T) d = sum_j dy_j(d = 0) u_j
//
// A disc (friction on the cone) bounds two rows t together. They stay inside, as t = R e with |e| < 1, have one
// multiplier z, and meet the circle at convergence:
//
//   r = z e,  z R (1 - |e|^2) = target
//
// A step is linear in t if R grows and in e if it shrinks, because t and R go to zero together where a contact
// opens. Of the two directions of a disc the one across e has W = 1 / (delta + z/R), the one along e W = 1 / (delta
// + z/R (1 + |e|^2) / (1 - |e|^2)), and if R is h times the force of row i, c = 2 h |e| z/R / (1 - |e|^2). The
// error of r = z e after a full step is of second order; the target goes to zero no faster than that.
//
// Without rows that follow others the problem is convex, its matrix symmetric, and the method converges for every
// solvable problem. With them it is neither, and the method may jam between rows that wedge each other.
//
// Symbols as in unit_problem.h; s distances, z >= 0 multipliers of the bounds [sqrt(kg) m/s], delta a proximal
// parameter [1] around the y of each step, which regularises redundant rows; U x - t is -r.
#pragma once

#include "engine/solvers/exact/body_matrix.h"
#include "engine/solvers/exact/effort.h"
#include "engine/solvers/exact/pushed_axes.h"
#include "engine/solvers/exact/unit_problem.h"
#include "engine/solvers/solver.h"

#include <vector>

namespace pushfactor::engine::solvers {

class InteriorPoint {
  public:
    // Multiply-adds of a step for so many rows. If their bounds follow others the matrix is general.
    static double step_work(const Elimination& order, double rows, bool bounds_follow) {
        const double factor = bounds_follow ? order.general_work() : order.symmetric_work();
        return factor + UnitProblem::assembly_work(rows, bounds_follow) + solve_work(order, rows);
    }

    // Improves y (within its bounds) until the natural residual is at most `tolerance` [m/s], stops falling, or
    // `steps` factorisations or the effort are used up. Returns the final residual [m/s]; y is the best iterate
    // among those that give the bodies no more energy than the warm start or zero force, and never worse than
    // before. `order` must connect the bodies of every row.
    double solve(const Elimination& order, const UnitProblem& problem, double tolerance, int steps,
                 std::vector<double>& y, Effort& effort, SolveCount& count);

  private:
    // Of a predictor and a corrector, each refined once.
    static double solve_work(const Elimination& order, double rows) {
        return 4.0 * order.solve_work() + 16.0 * UnitProblem::look_work(rows);
    }

    // One bound of a row: distance, multiplier, and the steps of both.
    struct Bound {
        bool is = false;  // the bound exists
        double s = 1.0, z = 0.0;
        double error = 0.0;  // p, distance minus s
        double ds = 0.0, dz = 0.0;

        double ratio() const { return is ? z / s : 0.0; }
    };
    struct Point {
        double y = 0.0, dy = 0.0;
        double w = 0.0;    // W; 0 for a fixed row
        double c = 0.0;    // c_j
        int leader = -1;   // row whose step its bounds follow
        double own = 0.0;  // W q, its step for d = 0 and a leader that does not move
        Bound low, high;
    };

    // State of a disc. Steps as in Point; d is the direction of e.
    struct DiscPoint {
        std::size_t second = 0;   // second row of the disc
        double per_leader = 0.0;  // h: growth of R per unit of its leader's force, if it has one
        bool follows = false;     // the leader acts on the same bodies, so that its step is unknown
        double radius = 0.0, e_1 = 0.0, e_2 = 0.0, z = 0.0;
        double d_1 = 1.0, d_2 = 0.0;
        double d_radius = 0.0, de_1 = 0.0, de_2 = 0.0, dz = 0.0;
        double w_along = 0.0, w_across = 0.0, c = 0.0;
        double own_along = 0.0, own_across = 0.0;
        Jacobian along{}, across{};  // d_1 u_1 + d_2 u_2, and d_1 u_2 - d_2 u_1

        double filled() const { return e_1 * e_1 + e_2 * e_2; }
        double free() const { return 1.0 - filled(); }
    };

    double typical_force(const UnitProblem& problem, const std::vector<double>& y) const;
    void start(const UnitProblem& problem, const std::vector<double>& y);
    void look(const UnitProblem& problem);
    double mean_gap(double share) const;
    double error_of_discs() const;
    double longest_step() const;
    void factor(const Elimination& order, const UnitProblem& problem);
    void aim(const UnitProblem& problem, double target, double second_order);
    void start_disc(const UnitProblem& problem, const std::vector<double>& y, std::size_t j, double typical);
    void look_at(const UnitProblem& problem, DiscPoint& disc) const;
    void find_steps(const UnitProblem& problem);
    void go(double share);
    double step(const Elimination& order, const UnitProblem& problem);

    BodyMatrix matrix_;
    std::vector<Point> points_;
    std::vector<DiscPoint> discs_;
    PushedAxes pushed_;  // u_i + sum_j W_j c_j u_j
    std::vector<double> y_, r_;
    std::vector<double> pushes_, speeds_;  // by row
    BodyVelocities x_, d_, missed_;
    BestForces best_;
};

}  // namespace pushfactor::engine::solvers
