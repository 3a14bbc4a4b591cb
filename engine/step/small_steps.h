// The step of one island in n small steps: section 8.1 of the paper n times, one column after the other.
//
//   n times with h = dt / n:
//     x <- x + h M^(-1/2)^T f_ext + (impulses of the rows in the small step before)        3.2.1, 6.2.3
//     follow: gaps of the rows, and axes of bars and joints, where the bodies are now
//     sweeps: y_j <- clamp(y_j + t_j - u_j . x), x along, with the push in t_j             7.1.1, f_cv of 8.1
//     d <- d + h x                                                                         3.2.3
//     sweeps without the push, in the opposite order                                       f_c0 of 8.1
//
// The first solve moves the bodies, the second one sets their momenta and is where the next small step starts. A
// force has to hold a velocity error of g h only, and the next small step sees what is left, so load travels
// through a tower by one layer per sweep; and an error of position is noticed within the step, so sweeps that have
// not converged end in a small compression instead of a motion.
//
// Both solves together are one symmetric sweep. In one direction only, small step after small step, what the order
// of the rows favours would grow: stacks of thin plates tremble by 3 cm/s for ever if the corners of each plate
// come one after the other around it.
//
// Sweeps go on while some row changes its velocity by more than a dozen times what the external forces of a small
// step cause, on the bodies of such rows alone: load may travel on in the next small step, a collision may not,
// because what is hit would first move into what is behind it.
//
// Symbols: x velocity and d displacement of a body scaled by the square root of its mass, M^(1/2) v [sqrt(kg) m/s]
// and [sqrt(kg) m]; u_j, y_j, t_j as in solvers/unit_row.h; e error of a row [m].
//
//   open row (gap, loose rope)   t = -e / h in both solves: it may close
//   closed row, bar, joint       t = -r e / h with the push, 0 without it
//   its share r                  beta / n; of one-sided rows less where t would exceed the speed of a step
//   others                       t = their lasting push: belts, motors, springs
//
// With the push a row also gives way to its force, y <- (1 - s) (y + t - u . x) with s / (1 - s) = r / stiffness: a
// row that carries a body at rest is a stiff, strongly damped spring, which the other rows can overrule. A rigid
// push that sweeps have not solved throws bodies up. At rest a row that carries m kg is compressed by g h^2 /
// stiffness. Where a body is moved (path.h) all of this is relative to it.
//
// What the second solve has not taken off again stays in the momenta. So the push of closed one-sided rows is at
// most the speed that a step of external forces causes, which carries any load; overlaps deeper than the slop are
// corrected by beta after the last small step, with a displacement alone.
//
// Not from the paper. World moves the bodies as usual: the result are the forces of a whole step that would give
// this motion.
#pragma once

#include "engine/base/threads.h"
#include "engine/solvers/solver.h"
#include "engine/solvers/unit_rows.h"
#include "engine/step/aim.h"
#include "engine/step/part_sweeps.h"
#include "engine/step/step_rows.h"
#include "engine/system/dissection.h"
#include "engine/system/islands.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace pushfactor::engine {

// f_c = J^T lambda of both columns [N and N m, one per body]: `moving` moves the bodies, `lasting` sets their
// momenta. `lasting` is set only for bodies whose island has two columns or has taken small steps.
struct ConstraintForces {
    std::vector<Vector6> moving, lasting;
};

struct SmallStepDivision {
    int steps = 1;
    int sweeps = 1;  // of each of both solves, at least
};

class SmallSteps {
  public:
    using Division = SmallStepDivision;

    // If given, `division` is used for every island.
    explicit SmallSteps(const std::optional<Division>& division = {}) : division_(division) {}

    // A copy for another thread.
    std::unique_ptr<SmallSteps> another() const { return std::make_unique<SmallSteps>(division_); }

    // The fixed division, or one suited to the island (choice.h).
    Division division_of(const SystemEquation& system, std::span<const Body> bodies, const Island& island) const;

