// The world: bodies, the parts that act on them, and the time step of the paper's algorithm.
#pragma once

#include "engine/base/threads.h"
#include "engine/bodies/integrator.h"
#include "engine/bodies/path.h"
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

// Observer of the phases of a step, for counting or timing.
class PhaseObserver {
  public:
    virtual ~PhaseObserver() = default;
    virtual void phase_ended(Phase phase) = 0;
};

// Statistics of one step.
struct StepCount {
    std::array<int, row_kind_count> rows_of_kind{};  // by RowKind
    int columns = 0;                 // 2 if any row has a single-frame correction, 1 otherwise, 0 without rows
    int islands = 0;                 // groups of bodies connected by rows
    int islands_kept = 0;            // whose last forces were accurate enough
    int islands_swept = 0;           // solved by sweeps or other iterations
    int islands_exact = 0;           // solved to rounding
    int islands_in_small_steps = 0;  // whose step was divided into small ones
    int islands_unsolved = 0;        // solved ones with a residual above the upper tolerance
    int islands_contradicting = 0;   // with rows that no forces can satisfy together, as found by an exact method
    int sweeps = 0;                  // iterations of the solver, on the island with the most of them
    double row_updates = 0.0;        // rows times columns times iterations, of all islands
    double multiply_adds = 0.0;      // of the solver
    int at_rest = 0;                 // bodies, after the step (rest.h)

    int rows() const { return std::accumulate(rows_of_kind.begin(), rows_of_kind.end(), 0); }
    int rows(RowKind kind) const { return rows_of_kind[static_cast<std::size_t>(kind)]; }
};

class World {
  public:
    // Parts of the world, all optional; a world without constraints needs no solver.
    std::vector<Body> bodies;
    std::vector<std::unique_ptr<ForceSource>> forces;
    std::vector<std::unique_ptr<ConstraintSource>> constraints;
    std::unique_ptr<solvers::Solver> solver;
    solvers::Termination termination;
    std::unique_ptr<SmallSteps> small_steps;  // for islands without an exact solution; null: solver iterations
    std::unique_ptr<Rest> rest;               // omits resting bodies from steps; null: off. Not for RATTLE.
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

    // The threads, if the last step was large enough to share; null: one thread is faster.
    Threads* threads_worth_calling() const;

    bool moves_any() const { return !moved_.empty(); }  // whether any body has a path

    double time() const { return time_; }  // s, sum of all steps
    double stored_energy() const;          // J, in springs

    // State carried from step to step besides the bodies and the memory of the sources: the time and this, one per
    // body. A new world with all of it continues bit-identically.
    void take_memory(std::vector<IslandSolver::Memory>& memory) const { island_solver_.take_memory(memory); }
    void resume(double time, std::span<const IslandSolver::Memory> memory);  // and Rest::set_memory()

    // Rows, system and solution of the last step; empty before the first.
    std::span<const ConstraintRow> rows() const { return rows_; }
    const SystemEquation& system() const { return system_; }
    const Columns& lambda() const { return lambda_; }

    // Islands of the last step, and how it solved one of them.
    const Islands& islands() const { return islands_; }
    WarmStart::Method method_of(const Island& island) const {
        return island_solver_.warm_start().method_of(island);
    }
    // Natural-map residual of the last step [m/s]. For an island in small steps that of the last small step: the
    // gaps of a whole step are no measure for it.
    double residual() const;
    const IslandSolver::Outcome& outcome_of(const Island& island) const {
        return island_solver_.outcome_of(island);
    }

  private:
    friend class RattleStep;  // another step, made of the same phases (rattle.h)

    void begin_paths(double dt);
    void follow_paths();
    void find_awake();
    void add_forces();
    void add_forces(const Awake& to);
    StepCount take_step(double dt, PhaseObserver* observer);
    StepStart start_of(double dt) const { return {bodies, dt, time_, sharing_}; }
    void append_rows(double dt);
    void append_unforeseen(double dt);
    void carry_rows(double dt);
    void guess(std::size_t first_row, Columns& lambda) const;
    SolveWork solve(const Island& island, Columns* first_guess, IslandSolver::Bench& bench);
    // Selects the islands that satisfy `predicate`.
    template <typename Predicate>
    void choose(const Predicate& predicate);
    // Calls `solve(island, bench)` for each selected island.
    template <typename Solve>
    SolveWork solve_chosen(const Solve& solve);
    void note_changed(const Island& island);
    // Solves all islands from the warm start of their rows and writes forces_.
    SolveWork solve_islands();
    // Solves islands with new rows again: these rows start from their warm start, the others from the current
    // solution.
    SolveWork solve_islands_again(std::size_t first_new_row);
    // Gives the remaining iterations to unsolved islands.
    SolveWork finish_islands();
    // Solves, and re-solves with additional rows as long as the solution moves bodies where no source foresaw them.
    SolveWork solve_and_look(double dt);
    // Wakes resting bodies that are pushed. The step then has to be started again.
    bool wakes_some();
    void remember();
    void find_next_guesses(const Island& island, const RowRun& run);
    void hand_out_answers();
    // In an island with one column, the forces that move its bodies are the lasting ones.
    bool has_lasting_force(std::size_t body) const;
    void integrate(double dt);
    void integrate(Body& body, std::size_t i, double dt);
    void find_what_turns_unseen();
    void settle(double dt);
    StepCount count(const SolveWork& work) const;

    // A static body with a path.
    struct Moved {
        std::size_t body;
        std::unique_ptr<const Path> path;
    };

    // Consecutive rows appended by one source.
    struct Appended {
        std::size_t source, begin, end;
    };

    double time_ = 0.0;
    std::vector<Moved> moved_;
    Threads* sharing_ = nullptr;      // in this step; null: too small, or no threads
    double shareable_work_ = 0.0;     // multiply-adds of the last step
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
    std::vector<NewForce> changed_;                    // one per body, change by the last solves
    std::vector<Lambda> answers_, answers_of_source_;  // warm start of the next step, one per row
    std::vector<Lambda> endings_;  // of rows of islands in small steps, forces of the last small step
    ConstraintForces forces_;
};

}  // namespace pushfactor::engine
