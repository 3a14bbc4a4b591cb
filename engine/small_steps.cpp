#include "engine/small_steps.h"

#include "engine/solvers/sweep.h"

#include <algorithm>
#include <cmath>

namespace pushfactor::engine {

namespace {

// Share of an impulse that the small step before must have had for it to carry something.
constexpr double again = 0.5;

// What is to carry load, which with two sweeps a step trembles for ever; what moves with little to carry, or is hit
// somewhere; and what moves and is hit everywhere.
constexpr SmallSteps::Division carrying{.steps = 16, .sweeps = 4};
constexpr SmallSteps::Division moving_on{.steps = 16, .sweeps = 2};
constexpr SmallSteps::Division stirred{.steps = 8, .sweeps = 2};
// Shares of its bodies that move, beyond which an island no longer stands, and is stirred.
constexpr double a_few_move = 0.05, a_part_moves = 0.25;

// Residual with which an island has settled, as a share of the speed that external forces give in a step.
constexpr double settled = 1e-3;

// And with which forces are missing at most, with room for roundings.
constexpr double unbalanced = 1.1;

// And with which bodies hit each other: more than load that is not held can build up in some steps.
constexpr double hit = 3.0;

// And up to which hardly any load is not held.
constexpr double unheld = 0.1;

// The last small step, whose velocities and forces the next step begins with, has so many times the sweeps: what
// rings in a tower dies away.
constexpr int more_at_the_end = 4;

constexpr int push_sweeps = 4;
// Sweeps of a whole step spread load over as many layers as the root of their number.
constexpr int few = 6;

// Rows that hold bodies apart, or points at a distance; the others are friction and bars that yield.
bool holds_place(const Bounds& bounds) {
    return bounds.of_row < 0 && (std::isinf(bounds.c_min) || std::isinf(bounds.c_max));
}

// How many bodies are faster than one step of their external force makes them.
int moving(double dt, std::span<const Body> bodies, const Island& island) {
    return static_cast<int>(std::count_if(island.bodies.begin(), island.bodies.end(), [&](int body) {
        const Body& own = bodies[static_cast<std::size_t>(body)];
        return own.linear_momentum.squaredNorm() > dt * dt * own.force.squaredNorm();
    }));
}

bool is_more_than(double share, int bodies, const Island& island) {
    return bodies > share * island.movable();
}

// The largest speed that the external forces of a step give to a body [m/s].
double fastest_by_forces(double dt, std::span<const Body> bodies, const Island& island) {
    double fastest = 0.0;
    for (const int body : island.bodies) {
        const Body& own = bodies[static_cast<std::size_t>(body)];
        fastest = std::max(fastest, own.inverse_mass * own.force.norm());
    }
    return dt * fastest;
}

const ConstraintRow& row_of(const SystemEquation& system, int row) {
    return system.rows[static_cast<std::size_t>(row)];
}

// Momenta from x, which is M^(-1/2)^T of them.
Vector6 momenta_of(const InverseMass& inverse_mass, const Vector3& inverse_inertia, const Vector6& x) {
    const Vector3 turning = x.tail<3>().cwiseQuotient(inverse_inertia);
    return stacked(x.head<3>() / inverse_mass.linear_root, inverse_mass.angular_root * turning);
}

Vector6 weighted(const InverseMass& inverse_mass, const Vector3& linear, const Vector3& angular) {
    return stacked(inverse_mass.linear_root * linear, inverse_mass.angular_root.transpose() * angular);
}

// Calls `visit` with the number in the island and the number in the step of each row.
template <typename Visit>
void each_row(const Island& island, const Visit& visit) {
    std::size_t number = 0;
    for (const RowRun& run : island.runs) {
        for (int j = run.begin; j < run.end; ++j) visit(number++, j);
    }
}

}  // namespace

bool SmallSteps::suit(const SystemEquation& system, const Island& island) {
    if (island.movable() < few) return false;
    const auto refuses = [](const ConstraintRow& row) {
        if (row.bounds.of_row >= 0) return false;
        if (std::isinf(row.bounds.c_min) && std::isinf(row.bounds.c_max)) return true;
        return (row.bounds.c_min >= 0.0 && row.push.lasting > 0.0) ||
               (row.bounds.c_max <= 0.0 && row.push.lasting < 0.0);
    };
    return std::none_of(island.runs.begin(), island.runs.end(), [&](const RowRun& run) {
        const auto rows =
            system.rows.subspan(static_cast<std::size_t>(run.begin), static_cast<std::size_t>(run.end - run.begin));
        return std::any_of(rows.begin(), rows.end(), refuses);
    });
}

double SmallSteps::settled_speed(double dt, std::span<const Body> bodies, const Island& island) {
    return settled * fastest_by_forces(dt, bodies, island);
}

double SmallSteps::standing_speed(double dt, std::span<const Body> bodies, const Island& island) {
    if (is_more_than(a_few_move, moving(dt, bodies, island), island)) return 0.0;
    return unbalanced * fastest_by_forces(dt, bodies, island);
}

SmallSteps::Division SmallSteps::division_of(double dt, std::span<const Body> bodies, const Island& island,
                                             double residual) const {
    if (division_) return *division_;
    const double by_forces = fastest_by_forces(dt, bodies, island);
    const int moves = moving(dt, bodies, island);
    const bool mostly = is_more_than(a_part_moves, moves, island);
    if (residual <= unheld * by_forces) return mostly ? moving_on : carrying;
    if (residual <= hit * by_forces || !is_more_than(a_few_move, moves, island)) return carrying;
    return mostly ? stirred : moving_on;
}

solvers::SolveCount SmallSteps::solve(const SystemEquation& system, std::span<const Body> bodies,
                                      const Island& island, const Division& division, Threads* threads,
                                      Columns& lambda, ConstraintForces& forces) {
    const double h = system.dt / division.steps;
    if (island.rows < static_cast<int>(solvers::SweepPipeline::least_rows)) threads = nullptr;
    rows_.load(system, island, lambda, lambda.cols() - 1, h, threads);
    begin(system, bodies, island, h);
    if (threads) pipeline_.plan(rows_);
    for (int step = 0; step < division.steps; ++step) {
        const bool last = step + 1 == division.steps;
        small_step(h, last ? more_at_the_end * division.sweeps : division.sweeps, threads);
    }
    residual_ = rows_.residual();
    kick_at_once(division.steps, system.dt);
    store(system, island, h, lambda);
    constraint_forces(system, island, lambda, lambda.cols() - 1, forces.lasting);
    const bool pushed = push_apart(system, island, lambda);
    write_moving_forces(system, bodies, island, forces);

    const double rows = 24.0 * island.rows, one_sided = 24.0 * static_cast<double>(one_sided_.size());
    const int sweeps = (division.steps - 1 + more_at_the_end) * division.sweeps;
    return {.iterations = sweeps,
            .multiply_adds = sweeps * rows + division.steps * one_sided + (pushed ? push_sweeps : 1) * one_sided,
            .in_small_steps = true};
}

// Free motion at the start of the step, and what the first small step begins with.
void SmallSteps::begin(const SystemEquation& system, std::span<const Body> bodies, const Island& island, double h) {
    const auto movable = static_cast<std::size_t>(island.movable());
    start_.resize(movable);
    pull_.resize(movable);
    base_.resize(movable);
    impulse_.assign(rows_.velocity.begin(), rows_.velocity.begin() + island.movable());
    moved_.assign(movable, Vector6::Zero());
    std::fill(rows_.velocity.begin(), rows_.velocity.end(), Vector6::Zero());
    for (std::size_t i = 0; i < movable; ++i) {
        const auto body = static_cast<std::size_t>(island.bodies[i]);
        const InverseMass& inverse_mass = system.inverse_mass[body];
        const Body& own = bodies[body];
        rows_.velocity[i] = weighted(inverse_mass, own.linear_momentum, own.angular_momentum);
        start_[i] = rows_.velocity[i];
        pull_[i] = h * weighted(inverse_mass, own.force, own.torque);
    }
    sum_.assign(rows_.rows.size(), 0.0);
    before_.assign(rows_.rows.size(), 0.0);
    for (std::size_t j = 0; j < before_.size(); ++j) before_[j] = rows_.rows[j].y[0];
    drives_ = false;
    one_sided_.clear();
    each_row(island, [&](std::size_t number, int j) {
        const ConstraintRow& source = row_of(system, j);
        solvers::UnitRows<1>::Row& row = rows_.rows[number];
        if (!(row.scale > 0.0)) return;
        const bool lifts = source.bounds.c_min >= 0.0, holds = source.bounds.c_max <= 0.0;
        if (source.bounds.of_row < 0 && (lifts || holds)) {
            one_sided_.push_back({number, source.error, lifts ? 1.0 : -1.0});
        } else {
            row.t[0] = source.push.lasting / row.scale;
            drives_ = drives_ || source.push.lasting != 0.0;
        }
    });
}

// s u . d of a row [m].
double SmallSteps::moved_along(const solvers::UnitRows<1>::Row& row) const {
    const auto half = [this](int body, const Vector6& axis) {
        const auto number = static_cast<std::size_t>(body);
        return number < moved_.size() ? axis.dot(moved_[number]) : 0.0;
    };
    return row.scale * (half(row.a, row.unit->a) + half(row.b, row.unit->b));
}

// Of the rows from one number up to another.
void SmallSteps::aim(double h, std::size_t first_row, std::size_t end_row) {
    const auto from = [this](std::size_t row) {
        return std::lower_bound(one_sided_.begin(), one_sided_.end(), row,
                                [](const OneSided& one, std::size_t of) { return one.row < of; });
    };
    for (const OneSided& one : std::span(from(first_row), from(end_row))) {
        solvers::UnitRows<1>::Row& row = rows_.rows[one.row];
        const double error = one.error + moved_along(row);
        const bool open = one.open_side * error > 0.0;
        row.t[0] = open ? -error / (h * row.scale) : 0.0;
    }
}

// Whether the impulses of the small step before would give the bodies energy, which contacts and friction never do:
// they have stopped what was moving.
bool SmallSteps::brings_energy() const {
    double gain = 0.0;
    for (std::size_t i = 0; i < impulse_.size(); ++i) gain += impulse_[i].dot(base_[i] + 0.5 * impulse_[i]);
    return gain > 0.0;
}

// Takes the impulses back to those that the small step before the last one had too: what pushes once was a
// collision, what pushes twice carries. If that is no better, as much of them as takes most energy away.
void SmallSteps::forget_hits() {
    kept_.assign(rows_.rows.size(), 1.0);
    const auto add = [this](int body, const Vector6& axis, double y) {
        const auto number = static_cast<std::size_t>(body);
        if (number < impulse_.size()) impulse_[number] += axis * y;
    };
    for (std::size_t j = 0; j < rows_.rows.size(); ++j) {
        solvers::UnitRows<1>::Row& row = rows_.rows[j];
        const double now = row.y[0], was = before_[j];
        if (row.of_row >= 0) {
            kept_[j] = kept_[static_cast<std::size_t>(row.of_row)];
        } else if (was * now < again * now * now) {
            kept_[j] = std::max(0.0, was / now);
        }
        if (kept_[j] == 1.0) continue;
        row.y[0] = kept_[j] * now;
        add(row.a, row.unit->a, row.y[0] - now);
        add(row.b, row.unit->b, row.y[0] - now);
    }
    if (!brings_energy()) return;
    double along = 0.0, squared = 0.0;
    for (std::size_t i = 0; i < impulse_.size(); ++i) {
        along += impulse_[i].dot(base_[i]);
        squared += impulse_[i].squaredNorm();
    }
    const double share = std::max(0.0, -along / squared);
    for (solvers::UnitRows<1>::Row& row : rows_.rows) row.y[0] *= share;
    for (Vector6& impulse : impulse_) impulse *= share;
}

void SmallSteps::small_step(double h, int sweeps, Threads* threads) {
    for (std::size_t i = 0; i < pull_.size(); ++i) base_[i] = rows_.velocity[i] + pull_[i];
    if (!drives_ && brings_energy()) forget_hits();
    for (std::size_t i = 0; i < pull_.size(); ++i) rows_.velocity[i] = base_[i] + impulse_[i];
    const auto before = [this, h](std::size_t begin, std::size_t end) {
        aim(h, begin, end);
        for (std::size_t j = begin; j < end; ++j) before_[j] = rows_.rows[j].y[0];
    };
    const auto after = [this](std::size_t begin, std::size_t end) {
        for (std::size_t j = begin; j < end; ++j) sum_[j] += rows_.rows[j].y[0];
    };
    if (threads) {
        pipeline_.sweep(rows_, sweeps, *threads, before, after);
    } else {
        before(0, rows_.rows.size());
        for (int k = 0; k < sweeps; ++k) sweep(rows_);
        after(0, rows_.rows.size());
    }
    for (std::size_t i = 0; i < pull_.size(); ++i) {
        impulse_[i] = rows_.velocity[i] - base_[i];
        moved_[i] += h * rows_.velocity[i];
    }
}

// A collision is in the whole step alone, what begins with the last small step in that alone: of two that point the
// same way the shorter one, else neither. No more than the external forces do to the body: what is stopped harder
// than that would be lifted into what still falls.
void SmallSteps::kick_at_once(int steps, double dt) {
    const double share = 0.5 * dt * (1.0 - 1.0 / steps);
    for (std::size_t i = 0; i < moved_.size(); ++i) {
        const Vector6 whole = rows_.velocity[i] - start_[i], end = steps * (pull_[i] + impulse_[i]);
        if (!(whole.dot(end) > 0.0)) continue;
        const Vector6& kick = whole.squaredNorm() < end.squaredNorm() ? whole : end;
        const double most = steps * pull_[i].norm();
        moved_[i] += share * std::min(1.0, most / kick.norm()) * kick;
    }
}

void SmallSteps::store(const SystemEquation& system, const Island& island, double h, Columns& lambda) {
    ending_.assign(rows_.rows.size(), {});
    each_row(island, [&](std::size_t number, int j) {
        const double scale = rows_.rows[number].scale;
        const double mean = scale > 0.0 ? sum_[number] / (system.dt * scale) : 0.0;
        lambda.row(j).setConstant(mean);
        const double last = scale > 0.0 ? rows_.rows[number].y[0] / (h * scale) : 0.0;
        ending_[number] = {last, last};
    });
    for (Eigen::Index column = 0; column < lambda.cols(); ++column) {
        each_row(island, [&](std::size_t, int j) { clamp_force(system.rows, j, column, lambda); });
    }
}

// Where the rows are to be taken after the last small step, as a displacement, if that is anywhere.
bool SmallSteps::push_apart(const SystemEquation& system, const Island& island, Columns& lambda) {
    pushed_.clear();
    bool wanted = false;
    each_row(island, [&](std::size_t number, int j) {
        const ConstraintRow& source = row_of(system, j);
        solvers::UnitRows<1>::Row& row = rows_.rows[number];
        if (!(row.scale > 0.0) || !holds_place(source.bounds)) return;
        const double moved = moved_along(row), correcting = system.dt * source.push.correcting;
        double want = correcting;
        if (source.bounds.c_min >= 0.0) {
            const double overlap = std::max(0.0, -source.error);
            want = std::clamp(correcting, 0.0, overlap) - std::max(0.0, moved);
            const double gap = source.error + moved;
            want = gap > 0.0 ? -gap : std::max(0.0, want);
        } else if (source.bounds.c_max <= 0.0) {
            const double slack = source.error + moved;
            want = slack < 0.0 ? -slack : std::min(0.0, correcting);
        }
        pushed_.push_back({number, j, want / row.scale});
        wanted = wanted || (source.bounds.c_min >= 0.0   ? want > 0.0
                            : source.bounds.c_max <= 0.0 ? want < 0.0
                                                         : want != 0.0);
    });
    if (!wanted) return false;
    std::fill(rows_.velocity.begin(), rows_.velocity.end(), Vector6::Zero());
    for (const Pushed& own : pushed_) {
        rows_.rows[own.row].t[0] = own.want;
        rows_.rows[own.row].y[0] = 0.0;
    }
    for (int k = 0; k < push_sweeps; ++k) {
        for (const Pushed& own : pushed_) {
            solvers::UnitRows<1>::Row& row = rows_.rows[own.row];
            rows_.set(row, 0, rows_.clamped(row, 0, row.y[0] + rows_.error(row, 0)));
        }
    }
    for (std::size_t i = 0; i < moved_.size(); ++i) moved_[i] += rows_.velocity[i];
    for (const Pushed& own : pushed_) {
        const solvers::UnitRows<1>::Row& row = rows_.rows[own.row];
        const double force = row.y[0] / (system.dt * system.dt * row.scale);
        ending_[own.row].first += force;
        if (lambda.cols() == 2) lambda(own.of_step, 0) += force;
    }
    return true;
}

// The forces of a whole step that take the bodies as far as the small ones did.
void SmallSteps::write_moving_forces(const SystemEquation& system, std::span<const Body> bodies,
                                     const Island& island, ConstraintForces& forces) const {
    for (std::size_t i = 0; i < moved_.size(); ++i) {
        const auto body = static_cast<std::size_t>(island.bodies[i]);
        const Body& own = bodies[body];
        const Vector6 mean = momenta_of(system.inverse_mass[body], own.inverse_inertia, moved_[i]) / system.dt;
        forces.moving[body] = (mean - stacked(own.linear_momentum, own.angular_momentum)) / system.dt -
                              stacked(own.force, own.torque);
    }
}

}  // namespace pushfactor::engine
