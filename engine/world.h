// The world: bodies and the parts that act on them, and the step that makes the paper's algorithm of them.
#pragma once

#include "engine/integrator.h"
#include "engine/solvers/solver.h"
#include "engine/sources.h"
#include "engine/system_equation.h"

#include <array>
#include <memory>
#include <numeric>
#include <vector>

namespace pushfactor::engine {

enum class Stage { forces, rows, system, solve, remember, integrate };

// Is told when a stage of a step has ended, for whoever wants to count or to time.
class StageObserver {
  public:
    virtual ~StageObserver() = default;
    virtual void stage_ended(Stage stage) = 0;
};

// What one step did.
struct StepCount {
    std::array<int, row_kind_count> rows_of_kind{};  // by RowKind
    int columns = 0;             // 2 when some row corrected for a single frame, 1 otherwise, 0 without rows
    int sweeps = 0;              // iterations of the solver
    double multiply_adds = 0.0;  // of the solver

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
    OrientationStep rotate = rotate_splitting;

    // Advances by dt [s], above zero.
    StepCount step(double dt, StageObserver* observer = nullptr);

    // Solves for the state as it is, as a step of dt [s] would, and moves nothing: the sources know their forces
    // then.
    void prepare(double dt);

    // Half a step of dt [s] backwards for the momenta alone, with all forces of the state as it is. Before the
    // first step of a scene it makes the integrator of 3.2 the leapfrog, whose momenta belong between the steps:
    // second order instead of first.
    void kick_back_half(double dt);

    double time() const { return time_; }  // s, sum of all steps

    // What a world carries from step to step beside its bodies and what its sources remember. With all three a
    // world that was made anew goes on as the old one would have.
    struct Memory {
        double time = 0.0;       // s
        bool was_exact = false;  // whether the last step was solved, and to rounding
        int kept = 0;            // steps since the last solve
    };
    Memory memory() const { return {time_, was_exact_, kept_}; }
    void set_memory(const Memory& memory);

    // The rows, the system and its answer of the last step; empty before the first.
    std::span<const ConstraintRow> rows() const { return rows_; }
    const SystemEquation& system() const { return system_; }
    const Columns& lambda() const { return lambda_; }

  private:
    friend class RattleStep;  // another step, made of the same stages (rattle.h)

    void add_forces();
    void append_rows(double dt);
    solvers::SolveCount solve();
    // Solves, and again with more rows while the answer takes bodies where no source foresaw them. Writes moving_.
    solvers::SolveCount solve_and_look(double dt);
    bool foresaw(double dt);
    void remember();
    void integrate(double dt);
    StepCount count(const solvers::SolveCount& solved) const;

    double time_ = 0.0;
    int kept_ = 0;               // steps since the last solve
    int kept_before_ = 0;        // the same of the step before
    bool was_exact_ = false;     // whether the last step was solved, and to rounding
    bool contradicted_ = false;  // whether its rows had no answer
    std::vector<ConstraintRow> rows_;
    std::vector<std::size_t> row_ends_;  // one a constraint source
    SystemEquation system_;
    Columns lambda_;
    std::vector<Lambda> answers_;
    std::vector<Vector6> moving_;   // f_cv = J^T Lambda.first, N and N m
    std::vector<Vector6> lasting_;  // f_c0 = J^T Lambda.last
};

}  // namespace pushfactor::engine
