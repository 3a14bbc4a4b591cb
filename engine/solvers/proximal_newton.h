// The box-constrained problem of 6.2.9 to rounding, in the space of the bodies' velocities: proximal points, each
// found by a semismooth Newton method whose matrix has a 6 x 6 block a body (body_matrix.h).
//
// In unit rows (unit_rows.h), with x = U^T y and r = t - U x, one proximal step goes from y to
//
//   y' = clamp(y + rho (r - U d)),   where d = U^T (y' - y)
//
// which is the minimum of the problem with the term |y' - y|^2 / (2 rho) added: d is the zero of the gradient of a
// strongly convex, piecewise quadratic function of 6 numbers a body. Newton's matrix is I + rho sum u u^T over the
// rows that are not clamped. The term makes singular A harmless (redundant contacts), and it vanishes with y' - y:
// a few steps with the same matrix reach rounding. All is written in differences, so that large rho costs no
// digits.
//
// Symbols: y forces [sqrt(kg) m/s], x and d velocities [sqrt(kg) m/s], rho [1] proximal parameter, U rows of unit
// length. The literature calls the method the proximal augmented Lagrangian with semismooth Newton (Hermans,
// Themelis & Patrinos 2019 for quadratic programs).
#pragma once

#include "engine/solvers/body_matrix.h"
#include "engine/solvers/solver.h"

#include <limits>
#include <vector>

namespace pushfactor::engine::solvers {

// One column of the system in unit rows. Bounds are plain numbers here.
struct UnitProblem {
    struct Row {
        int a = 0, b = 0;  // bodies
        Vector6 axis_a = Vector6::Zero(), axis_b = Vector6::Zero();
        double t = 0.0, low = 0.0, high = 0.0;
        double scale = 0.0;  // m/s of a row for one unit of y; 0 for a row that cannot move anything
    };
    std::vector<Row> rows;
    std::size_t bodies = 0;
};

class ProximalNewton {
  public:
    // Takes the rows of all columns: they differ in t, and in bounds that follow another row. Plans the matrix,
    // which must outlive the use.
    ProximalNewton(BodyMatrix& matrix) : matrix_(matrix) {}

    // Forgets the factor: the axes are others now.
    void start() { factored_.clear(); }

    // Improves y (within its bounds) until the natural residual is at most `tolerance` [m/s], falls no further, or
    // `factorisations` are used up. Returns the residual that was reached [m/s]; y is the best that was seen
    // among those that give the bodies no more energy than the guess or no force at all.
    double solve(const UnitProblem& problem, double tolerance, int factorisations, std::vector<double>& y,
                 SolveCount& count);

    // Natural residual [m/s].
    double residual(const UnitProblem& problem, const std::vector<double>& y);

  private:
    using Velocities = std::vector<Vector6>;

    void follow(const UnitProblem& problem, const std::vector<double>& y);
    double objective(const UnitProblem& problem, const std::vector<double>& y) const;
    bool settle_active_set(const UnitProblem& problem, std::vector<double>& y, SolveCount& count);
    void proximal_step(const UnitProblem& problem, double rho, std::vector<double>& y, SolveCount& count);
    void factor(const UnitProblem& problem, double rho, SolveCount& count);
    double line_search(const UnitProblem& problem, double rho, const std::vector<double>& y, SolveCount& count);

    BodyMatrix& matrix_;
    int left_ = 0;  // factorisations

    Velocities x_, d_, step_;
    std::vector<double> r_, along_, step_along_;  // t - U x, U d, U step
    std::vector<char> active_, factored_;         // rows that are not clamped; those of the factor
    double factored_rho_ = 0.0;
};

}  // namespace pushfactor::engine::solvers
