// The world: bodies and the parts that act on them, and the step that makes the paper's algorithm of them.
#pragma once

#include "engine/base/threads.h"
#include "engine/bodies/integrator.h"
#include "engine/constraints/constraint_source.h"
#include "engine/forces/force_source.h"
#include "engine/solvers/solver.h"
#include "engine/step/benches.h"
#include "engine/step/island_solver.h"
#include "engine/step/rest.h"
#include "engine/system/islands.h"
#include "engine/system/system_equation.h"

#include <algorithm>
#include <array>
#include <memory>
#include <numeric>
#include <vector>

namespace pushfactor::engine {

enum class Phase { forces, rows, system, solve, remember, integrate };

// Is told when a stage of a step has ended, for whoever wants to count or to time.
class PhaseObserver {
  public:
    virtual ~PhaseObserver() = default;
    virtual void phase_ended(Phase stage) = 0;
};

// What one step did.
struct StepCount {
    std::array<int, row_kind_count> rows_of_kind{};  // by RowKind
    int columns = 0;                 // 2 when some row corrected for a single frame, 1 otherwise, 0 without rows
    int islands = 0;                 // of bodies that rows join
    int islands_kept = 0;            // whose last forces were good enough
    int islands_swept = 0;           // that were solved by sweeps, or other iterations
    int islands_exact = 0;           // that were solved to rounding
    int islands_in_small_steps = 0;  // that went through the step in small ones
    int islands_unsolved = 0;        // of those that were worked on, with more than the upper tolerance left
    int islands_contradicting = 0;   // in which an exact method found rows that no forces can satisfy together
    int sweeps = 0;                  // iterations of the solver, on the island with the most of them
    double row_updates = 0.0;        // rows times columns times iterations, of all islands
    double multiply_adds = 0.0;      // of the solver
    int at_rest = 0;                 // bodies, after the step (rest.h)

    int rows() const { return std::accumulate(rows_of_kind.begin(), rows_of_kind.end(), 0); }
    int rows(RowKind kind) const { return rows_of_kind[static_cast<std::size_t>(kind)]; }
};

class World {
  public:
    // The parts. A scene fills in what it needs and nothing else; a world without constraints needs no solver.
    std::vector<Body> bodies;
    std::vector<std::unique_ptr<ForceSource>> forces;
    std::vector<std::unique_ptr<ConstraintSource>> constraints;
    std::unique_ptr<solvers::Solver> solver;
    solvers::Termination termination;
    std::unique_ptr<SmallSteps> small_steps;  // for islands without an exact answer; null: iterations of the solver
    std::unique_ptr<Rest> rest;  // what leaves out of steps what rests; null: nothing is left out. Not for RATTLE.
    std::unique_ptr<Threads> threads;  // that share a step; null: one. The bits do not depend on it
    OrientationStep rotate = rotate_splitting;

    // Advances by dt [s], above zero.
    StepCount step(double dt, PhaseObserver* observer = nullptr);

    // Solves for the state as it is, as a step of dt [s] would, and moves nothing: the sources know their forces
    // then.
    void prepare(double dt);

    // Half a step of dt [s] backwards for the momenta alone, with all forces of the state as it is. Before the
    // first step of a scene it makes the integrator of 3.2 the leapfrog, whose momenta belong between the steps:
    // second order instead of first.
    void kick_back_half(double dt);

    // Those that are worth calling for a state like that after the last step; null: one thread does better.
    Threads* threads_worth_calling() const;

    double time() const { return time_; }  // s, sum of all steps

    // What a world carries from step to step beside its bodies and what its sources remember: the time and this,
    // one per body. With all of it a world that was made anew goes on as the old one would have.
    void take_memory(std::vector<IslandSolver::Memory>& memory) const { island_solver_.take_memory(memory); }
    void resume(double time, std::span<const IslandSolver::Memory> memory);  // and Rest::set_memory()

    // The rows, the system and its answer of the last step; empty before the first.
    std::span<const ConstraintRow> rows() const { return rows_; }
    const SystemEquation& system() const { return system_; }
    const Columns& lambda() const { return lambda_; }

    // The islands of the last step, and what it did with one of them.
    const Islands& islands() const { return islands_; }
    WarmStart::Method method_of(const Island& island) const {
        return island_solver_.warm_start().method_of(island);
    }
    // Natural-map residual of the last step [m/s]. An island that took small steps has that of the last of them:
    // the gaps of a whole step are no measure for it.
    double residual() const;
    const IslandSolver::Outcome& outcome_of(const Island& island) const {
        return island_solver_.outcome_of(island);
    }

  private:
    friend class RattleStep;  // another step, made of the same stages (rattle.h)

    void find_awake();
    void add_forces();
    void add_forces(const Awake& to);
    StepCount take_step(double dt, PhaseObserver* observer);
    StepStart start_of(double dt) const { return {bodies, dt, time_, sharing_}; }
    void append_rows(double dt);
    void append_unforeseen(double dt);
    void guess(std::size_t first_row, Columns& lambda) const;
    SolveWork solve(const Island& island, Columns* first_guess, IslandSolver::Bench& bench);
    // Chooses the islands of which `predicate` says so.
    template <typename Predicate>
    void choose(const Predicate& predicate);
    // Calls `solve(island, bench)` with each island that is chosen.
    template <typename Solve>
    SolveWork solve_chosen(const Solve& solve);
    void note_changed(const Island& island);
    // Solves all islands from the guesses of their rows and writes forces_.
    SolveWork solve_islands();
    // Solves the islands with new rows once more, these rows from their guesses and the others from what has been
    // found.
    SolveWork solve_islands_again(std::size_t first_new_row);
    // Gives the islands that are not solved the iterations that are left.
    SolveWork finish_islands();
    // Solves, and again with more rows while the answer takes bodies where no source foresaw them.
    SolveWork solve_and_look(double dt);
    // Wakes what is pushed at rest. The step has to begin anew then.
    bool wakes_some();
    void remember();
    void find_next_guesses(const Island& island, const RowRun& run);
    void hand_out_answers();
    // Where an island has one column, the forces that move its bodies are those that last.
    bool has_lasting_force(std::size_t body) const;
    void integrate(double dt);
    void integrate(Body& body, std::size_t i, double dt);
    void find_what_turns_unseen();
    void settle(double dt);
    StepCount count(const SolveWork& work) const;

    // The rows that a source has appended together.
    struct Appended {
        std::size_t source, begin, end;
    };

    double time_ = 0.0;
    Threads* sharing_ = nullptr;      // this step; null: it is too small, or there are none
    double shareable_work_ = 0.0;     // multiply-adds, of the last step
    Awake awake_;                     // bodies
    std::vector<char> turns_unseen_;  // by body; with a Rest
    RowList rows_;
    std::vector<Appended> appended_;
    SystemEquation system_;
    Islands islands_;
    IslandSolver island_solver_;
    Benches benches_;
    std::vector<int> chosen_;  // islands to be solved, by number
    Columns lambda_, first_guess_;
    std::vector<NewForce> changed_;                    // one per body, what the last solves may have given it
    std::vector<Lambda> answers_, answers_of_source_;  // what the next step begins with, one per row
    std::vector<Lambda> endings_;  // of rows whose islands were in small steps, the forces of the last one
    ConstraintForces forces_;
};

}  // namespace pushfactor::engine
