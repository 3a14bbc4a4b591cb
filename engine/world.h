// The world: bodies, the parts that act on them, and the time step of the paper's algorithm.
#pragma once

#include "engine/base/threads.h"
#include "engine/bodies/integrator.h"
#include "engine/bodies/path.h"
#include "engine/constraints/constraint_source.h"
#include "engine/forces/force_source.h"
#include "engine/solvers/solver.h"
#include "engine/step/rest.h"
#include "engine/step/step_count.h"
#include "engine/step/step_rows.h"
#include "engine/step/step_solver.h"
#include "engine/system/islands.h"
#include "engine/system/system_equation.h"

#include <memory>
#include <span>
#include <vector>

namespace pushfactor::engine {

class Impacts;  // declared only: most scenes know nothing of collisions

enum class Phase { forces, rows, system, solve, remember, integrate };

// Observer of the phases of a step, for counting or timing.
class PhaseObserver {
  public:
    virtual ~PhaseObserver() = default;
    virtual void phase_ended(Phase phase) = 0;
};

class World {
  public:
    World();
    World(World&&) noexcept;
    World& operator=(World&&) noexcept;
    ~World();

    // Parts of the world, all optional; a world without constraints needs no solver.
    std::vector<Body> bodies;
    std::vector<std::unique_ptr<ForceSource>> forces;
    std::vector<std::unique_ptr<ConstraintSource>> constraints;
    std::unique_ptr<solvers::Solver> solver;
    solvers::Termination termination;
    std::unique_ptr<SmallSteps> small_steps;  // for islands without an exact solution; null: solver iterations
    std::unique_ptr<Rest> rest;               // omits resting bodies from steps; null: off. Not for RATTLE.
    std::unique_ptr<Impacts> impacts;         // in the order in which they happen; null: none. Not for RATTLE.
    std::unique_ptr<Threads> threads;         // share a step; null: one thread. Results are bit-identical
    OrientationStep rotate = rotate_splitting;

    // Lets the static body move along `path` from now on. Not for RATTLE.
    void move(int body, std::unique_ptr<const Path> path);

    // Advances by `dt` > 0 [s].
    StepCount step(double dt, PhaseObserver* observer = nullptr);

    // Solves for the current state like a step of `dt` [s], without moving anything; afterwards the sources know
    // their forces.
    void prepare(double dt);

    // Shifts the momenta back by half a step of `dt` [s], with all forces of the current state. Before the first
    // step this turns the integrator of 3.2 into the leapfrog, whose momenta are between the steps: second order
    // instead of first.
    void kick_back_half(double dt);

    // Before a step of `dt` [s] after one of `from`: moves the momenta, which belong half a step before the
    // positions, from half of the one to half of the other by the external forces.
    void change_step(double from, double dt);

    // The threads, if the last step was large enough to share; null: one thread is faster.
    Threads* threads_worth_calling() const;

    bool moves_any() const { return !moved_.empty(); }  // whether any body has a path

    double time() const { return time_; }  // s, sum of all steps
    double stored_energy() const;          // J, in springs

    // Continues a run at this time [s]. With the bodies and the forces of the sources of a world (and
    // Rest::memory()) a new one continues bit-identically.
    void resume(double time);

    // Rows, system and solution of the last step; empty before the first.
    std::span<const ConstraintRow> rows() const { return rows_.all(); }
    const SystemEquation& system() const { return system_; }
    const Columns& lambda() const { return step_solver_.lambda(); }

    // Islands of the last step, and how it solved one of them.
    const Islands& islands() const { return step_solver_.islands(); }
    const IslandSolver::Outcome& outcome_of(const Island& island) const { return step_solver_.outcome_of(island); }
    // Natural-map residual of the last step [m/s], see StepSolver::residual().
    double residual() const { return step_solver_.residual(system_, termination); }

    // Phases of a step and what they work on, for steps of other kinds (rattle.h).
    void find_awake(double dt);
    void add_forces(double dt);
    void remember();
    void pass_time(double dt) { time_ += dt; }
    StepCount count(const SolveWork& work) const;
    StepProblem problem() {
        return {
            bodies, system_, solver.get(), termination, small_steps.get(), sharing_, rows_.sources_of(constraints)};
    }
    StepRows& step_rows() { return rows_; }
    SystemEquation& step_system() { return system_; }
    StepSolver& step_solver() { return step_solver_; }

  private:
    void begin_paths(double dt);
    void follow_paths();
    void add_forces(const Awake& to, double dt);
    StepCount take_step(double dt, PhaseObserver* observer);
    StepStart start_of(double dt) const { return {bodies, dt, time_, rotate, sharing_, up(), strayed_}; }
    Vector3 up() const;
    void append_rows(double dt);
    // Lets bodies that hit each other fly through the step. Returns false if they hit resting ones, which are awake
    // then.
    bool take_impacts(double dt);
    void stray(int body, double dt);
    void put_back();
    // Appends rows where the solution moves bodies as no source foresaw. Returns whether there were any.
    bool append_unforeseen(double dt);
    void carry_rows(double dt);
    // Solves, and re-solves with additional rows where the solution moves bodies into each other.
    SolveWork solve_and_look(double dt);
    // Wakes resting bodies that are pushed. The step then has to be started again.
    bool wakes_some();
    void integrate(double dt);
    void integrate(Body& body, std::size_t i, double dt);
    void find_what_turns_unseen();
    void settle(double dt);

    // A static body with a path.
    struct Moved {
        std::size_t body;
        std::unique_ptr<const Path> path;
    };

    double time_ = 0.0;
    std::vector<Moved> moved_;
    Threads* sharing_ = nullptr;      // in this step; null: too small, or no threads
    double shareable_work_ = 0.0;     // multiply-adds of the last step
    Awake awake_;                     // bodies
    std::vector<Strayed> strayed_;    // bodies that have been followed in this step
    std::vector<Body> before_;        // the same at its start
    std::vector<char> turns_unseen_;  // by body; with a Rest
    StepRows rows_;
    SystemEquation system_;
    StepSolver step_solver_;
};

}  // namespace pushfactor::engine
