#include "engine/rattle.h"

#include "engine/base/invalid_input.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pushfactor::engine {

namespace {

// Position errors below this are not iterated further; the lengths of a scene are rounded to about that.
constexpr double exact = 1e-13;  // m
// Four are enough for exact solvers; the rest is for iterative solvers and coupled rows.
constexpr int most_repetitions = 50;

void require_bars(std::span<const ConstraintRow> rows) {
    for (std::size_t j = 0; j < rows.size(); ++j) {
        const Bounds& bounds = rows[j].bounds;
        const bool unlimited = bounds.of_row < 0 && std::isinf(bounds.c_min) && std::isinf(bounds.c_max);
        if (unlimited && rows[j].softness == 0.0 && rows[j].label.kind != RowKind::motor) continue;
        throw InvalidInput("bounds of row", std::to_string(j), "infinite and rigid: RATTLE is for bars alone");
    }
}

double whole(const PushFactor& push) {
    return push.correcting + push.lasting;
}

}  // namespace

// State of one step. Between two moves of a composition the velocity stage is omitted, and the second half kick of
// one and the first of the next are merged: the next move removes from the momenta what the stage would have
// removed.
class RattleStep {
  public:
    explicit RattleStep(World& world)
        : world_(world), system_(world.step_system()), solver_(world.step_solver()), ahead_(world.bodies) {}

    // Takes the rows at the beginning of the step.
    void begin(double dt) {
        if (world_.moves_any()) throw InvalidInput("bodies with a path", "some", "none: RATTLE moves none");
        world_.find_awake(0.0);
        world_.step_rows().append(world_.constraints, {world_.bodies, dt, world_.time()});
        require_bars(world_.rows());
    }

    // Kick over the time `kick` such that the bodies, after a drift over the time `drift`, satisfy the bars;
    // iterates per island.
    void move(double kick, double drift) {
        prepare(kick);
        find_islands();
        look_ahead(kick, drift);
        // If every row were within the tolerance, the solver would keep the warm start, which is zero.
        const double enough = std::max(exact, world_.termination.tolerance_high * std::abs(drift));
        for (int i = 0; i < most_repetitions && !end_moves(enough, i == 0); ++i) {
            correct(kick);
            look_ahead(kick, drift);
        }
        std::copy(ahead_.begin(), ahead_.end(), world_.bodies.begin());
        std::swap(world_.step_rows().list(), rows_ahead_);
        world_.pass_time(drift);
    }

    // Last kick: projects the momenta so that bars have no velocity along themselves.
    StepCount finish(double kick) {
        for (ConstraintRow& row : world_.step_rows().list()) row.push = {};
        prepare(kick);
        find_islands();
        for (Move& move : moves_) move.ended = false;
        solve_open_islands(solver_.lambda());
        world_.remember();
        kick_ahead(kick);
        for (std::size_t i = 0; i < ahead_.size(); ++i) {
            world_.bodies[i].linear_momentum = ahead_[i].linear_momentum;
            world_.bodies[i].angular_momentum = ahead_[i].angular_momentum;
        }
        return world_.count(work_);
    }

  private:
    void prepare(double kick) {
        world_.add_forces(0.0);
        build_system(world_.bodies, world_.rows(), kick, system_);
        system_.dt = std::abs(kick);  // scale of the solvers' residuals; b has the sign
    }

    // The bars connect the same bodies throughout the step, and all rows have one column. Each step solves for its
    // positions from scratch, so that no error accumulates in kept forces.
    void find_islands() {
        if (found_islands_) return;
        found_islands_ = true;
        system_.b.conservativeResize(Eigen::NoChange, 1);
        solver_.begin(world_.problem());
        moves_.resize(solver_.islands().all().size());
    }

    // Momenta after a kick by external forces and lambda.
    void kick_ahead(double kick) {
        constraint_forces(system_, solver_.lambda(), 0, forces_);
        for (std::size_t i = 0; i < ahead_.size(); ++i) {
            const Body& body = world_.bodies[i];
            if (body.is_static()) continue;
            const Vector6& f_c = forces_[i];
            ahead_[i].linear_momentum = advance_momentum(body.linear_momentum, body.force + f_c.head<3>(), kick);
            ahead_[i].angular_momentum = advance_momentum(body.angular_momentum, body.torque + f_c.tail<3>(), kick);
        }
    }

