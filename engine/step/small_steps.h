// A step of one island in small ones: the rows and their axes of the whole step, in n small steps of k sweeps each.
//
//   x <- x + h M^(-1/2)^T f_ext + (what the rows did in the small step before)      3.2.1, 6.2.3
//   k times, and 4 k in the last: y_j <- clamp(y_j + t_j - u_j . x), x along        7.1.1
//   d <- d + h x
//
// with h = dt / n. A force has to hold a velocity error of g h only, and what is left over is seen again in the
// next small step, so that load travels through a tower as a wave, a layer a sweep, where the sweeps of a whole
// step spread it like heat.
//
// Symbols: x velocity and d displacement of a body with the root of its mass, M^(1/2) v [sqrt(kg) m/s] and
// [sqrt(kg) m]; u_j, y_j, t_j as in solvers/unit_rows.h. A row that is still open has t_j = -gap / h, with the gap
// that is left after d; one that has closed aims at rest, and friction at the speed of its belt.
//
// The means over the small steps would take a body as far as a constant force does, d = dt v + dt^2 a / 2, where a
// whole step has dt v + dt^2 a (3.2): with axes that are those of the start, the former is an explicit step, and
// what swings or rolls in a hollow would get faster with every swing. So what the step and its end have in common
// of an acceleration is added to d as if it had acted from the beginning.
//
// The single-frame push (8.1) is apart: after the last small step the contact and distance rows, but no friction,
// find a displacement that takes off the share `beta` of what overlaps. It is no velocity of any small step. As
// a column of the system it lifts bodies by more than they overlap while it is not solved, and gravity makes
// energy of the height.
//
// Not from the paper. The bodies are moved by World as ever: what comes out are the forces of a whole step that
// would move them so.
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

// f_c = J^T lambda of both columns [N and N m, one per body]: what moves the bodies, and what sets their momenta.
// The second one only for bodies whose island has two columns or has taken small steps.
struct ConstraintForces {
    std::vector<Vector6> moving, lasting;
};

class SmallSteps {
  public:
    using Division = SmallStepDivision;

    // With a division, every island takes that one.
    explicit SmallSteps(const std::optional<Division>& division = {}) : division_(division) {}

    // One that does the same, for another thread.
    std::unique_ptr<SmallSteps> another() const { return std::make_unique<SmallSteps>(division_); }

    // That division, or without one what suits the island, whose guess has this residual [m/s].
    Division division_of(double dt, std::span<const Body> bodies, const Island& island, double residual) const {
        return division_ ? *division_ : small_step_rules::division_of(dt, bodies, island, residual);
    }

    // Takes the island through the step of `system`, from the forces in the last column of `lambda` [N], which
    // receives their means over the step: in the first column with those of the push, in the last one without.
    // Writes what its bodies are moved by, and into `ending` (by row of the step) what the next step begins with
    // [N]. `threads` share the work; null: one thread.
    solvers::SolveCount solve(const SystemEquation& system, std::span<const Body> bodies, const Island& island,
                              const Division& division, Threads* threads, Columns& lambda, ConstraintForces& forces,
                              std::span<Lambda> ending);

    // What the rows still get wrong at the end of the last one [m/s], each with what it aims at there.
    double residual() const { return residual_; }

  private:
    // A row that acts one way, and not while it is open.
    struct OneSided {
        std::size_t row;   // number in the island
        double error;      // m, at the start of the step
        double open_side;  // 1 where it is open above an error of zero, -1 below
    };
    // A row that takes part in the push.
    struct Pushed {
        std::size_t row;  // number in the island
        int of_step;      // number in the step
        double want;      // sqrt(kg) m
    };
    // What one thread knows of a part of the island. Not in the cache lines of another one.
    struct alignas(64) PartState {
        std::vector<solvers::UnitRows<1>::Block> blocks{};
        std::vector<OneSided> one_sided{};
        std::vector<Pushed> pushed{};
        bool drives = false;     // whether some row brings energy by itself
        bool is_pushed = false;  // whether the push moves some row
        double residual = 0.0;   // m/s
    };
    // Sums over the bodies of a leaf: their order does not depend on the threads.
    struct alignas(64) LeafSums {
        double gain = 0.0;                  // J
        double along = 0.0, squared = 0.0;  // impulse with base_, and with itself [J]
    };
    // The step at hand.
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
    void small_step(const Step& step, int sweeps, Team& team);
    void aim(double h, const Part& part);
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
    Dissection dissection_;  // of the island at hand
    solvers::UnitRows<1> rows_;
    std::vector<PartState> states_;
    std::vector<LeafSums> sums_;
    // By movable body of the island:
    std::vector<Vector6> start_;    // x at the start of the step
    std::vector<Vector6> pull_;     // x that the external forces add in a small step
    std::vector<Vector6> base_;     // x before the rows act
    std::vector<Vector6> impulse_;  // x that the rows have added in the last small step
    std::vector<Vector6> moved_;    // d
    // By row of the island:
    std::vector<double> before_;  // y of the small step before the last one
    std::vector<double> kept_;    // share of y, while hits are forgotten
    std::vector<double> sum_;     // of y over the small steps
};

}  // namespace pushfactor::engine
