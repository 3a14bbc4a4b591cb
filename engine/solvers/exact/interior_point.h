// The box-constrained problem of 6.2.9 by a primal-dual interior point method (Mehrotra 1992), in the space of the
// bodies' velocities like active_set.h, which is faster where it settles; this one goes its way through any number
// of clamped rows in some twenty factorisations.
//
// The distances s of a force from its bounds are unknowns of their own, which meet the bounds only at the end, and
// a bound that follows another row (Coulomb friction, 5.4) moves with it in every Newton step. With the bounds
// l = low y_i, h = high y_i of a row j that follows row i (y_i is 1 for any other row):
//
//   y - s_l = l,  y + s_h = h          both up to an error p that each step takes off
//   s_l z_l = s_h z_h = target         which goes to zero
//   U x - t = z_l - z_h
//
// and with Theta = delta + z_l/s_l + z_h/s_h, W = 1/Theta, c_j = low z_l/s_l + high z_h/s_h, q the right side that
// is left when s and z are eliminated:
//
//   dy_j = W_j (q_j - u_j . d + c_j dy_i)
//   (I + sum_j W_j u_j u_j^T + sum_i sum_j W_i W_j c_j u_j u_i^T) d = sum_j dy_j(d = 0) u_j
//
// A disc (friction on the cone) bounds two rows t together. They stay inside, as t = R e with |e| < 1, have one
// multiplier z, and meet the circle at the end:
//
//   r = z e,  z R (1 - |e|^2) = target
//
// A step goes straight in t where R grows, and in e where it shrinks, because t and R go to zero together where a
// contact opens. Of the two directions of a disc the one across e
// has W = 1 / (delta + z/R), the one along e W = 1 / (delta + z/R (1 + |e|^2) / (1 - |e|^2)), and where R is h
// times the force of row i, c = 2 h |e| z/R / (1 - |e|^2). What a full step leaves of r = z e is of second order;
// the target goes to zero no faster than that.
//
// Without rows that follow, the problem is convex and its matrix symmetric, and the method gets to the answer of
// everything that has one. With them it is neither, and the method may be jammed between rows that wedge each
// other.
//
// Symbols as in unit_problem.h; s distances, z >= 0 multipliers of the bounds [sqrt(kg) m/s], delta a proximal
// parameter [1] around y as it is in a step, which makes redundant rows harmless; U x - t is -r.
#pragma once

#include "engine/solvers/exact/body_matrix.h"
#include "engine/solvers/exact/effort.h"
#include "engine/solvers/exact/unit_problem.h"
#include "engine/solvers/solver.h"

#include <vector>

namespace pushfactor::engine::solvers {

class InteriorPoint {
  public:
    // Improves y (within its bounds) until the natural residual is at most `tolerance` [m/s], falls no further, or
    // `steps` factorisations or the effort are used up. Returns the residual that was reached [m/s]; y is the best
    // that was seen among those that give the bodies no more energy than the guess or no force at all, and never
    // worse than it was.
    // `order` must connect the bodies of every row.
    double solve(const Elimination& order, const UnitProblem& problem, double tolerance, int steps,
                 std::vector<double>& y, Effort& effort, SolveCount& count);

  private:
    // One bound of a row on its way: its distance, multiplier, and the steps of both.
    struct Bound {
        bool is = false;  // whether there is one
        double s = 1.0, z = 0.0;
        double error = 0.0;  // p, by which the distance is not s
        double ds = 0.0, dz = 0.0;

        double ratio() const { return is ? z / s : 0.0; }
    };
    struct Point {
        double y = 0.0, dy = 0.0;
        double w = 0.0;    // W; 0 for a row that stays where it is
        double c = 0.0;    // c_j
        int leader = -1;   // whose step its bounds follow
        double own = 0.0;  // W q, its step while d and its leader's step are zero
        Bound low, high;
    };

    // A disc on its way. Steps as in Point; d is the direction of e.
    struct DiscPoint {
        std::size_t second = 0;   // its second row
        double per_leader = 0.0;  // h: what R grows by with its leader's force, if it has one
        bool follows = false;     // whether the leader is a row between the same bodies, whose step is unknown
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
    std::vector<Jacobian> pushed_;  // by row that others follow: u_i + sum_j W_j c_j u_j
    std::vector<double> y_, r_;
    BodyVelocities x_, d_, missed_;
    BestForces best_;
};

}  // namespace pushfactor::engine::solvers
