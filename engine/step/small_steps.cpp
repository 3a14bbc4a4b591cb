#include "engine/step/small_steps.h"

#include "engine/solvers/sweep.h"

#include <algorithm>
#include <cmath>

namespace pushfactor::engine {

namespace {

// Share of an impulse that the previous small step must have had for it to count as carrying.
constexpr double again = 0.5;

// Factor for the sweeps of the last small step, whose velocities and forces start the next step: damps oscillations
// of towers.
constexpr int more_at_the_end = 4;

constexpr int push_sweeps = 4;
// Rows that keep bodies apart or points at a distance; the others are friction and yielding bars.
bool holds_place(const Bounds& bounds) {
    return bounds.of_row < 0 && (std::isinf(bounds.c_min) || std::isinf(bounds.c_max));
}

const ConstraintRow& row_of(const SystemEquation& system, int row) {
    return system.rows[static_cast<std::size_t>(row)];
}

// Momenta from x = M^(-1/2)^T p.
Vector6 momenta_of(const InverseMass& inverse_mass, const Vector3& inverse_inertia, const Vector6& x) {
    const Vector3 turning = x.tail<3>().cwiseQuotient(inverse_inertia);
    return stacked(x.head<3>() / inverse_mass.linear_root, inverse_mass.angular_root * turning);
}

Vector6 weighted(const InverseMass& inverse_mass, const Vector3& linear, const Vector3& angular) {
    return stacked(inverse_mass.linear_root * linear, inverse_mass.angular_root.transpose() * angular);
}

}  // namespace

// Calls `visit(number in the island, row of the step)` for each row.
template <typename Visit>
void SmallSteps::each_row(const Part& part, const Visit& visit) const {
    auto number = static_cast<std::size_t>(part.begin_row);
    for (int k = part.begin_run; k < part.end_run; ++k) {
        const RowRun& run = dissection_.island().runs[static_cast<std::size_t>(k)];
        for (int j = run.begin; j < run.end; ++j) visit(number++, j);
    }
}

// Calls `visit` with the number of each movable body of this member.
template <typename Visit>
void SmallSteps::each_body(Team& team, const Visit& visit) const {
    dissection_.by_leaves(team, [&](const Dissection::Leaf& leaf, std::size_t) {
        for (int i = leaf.begin; i < leaf.end; ++i) visit(static_cast<std::size_t>(i));
    });
}

solvers::SolveCount SmallSteps::solve(const SystemEquation& system, std::span<const Body> bodies,
                                      const Island& island, const Division& division, Threads* threads,
                                      Columns& lambda, ConstraintForces& forces, std::span<Lambda> ending) {
    dissection_.cut(bodies, island);
    size(dissection_.island());
    const Step step{system, bodies, division, system.dt / division.steps, lambda, forces, ending};
    if (threads && dissection_.leaves().size() > 1) {
        threads->as_team([&](Team& team) { work(step, team); });
    } else {
        Team alone;
        work(step, alone);
    }

    std::size_t one_sided = 0;
    bool pushed = false;
    residual_ = 0.0;
    for (const PartState& state : states_) {
        one_sided += state.one_sided.size();
        pushed = pushed || state.is_pushed;
        if (!(state.residual <= residual_)) residual_ = state.residual;
    }
    const double rows = 24.0 * island.rows, followed = 24.0 * static_cast<double>(one_sided);
    const int sweeps = (division.steps - 1 + more_at_the_end) * division.sweeps;
    return {.iterations = sweeps,
            .multiply_adds = sweeps * rows + division.steps * followed + (pushed ? push_sweeps : 1) * followed,
            .in_small_steps = true};
}

// Sizes the memory shared by all threads.
void SmallSteps::size(const Island& island) {
    rows_.begin(island);
    std::fill(rows_.velocity.begin() + island.movable(), rows_.velocity.end(), Vector6::Zero());
    states_.resize(dissection_.part_count());
    sums_.resize(dissection_.leaves().size());
    const auto movable = static_cast<std::size_t>(island.movable()), rows = static_cast<std::size_t>(island.rows);
    for (std::vector<Vector6>* of_bodies : {&start_, &pull_, &base_, &impulse_, &moved_})
        of_bodies->resize(movable);
    for (std::vector<double>* of_rows : {&before_, &kept_, &sum_}) of_rows->resize(rows);
}

// Runs on each member of the team, for its parts.
void SmallSteps::work(const Step& step, Team& team) {
    load(step, team);
    begin(step, team);
    for (int k = 0; k < step.division.steps; ++k) {
        small_step(step, k, team);
    }
    dissection_.in_any_order(team, [this](const Part& part) {
        PartState& state = state_of(part);
        state.residual = rows_.residual(state.blocks);
    });
    kick_at_once(step, team);
    store(step, team);
    push_apart(step, team);
    write_moving_forces(step, team);
}

void SmallSteps::load(const Step& step, Team& team) {
    const Island& island = dissection_.island();
    dissection_.in_any_order(team, [&](const Part& part) {
        for (int k = part.begin_run; k < part.end_run; ++k) {
            rows_.load_run(step.system, island, island.runs[static_cast<std::size_t>(k)], step.lambda,
                           step.lambda.cols() - 1, step.h);
        }
        std::vector<solvers::UnitRows<1>::Block>& blocks = state_of(part).blocks;
        blocks.clear();
        rows_.add_blocks(part.begin_row, part.end_row, blocks);
    });
    each_body(team, [this](std::size_t i) { rows_.velocity[i].setZero(); });
    Vector6 still = Vector6::Zero();
    team.wait_for_all();
    dissection_.by_rounds(team, [&](const Part& part) {
        PartState& state = state_of(part);
        rows_.couple(state.blocks);
        rows_.add_velocities(state.blocks, still);
    });
}

// Velocities and displacements at the start of the step, and the warm start of the first small step.
void SmallSteps::begin(const Step& step, Team& team) {
    each_body(team, [&](std::size_t i) {
        const auto body = static_cast<std::size_t>(dissection_.island().bodies[i]);
        const InverseMass& inverse_mass = step.system.inverse_mass[body];
        const Body& own = step.bodies[body];
        impulse_[i] = rows_.velocity[i];
        moved_[i].setZero();
        rows_.velocity[i] = weighted(inverse_mass, own.linear_momentum, own.angular_momentum);
        start_[i] = rows_.velocity[i];
        pull_[i] = step.h * weighted(inverse_mass, own.force, own.torque);
    });
    dissection_.in_any_order(team, [&](const Part& part) {
        PartState& state = state_of(part);
        state.drives = false;
        state.one_sided.clear();
        each_row(part, [&](std::size_t number, int j) {
            const ConstraintRow& source = row_of(step.system, j);
            solvers::UnitRows<1>::Row& row = rows_.rows[number];
            sum_[number] = 0.0;
            before_[number] = row.y[0];
            if (!(row.scale > 0.0)) return;
            const double carried = step.system.carried_by(static_cast<std::size_t>(j));
            const bool lifts = source.bounds.c_min >= 0.0, holds = source.bounds.c_max <= 0.0;
            if (source.bounds.of_row < 0 && (lifts || holds)) {
                state.one_sided.push_back({number, source.error, carried, lifts ? 1.0 : -1.0});
                state.drives = state.drives || carried != 0.0;
            } else {
                const double aim = source.push.lasting + carried;
                row.t[0] = aim / row.scale;
                state.drives = state.drives || aim != 0.0;
            }
        });
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

// For a small step of `h` [s] that begins `elapsed` [s] after the step.
void SmallSteps::aim(double h, double elapsed, const Part& part) {
    for (const OneSided& one : state_of(part).one_sided) {
        solvers::UnitRows<1>::Row& row = rows_.rows[one.row];
        const double error = one.error + moved_along(row) - elapsed * one.carried;
        const bool open = one.open_side * error > 0.0;
        row.t[0] = open ? -error / (h * row.scale) : 0.0;
        if (one.carried != 0.0) row.t[0] += one.carried / row.scale;
    }
}

double SmallSteps::impulse_gain(std::size_t body) const {
    return impulse_[body].dot(base_[body] + 0.5 * impulse_[body]);
}

// Energy that reusing the impulses of the previous small step would give the bodies [J]. Contacts and friction
// never add energy: if it is positive, these impulses have stopped something that was moving.
double SmallSteps::gain(Team& team) {
    dissection_.by_leaves(team, [this](const Dissection::Leaf& leaf, std::size_t number) {
        double& own = sums_[number].gain;
        own = 0.0;
        for (int i = leaf.begin; i < leaf.end; ++i) own += impulse_gain(static_cast<std::size_t>(i));
    });
    team.wait_for_all();
    double all = 0.0;
    for (const LeafSums& sums : sums_) all += sums.gain;
    return all;
}

// Limits the impulses to those that the small step before the previous one had too: an impulse that occurs once was
// a collision, one that repeats carries load. If that still adds energy, scales them so that most energy is
// removed.
void SmallSteps::forget_hits(Team& team) {
    dissection_.by_rounds(team, [this](const Part& part) { keep_hits_of(part); });
    if (!(gain(team) > 0.0)) return;
    dissection_.by_leaves(team, [this](const Dissection::Leaf& leaf, std::size_t number) {
        LeafSums& own = sums_[number];
        own.along = own.squared = 0.0;
        for (int i = leaf.begin; i < leaf.end; ++i) {
            const auto body = static_cast<std::size_t>(i);
            own.along += impulse_[body].dot(base_[body]);
            own.squared += impulse_[body].squaredNorm();
        }
    });
    team.wait_for_all();
    double along = 0.0, squared = 0.0;
    for (const LeafSums& sums : sums_) {
        along += sums.along;
        squared += sums.squared;
    }
    const double share = std::max(0.0, -along / squared);
    dissection_.in_any_order(team, [&](const Part& part) {
        for (int j = part.begin_row; j < part.end_row; ++j) rows_.rows[static_cast<std::size_t>(j)].y[0] *= share;
    });
    each_body(team, [&](std::size_t i) { impulse_[i] *= share; });
}

void SmallSteps::keep_hits_of(const Part& part) {
    const auto add = [this](int body, const Vector6& axis, double y) {
        const auto number = static_cast<std::size_t>(body);
        if (number < impulse_.size()) impulse_[number] += axis * y;
    };
    const auto end = static_cast<std::size_t>(part.end_row);
    for (auto j = static_cast<std::size_t>(part.begin_row); j < end; ++j) {
        solvers::UnitRows<1>::Row& row = rows_.rows[j];
        const double now = row.y[0], was = before_[j];
        kept_[j] = 1.0;
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
}

void SmallSteps::small_step(const Step& step, int number, Team& team) {
    const bool last = number + 1 == step.division.steps;
    const int sweeps = last ? more_at_the_end * step.division.sweeps : step.division.sweeps;
    each_body(team, [this](std::size_t i) { base_[i] = rows_.velocity[i] + pull_[i]; });
    const double gained = gain(team);
    const bool drives =
        std::any_of(states_.begin(), states_.end(), [](const PartState& state) { return state.drives; });
    if (!drives && gained > 0.0) forget_hits(team);
    each_body(team, [this](std::size_t i) { rows_.velocity[i] = base_[i] + impulse_[i]; });
    Vector6 still = Vector6::Zero();
    for (int k = 0; k < sweeps; ++k) {
        dissection_.by_rounds(team, [&](const Part& part) {
            const PartState& state = state_of(part);
            const auto begin = static_cast<std::size_t>(part.begin_row),
                       end = static_cast<std::size_t>(part.end_row);
            if (k == 0) {
                aim(step.h, number * step.h, part);
                for (std::size_t j = begin; j < end; ++j) before_[j] = rows_.rows[j].y[0];
            }
            solvers::sweep<1>(rows_, state.blocks,
                              [&](const auto& block, std::size_t c) { return rows_.at_bodies(block, c, still); });
            if (k + 1 == sweeps) {
                for (std::size_t j = begin; j < end; ++j) sum_[j] += rows_.rows[j].y[0];
            }
        });
    }
    each_body(team, [&](std::size_t i) {
        impulse_[i] = rows_.velocity[i] - base_[i];
        moved_[i] += step.h * rows_.velocity[i];
    });
}

// A collision shows only in the whole step, a load that starts in the last small step only there: if both point the
// same way the shorter one is used, otherwise neither. Limited to the effect of the external forces on the body:
// one that is stopped harder would be lifted into bodies that are still falling.
void SmallSteps::kick_at_once(const Step& step, Team& team) {
    const int steps = step.division.steps;
    const double share = 0.5 * step.system.dt * (1.0 - 1.0 / steps);
    each_body(team, [&](std::size_t i) {
        const Vector6 whole = rows_.velocity[i] - start_[i], end = steps * (pull_[i] + impulse_[i]);
        if (!(whole.dot(end) > 0.0)) return;
        const Vector6& kick = whole.squaredNorm() < end.squaredNorm() ? whole : end;
        const double most = steps * pull_[i].norm();
        moved_[i] += share * std::min(1.0, most / kick.norm()) * kick;
    });
}

// Writes the forces of the rows, and the lasting forces on the bodies.
void SmallSteps::store(const Step& step, Team& team) {
    const Island& island = dissection_.island();
    const Eigen::Index last = step.lambda.cols() - 1;
    std::vector<Vector6>& lasting = step.forces.lasting;
    const auto on = [&](int number) -> Vector6& {
        return lasting[static_cast<std::size_t>(island.bodies[static_cast<std::size_t>(number)])];
    };
    each_body(team, [&](std::size_t i) { on(static_cast<int>(i)).setZero(); });
    dissection_.by_rounds(team, [&](const Part& part) {
        each_row(part, [&](std::size_t number, int j) {
            const double scale = rows_.rows[number].scale;
            const double mean = scale > 0.0 ? sum_[number] / (step.system.dt * scale) : 0.0;
            step.lambda.row(j).setConstant(mean);
            const double latest = scale > 0.0 ? rows_.rows[number].y[0] / (step.h * scale) : 0.0;
            step.ending[static_cast<std::size_t>(j)] = {latest, latest};
        });
        for (Eigen::Index column = 0; column <= last; ++column) {
            each_row(part, [&](std::size_t, int j) { clamp_force(step.system.rows, j, column, step.lambda); });
        }
        for (int k = part.begin_run; k < part.end_run; ++k) {
            const RowRun& run = island.runs[static_cast<std::size_t>(k)];
            Vector6 on_static = Vector6::Zero();
            add_forces_of_rows(step.system, step.lambda, last, run.begin, run.end,
                               run.a < island.movable() ? on(run.a) : on_static,
                               run.b < island.movable() ? on(run.b) : on_static);
        }
    });
}

// Computes the displacement target of each row of the part after the last small step.
void SmallSteps::plan_push(const Step& step, const Part& part) {
    PartState& state = state_of(part);
    state.pushed.clear();
    state.is_pushed = false;
    each_row(part, [&](std::size_t number, int j) {
        const ConstraintRow& source = row_of(step.system, j);
        const solvers::UnitRows<1>::Row& row = rows_.rows[number];
        if (!(row.scale > 0.0) || !holds_place(source.bounds)) return;
        const double moved =
            moved_along(row) - step.system.dt * step.system.carried_by(static_cast<std::size_t>(j));
        const double correcting = step.system.dt * source.push.correcting;
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
        state.pushed.push_back({number, j, want / row.scale});
        state.is_pushed = state.is_pushed || (source.bounds.c_min >= 0.0   ? want > 0.0
                                              : source.bounds.c_max <= 0.0 ? want < 0.0
                                                                           : want != 0.0);
    });
}

void SmallSteps::push_apart(const Step& step, Team& team) {
    dissection_.in_any_order(team, [&](const Part& part) { plan_push(step, part); });
    team.wait_for_all();
    const bool any =
        std::any_of(states_.begin(), states_.end(), [](const PartState& state) { return state.is_pushed; });
    if (!any) return;
    each_body(team, [this](std::size_t i) { rows_.velocity[i].setZero(); });
    for (int k = 0; k < push_sweeps; ++k) {
        dissection_.by_rounds(team, [&](const Part& part) {
            for (const Pushed& own : state_of(part).pushed) {
                solvers::UnitRows<1>::Row& row = rows_.rows[own.row];
                if (k == 0) {
                    row.t[0] = own.want;
                    row.y[0] = 0.0;
                }
                rows_.set(row, 0, rows_.clamped(row, 0, row.y[0] + rows_.error(row, 0)));
            }
        });
    }
    each_body(team, [this](std::size_t i) { moved_[i] += rows_.velocity[i]; });
    dissection_.in_any_order(team, [&](const Part& part) {
        for (const Pushed& own : state_of(part).pushed) {
            const solvers::UnitRows<1>::Row& row = rows_.rows[own.row];
            const double force = row.y[0] / (step.system.dt * step.system.dt * row.scale);
            step.ending[static_cast<std::size_t>(own.of_step)].first += force;
            if (step.lambda.cols() == 2) step.lambda(own.of_step, 0) += force;
        }
    });
}

// Constant forces that move the bodies in a whole step as far as the small steps did.
void SmallSteps::write_moving_forces(const Step& step, Team& team) const {
    each_body(team, [&](std::size_t i) {
        const auto body = static_cast<std::size_t>(dissection_.island().bodies[i]);
        const Body& own = step.bodies[body];
        const Vector6 mean =
            momenta_of(step.system.inverse_mass[body], own.inverse_inertia, moved_[i]) / step.system.dt;
        step.forces.moving[body] = (mean - stacked(own.linear_momentum, own.angular_momentum)) / step.system.dt -
                                   stacked(own.force, own.torque);
    });
}

}  // namespace pushfactor::engine
