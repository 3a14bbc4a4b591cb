// Exact solution of a column in unit rows: active set method; if that fails interior point method, and then
// proximal points, twice. Internal to the solvers.
#pragma once

#include "engine/solvers/exact/active_set.h"
#include "engine/solvers/exact/effort.h"
#include "engine/solvers/exact/interior_point.h"
#include "engine/solvers/exact/structures.h"
#include "engine/solvers/unit_rows.h"

namespace pushfactor::engine::solvers {

// Largest speed that a row of the problem asks for without any forces [m/s].
double asked_speed(const UnitProblem& problem);

class ExactAnswer {
  public:
    ExactAnswer() = default;
    ExactAnswer(const ExactAnswer&) = delete;  // structure_ points into structures_
    ExactAnswer& operator=(const ExactAnswer&) = delete;

    // Looks up the connectivity of the island, whose columns share their axes and factor. To be called first.
    void take(const Island& island) {
        structure_ = &structures_.of(island);
        active_set_.start();
    }
    int pairs() const { return static_cast<int>(structure_->all_pairs.size()); }  // including static bodies

    // Plans the factorisation unless it takes more than `most_work` multiply-adds. To be called second.
    void plan(double most_work = infinity) { structures_.plan(*structure_, most_work); }

    // Multiply-adds of a factorisation and of what is done with it; may be infinite if that exceeds the plan's
    // limit.
    double step_work(const UnitRows& rows) const {
        return InteriorPoint::step_work(structure_->order, static_cast<double>(rows.rows.size()),
                                        rows.bounds_follow());
    }

    // Improves the forces until the natural residual is at most `tolerance` [m/s], or rounding, and says so;
    // what a few changes of the active set do not solve, until it is at most `will_do` [m/s], it stops falling or
    // the effort is used up; then count.contradicts may tell why. Never makes them worse.
    bool solve(UnitRows& rows, double tolerance, double will_do, Effort& effort, SolveCount& count);

  private:
    bool settle(double tolerance, double will_do, Effort& effort, SolveCount& count);
    bool contradicts();
    void solve_without_contradiction(double tolerance, Effort& effort, SolveCount& count);

    Structures structures_;
    Structure* structure_ = nullptr;  // of the current island
    ActiveSet active_set_;
    InteriorPoint interior_;
    UnitProblem problem_;
    std::vector<double> y_, r_, p_;
    BodyVelocities x_;
};

}  // namespace pushfactor::engine::solvers