    // Advances the island through the step of `system`, with the last column of `lambda` as warm start [N].
    // `lambda` receives the means over the step: with the push in the first column, without it in the last. Writes
    // the forces on the bodies, and the warm start of the next step into `ending` (by row of the step) [N].
    // `sources` have appended the rows; `threads` share the work; null: one thread.
    solvers::SolveCount solve(const SystemEquation& system, std::span<const Body> bodies, const Island& island,
                              const Division& division, const RowSources& sources, Threads* threads,
                              Columns& lambda, ConstraintForces& forces, std::span<Lambda> ending);

    // Residual of the rows at the end of the last small step [m/s], with respect to its targets.
    double residual() const { return residual_; }

  private:
    using Part = Dissection::Part;

    // A row that holds a place, one-sided or not, and is in no four.
    struct Holding {
        std::size_t row;               // number in the island
        int of_step;                   // number in the step
        const Correction* correction;  // of its errors
        double start, error;           // m, at the start of the step, and now
        double carried;                // m/s, see SystemEquation
        double open_side;              // 1 if it is open for errors above zero, -1 if below, 0 if never
        bool is_followed;
    };
    // Rows that are written again where the bodies are now: consecutive ones of a bar or a joint.
    struct Followed {
        const ConstraintSource* source;
        std::size_t first_row;      // number in the island
        int of_step, count;         // first row of the step, and how many
        std::size_t first_holding;  // the first of those of its rows that hold a place
    };
    // State of a part of the island, on cache lines of its own.
    struct alignas(64) PartState {
        PartSweeps sweeps{};  // its rows
        std::vector<Holding> holding{};
        std::vector<Followed> followed{};
        RowList rows{};          // of one of `followed`
        double aimed = 0.0;      // rows that hold a place
        bool is_pushed = false;  // some row is to be displaced
        double residual = 0.0;   // m/s
        double change = 0.0;     // m/s, the largest of a row in the last sweep
        double updates = 0.0;    // of rows in the step, beside those of whole sweeps
    };
    // Arguments of the current step.
    struct Step {
        const SystemEquation& system;
        std::span<const Body> bodies;
        Division division;
        const RowSources& sources;
        double h;        // s
        double fastest;  // m/s, push of one-sided rows
        Columns& lambda;
        ConstraintForces& forces;
        std::span<Lambda> ending;
    };
    enum class Solve { with_push, without_push };

    void size(const Island& island, bool has_detours);
    void work(const Step& step, Team& team);
    void load(const Step& step, Team& team);
    void begin(const Step& step, Team& team);
    void begin(const Step& step, const Part& part);
    void small_step(const Step& step, int number, Team& team);
    void solve(const Step& step, Solve which, double elapsed, Team& team);
    void aim(const Aim& aim, const Part& part);
    void follow(const Step& step, const Part& part);
    void follow(const Step& step, const Followed& followed, PartState& state);
    Body placed(const Step& step, int number, int body) const;
    void push_apart(const Step& step, Team& team);
    void plan_push(const Step& step, const Part& part);
    void push_apart(PartState& state);
    void store(const Step& step, const Part& part);
    void write_forces(const Step& step, Team& team) const;
    double moved_along(const solvers::UnitRow& row) const;
    void add_impulse(const solvers::UnitRow& row, double y);
    template <typename Visit>
    void each_body(Team& team, const Visit& visit) const;
    PartState& state_of(const Part& part) { return states_[dissection_.number_of(part)]; }

    std::optional<Division> division_;
    double residual_ = 0.0;
    Dissection dissection_;  // of the current island
    solvers::UnitRows rows_;
    std::vector<PartState> states_;
    // By movable body of the island:
    std::vector<Vector6> pull_;     // x added by the external forces per small step
    std::vector<Vector6> base_;     // x before the rows act
    std::vector<Vector6> impulse_;  // x added by the rows in the last solve
    std::vector<Vector6> moved_;    // d
    std::vector<Vector6> detours_;  // x that moves it besides, in the solve with push alone; empty without any
    std::vector<int> stirred_;      // see PartSweeps
    std::vector<int> scratch_;
    // By row of the island that is in no four, impulses of the step so far [N s]: with the push, without it.
    std::vector<double> pushing_, lasting_;
};

}  // namespace pushfactor::engine
