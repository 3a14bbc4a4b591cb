// Divides the step of one island into n small steps of k sweeps each, with the rows and axes of the whole step.
//
//   x <- x + h M^(-1/2)^T f_ext + (impulses of the rows in the previous small step)      3.2.1, 6.2.3
//   k times, and 4 k in the last: y_j <- clamp(y_j + t_j - u_j . x), x along             7.1.1
//   d <- d + h x
//
// with h = dt / n. A force then only has to hold a velocity error of g h, and the next small step sees what is
// left, so load travels through a tower like a wave, one layer per sweep, while sweeps of a whole step spread it
// like heat.
//
// Symbols: x velocity and d displacement of a body scaled by the square root of its mass, M^(1/2) v [sqrt(kg) m/s]
// and [sqrt(kg) m]; u_j, y_j, t_j as in solvers/unit_rows.h. An open row has t_j = -gap / h, with the gap that
// remains after d; a closed one aims at rest, and friction at the speed of its belt. Where a body is moved (path.h)
// all of this is relative to it.
//
// The means over the small steps would move a body like a constant force, d = dt v + dt^2 a / 2, while a whole step
// gives dt v + dt^2 a (3.2). With the axes of the start of the step the former is an explicit step, and bodies that
// swing or roll in a hollow would gain speed with every swing. So the acceleration common to the whole step and its
// end is added to d as if it had acted from the beginning.
//
// The single-frame push (8.1) is separate: after the last small step the contact and distance rows, without
// friction, solve for a displacement that removes the share `beta` of the overlap. It is not part of any small
// step's velocity. As a column of the system it lifts bodies by more than they overlap while it is unsolved, and
// gravity turns the height into energy.
//
// Not from the paper. World moves the bodies as usual: the result are the forces of a whole step that would give
// this motion.
#pragma once

#include "engine/base/threads.h"
#include "engine/solvers/solver.h"
#include "engine/solvers/unit_rows.h"
#include "engine/step/small_step_rules.h"
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

class SmallSteps {
  public:
    using Division = SmallStepDivision;

    // If given, `division` is used for every island.
    explicit SmallSteps(const std::optional<Division>& division = {}) : division_(division) {}

    // A copy for another thread.
    std::unique_ptr<SmallSteps> another() const { return std::make_unique<SmallSteps>(division_); }

    // The fixed division, or one suited to the island, whose warm start has this residual [m/s].
    Division division_of(double dt, std::span<const Body> bodies, const Island& island, double residual) const {
        return division_ ? *division_ : small_step_rules::division_of(dt, bodies, island, residual);
    }

    // Advances the island through the step of `system`, with the last column of `lambda` as warm start [N].
    // `lambda` receives the means over the step: with the push in the first column, without it in the last. Writes
    // the forces on the bodies, and the warm start of the next step into `ending` (by row of the step) [N].
    // `threads` share the work; null: one thread.
    solvers::SolveCount solve(const SystemEquation& system, std::span<const Body> bodies, const Island& island,
                              const Division& division, Threads* threads, Columns& lambda, ConstraintForces& forces,
                              std::span<Lambda> ending);

    // Residual of the rows at the end of the last small step [m/s], with respect to its targets.
    double residual() const { return residual_; }

  private:
    // A one-sided row, inactive while it is open.
    struct OneSided {
        std::size_t row;   // number in the island
        double error;      // m, at the start of the step
        double carried;    // m/s, see SystemEquation
        double open_side;  // 1 if it is open for errors above zero, -1 if below
    };
    // A row that takes part in the push.
    struct Pushed {
        std::size_t row;  // number in the island
        int of_step;      // number in the step
        double want;      // sqrt(kg) m
    };
    // State of a part of the island, on cache lines of its own.
    struct alignas(64) PartState {
        std::vector<solvers::UnitRows<1>::Block> blocks{};
        std::vector<OneSided> one_sided{};
        std::vector<Pushed> pushed{};
        bool drives = false;     // some row adds energy by itself
        bool is_pushed = false;  // the push moves some row
        double residual = 0.0;   // m/s
    };
    // Sums over the bodies of a leaf, in an order independent of the threads.
    struct alignas(64) LeafSums {
        double gain = 0.0;                  // J
        double along = 0.0, squared = 0.0;  // impulse times base_, and squared [J]
    };
    // Arguments of the current step.
    struct Step {
        const SystemEquation& system;
        std::span<const Body> bodies;
        Division division;
        double h;  // s
        Columns& lambda;
        ConstraintForces& forces;
        std::span<Lambda> ending;
    };
    using Part = Dissection::Part;

    void size(const Island& island);
    void work(const Step& step, Team& team);
    void load(const Step& step, Team& team);
    void begin(const Step& step, Team& team);
    void small_step(const Step& step, int number, Team& team);
    void aim(double h, double elapsed, const Part& part);
    double impulse_gain(std::size_t body) const;
    double gain(Team& team);
    void forget_hits(Team& team);
    void keep_hits_of(const Part& part);
    void kick_at_once(const Step& step, Team& team);
    void store(const Step& step, Team& team);
    void push_apart(const Step& step, Team& team);
    void plan_push(const Step& step, const Part& part);
    void write_moving_forces(const Step& step, Team& team) const;
    double moved_along(const solvers::UnitRows<1>::Row& row) const;
    template <typename Visit>
    void each_row(const Part& part, const Visit& visit) const;
    template <typename Visit>
    void each_body(Team& team, const Visit& visit) const;
    PartState& state_of(const Part& part) { return states_[dissection_.number_of(part)]; }

    std::optional<Division> division_;
    double residual_ = 0.0;
    Dissection dissection_;  // of the current island
    solvers::UnitRows<1> rows_;
    std::vector<PartState> states_;
    std::vector<LeafSums> sums_;
    // By movable body of the island:
    std::vector<Vector6> start_;    // x at the start of the step
    std::vector<Vector6> pull_;     // x added by the external forces per small step
    std::vector<Vector6> base_;     // x before the rows act
    std::vector<Vector6> impulse_;  // x added by the rows in the last small step
    std::vector<Vector6> moved_;    // d
    // By row of the island:
    std::vector<double> before_;  // y of the small step before the last one
    std::vector<double> kept_;    // share of y that is kept in forget_hits()
    std::vector<double> sum_;     // of y over the small steps
};

}  // namespace pushfactor::engine