    // Positions after kick and drift, and the rows there.
    void look_ahead(double kick, double drift) {
        kick_ahead(kick);
        for (std::size_t i = 0; i < ahead_.size(); ++i) {
            const Body& body = world_.bodies[i];
            if (body.is_static()) continue;
            ahead_[i].position = advance_position(body, ahead_[i].linear_momentum, drift);
            ahead_[i].orientation = world_.rotate(body, ahead_[i].angular_momentum, drift);
        }
        rows_ahead_.clear();
        for (const auto& source : world_.constraints)
            source->append_rows({ahead_, drift, world_.time()}, rows_ahead_);
        if (rows_ahead_.size() != world_.rows().size()) {
            throw InvalidInput("rows", std::to_string(rows_ahead_.size()), "the same throughout a step of RATTLE");
        }
        for (std::size_t k = 0; k < moves_.size(); ++k) {
            moves_[k].before = moves_[k].error;
            moves_[k].error = error_ahead(solver_.islands().all()[k]) * std::abs(drift);
        }
    }

    // Largest push of the island's rows at the predicted positions [m/s].
    double error_ahead(const Island& island) const {
        double largest = 0.0;
        for (const RowRun& run : island.runs) {
            for (int j = run.begin; j < run.end; ++j) {
                largest = std::max(largest, std::abs(whole(rows_ahead_[static_cast<std::size_t>(j)].push)));
            }
        }
        return largest;
    }

    // Ends the moves of islands whose bars are accurate to `enough` [m], or whose error has stopped falling.
    // Returns whether all have ended.
    bool end_moves(double enough, bool first) {
        bool all = true;
        for (Move& move : moves_) {
            if (first) move.ended = false;
            move.ended = move.ended || move.error <= enough || (!first && move.error >= move.before);
            all = all && move.ended;
        }
        return all;
    }

    // Adds to lambda the missing force: A change = v / kick, with v at the predicted positions and the axes at the
    // start of the move.
    void correct(double kick) {
        const auto rows = static_cast<Eigen::Index>(rows_ahead_.size());
        system_.b.resize(rows, 1);
        for (Eigen::Index j = 0; j < rows; ++j) {
            system_.b(j, 0) = whole(rows_ahead_[static_cast<std::size_t>(j)].push) / kick;
        }
        change_.setZero(rows, 1);
        solve_open_islands(change_);
        solver_.lambda() += change_;
    }

    // Solves the islands whose moves have not ended.
    void solve_open_islands(Columns& lambda) {
        open_.clear();
        for (std::size_t k = 0; k < moves_.size(); ++k) {
            if (!moves_[k].ended) open_.push_back(static_cast<int>(k));
        }
        work_ += solver_.solve_separately(world_.problem(), open_, lambda);
    }

    // State of the move of an island.
    struct Move {
        double error = 0.0, before = 0.0;  // m, largest length error
        bool ended = false;
    };

    World& world_;
    SystemEquation& system_;
    StepSolver& solver_;
    std::vector<Body> ahead_;
    RowList rows_ahead_;
    Columns change_;               // of lambda, N
    std::vector<Vector6> forces_;  // of the bars
    std::vector<Move> moves_;      // by island
    bool found_islands_ = false;
    std::vector<int> open_;  // islands whose moves have not ended, by number
    SolveWork work_;
};

namespace {

// One step composed of moves over the shares of dt in `shares`, which sum to 1 and are palindromic.
template <std::size_t moves>
StepCount composed(World& world, double dt, const std::array<double, moves>& shares) {
    RattleStep step(world);
    step.begin(dt);
    double before = 0.0;
    for (const double share : shares) {
        step.move(0.5 * (before + share) * dt, share * dt);
        before = share;
    }
    return step.finish(0.5 * before * dt);
}

}  // namespace

StepCount rattle(World& world, double dt) {
    return composed(world, dt, std::array{1.0});
}

// M. Suzuki, Fractal decomposition of exponential operators, Physics Letters A 146 (1990): s, s, 1 - 4 s, s, s with
// s = 1 / (4 - 4^(1/3)). The middle one goes back in time, by less than that of the three-stage composition.
StepCount rattle4(World& world, double dt) {
    constexpr double s = 0.41449077179437573714;
    return composed(world, dt, std::array{s, s, 1.0 - 4.0 * s, s, s});
}

// H. Yoshida, Construction of higher order symplectic integrators, Physics Letters A 150 (1990): table 1,
// solution A; digits as in Hairer, Lubich, Wanner, Geometric Numerical Integration, V (3.11).
StepCount rattle6(World& world, double dt) {
    constexpr double outer = 0.78451361047755726382;
    constexpr double second = 0.23557321335935813368;
    constexpr double third = -1.17767998417887100695;
    constexpr double middle = 1.0 - 2.0 * (outer + second + third);
    return composed(world, dt, std::array{outer, second, third, middle, third, second, outer});
}

}  // namespace pushfactor::engine
