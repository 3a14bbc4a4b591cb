#include "engine/step/small_steps.h"

#include "engine/base/constants.h"
#include "engine/bodies/integrator.h"
#include "engine/step/choice.h"

#include <algorithm>
#include <cmath>

namespace pushfactor::engine {

namespace {

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

// Whether the row keeps bodies apart or points together, and its source says how errors are corrected.
bool holds_a_place(const ConstraintRow& row) {
    return row.correction != nullptr && row.bounds.of_row < 0;
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

SmallSteps::Division SmallSteps::division_of(double dt, std::span<const Body> bodies, const Island& island) const {
    return division_ ? *division_ : choice::division_of(dt, bodies, island);
}

solvers::SolveCount SmallSteps::solve(const SystemEquation& system, std::span<const Body> bodies,
                                      const Island& island, const Division& division, const RowSources& sources,
                                      Threads* threads, Columns& lambda, ConstraintForces& forces,
                                      std::span<Lambda> ending) {
    dissection_.cut(bodies, island);
    size(dissection_.island(), !system.detours.empty());
    const Step step{system,
                    bodies,
                    division,
                    sources,
                    system.dt / division.steps,
                    choice::speed_by_forces(system.dt, bodies, island),
                    lambda,
                    forces,
                    ending};
    if (threads && dissection_.leaves().size() > 1) {
        threads->as_team([&](Team& team) { work(step, team); });
    } else {
        Team alone;
        work(step, alone);
    }

    std::size_t holding = 0;
    double updates = 0.0;
    residual_ = 0.0;
    for (const PartState& state : states_) {
        holding += state.holding.size();
        updates += state.updates;
        if (!(state.residual <= residual_)) residual_ = state.residual;
    }
    const int sweeps = 2 * division.steps * division.sweeps;
    updates += 1.0 * sweeps * island.rows;
    const double aimed = 2.0 * division.steps * static_cast<double>(holding);
    return {.iterations = sweeps, .row_updates = updates, .multiply_adds = 24.0 * (updates + aimed)};
}

// Sizes the memory shared by all threads.
void SmallSteps::size(const Island& island, bool has_detours) {
    rows_.begin(island);
    std::fill(rows_.velocity.begin() + island.movable(), rows_.velocity.end(), Vector6::Zero());
    states_.resize(dissection_.part_count());
    for (std::vector<Vector6>* of_bodies : {&pull_, &base_, &impulse_, &moved_}) {
        of_bodies->resize(static_cast<std::size_t>(island.movable()));
    }
    detours_.resize(has_detours ? static_cast<std::size_t>(island.movable()) : 0);
    stirred_.resize(static_cast<std::size_t>(island.movable()));
    scratch_.resize(static_cast<std::size_t>(island.movable()));
    for (std::vector<double>* of_rows : {&pushing_, &lasting_}) {
        of_rows->assign(static_cast<std::size_t>(island.rows), 0.0);
    }
}

// Runs on each member of the team, for its parts.
void SmallSteps::work(const Step& step, Team& team) {
    load(step, team);
    begin(step, team);
    for (int k = 0; k < step.division.steps; ++k) small_step(step, k, team);
    dissection_.in_any_order(team, [this](const Part& part) {
        unpack(part);
        state_of(part).residual = state_of(part).sweeps.residual(rows_);
    });
    store(step, team);
    push_apart(step, team);
    write_forces(step, team);
}

void SmallSteps::load(const Step& step, Team& team) {
    const Island& island = dissection_.island();
    dissection_.in_any_order(team, [&](const Part& part) {
        for (int k = part.begin_run; k < part.end_run; ++k) {
            const RowRun& run = island.runs[static_cast<std::size_t>(k)];
            rows_.load_run(step.system, island, run);
            rows_.take_run(step.system, run, step.lambda, step.lambda.cols() - 1, step.h);
        }
        state_of(part).sweeps.load(rows_, part.begin_row, part.end_row);
    });
    each_body(team, [this](std::size_t i) { rows_.velocity[i].setZero(); });
    Vector6 still = Vector6::Zero();
    team.wait_for_all();
    dissection_.by_rounds(team, [&](const Part& part) {
        const auto blocks = state_of(part).sweeps.blocks();
        rows_.couple(blocks);
        rows_.add_velocities(blocks, still);
    });
}

// Velocities at the start of the step, and the warm start of the first small step.
void SmallSteps::begin(const Step& step, Team& team) {
    each_body(team, [&](std::size_t i) {
        const auto body = static_cast<std::size_t>(dissection_.island().bodies[i]);
        const InverseMass& inverse_mass = step.system.inverse_mass[body];
        const Body& own = step.bodies[body];
        impulse_[i] = rows_.velocity[i];
        moved_[i].setZero();
        rows_.velocity[i] = weighted(inverse_mass, own.linear_momentum, own.angular_momentum);
        pull_[i] = step.h * weighted(inverse_mass, own.force, own.torque);
        if (detours_.empty()) return;
        const Vector6& detour = step.system.detours[body];
        detours_[i] = step.system.dt * weighted(inverse_mass, detour.head<3>(), detour.tail<3>());
    });
    dissection_.by_rounds(team, [&](const Part& part) {
        begin(step, part);
        pack(part);
    });
}

void SmallSteps::begin(const Step& step, const Part& part) {
    PartState& state = state_of(part);
    state.updates = 0;
    state.holding.clear();
    state.followed.clear();
    each_row(part, [&](std::size_t number, int j) {
        const ConstraintRow& source = row_of(step.system, j);
        solvers::UnitRow& row = rows_.rows[number];
        const double carried = step.system.carried_by(static_cast<std::size_t>(j));
        const ConstraintSource* const follows = step.sources.follower_of(j);
        if (follows) {
            const bool goes_on = !state.followed.empty() && state.followed.back().source == follows &&
                                 state.followed.back().of_step + state.followed.back().count == j &&
                                 row_of(step.system, j - 1).label.point == source.label.point;
            if (goes_on) {
                ++state.followed.back().count;
            } else {
                state.followed.push_back({follows, number, j, 1, state.holding.size()});
            }
        }
        if (!(row.scale > 0.0)) return;
        if (holds_a_place(source)) {
            const double open_side = source.bounds.c_min >= 0.0 ? 1.0 : source.bounds.c_max <= 0.0 ? -1.0 : 0.0;
            state.holding.push_back(
                {number, j, source.correction, source.error, source.error, carried, open_side, follows != nullptr});
        } else {
            row.t = (source.push.lasting + carried) / row.scale;
        }
    });
}

// s u . d of a row [m].
double SmallSteps::moved_along(const solvers::UnitRow& row) const {
    const auto half = [this](int body, const Vector6& axis) {
        const auto number = static_cast<std::size_t>(body);
        return number < moved_.size() ? axis.dot(moved_[number]) : 0.0;
    };
    return row.scale * (half(row.a, row.unit->a) + half(row.b, row.unit->b));
}

// What fits is swept four at a time.
void SmallSteps::pack(const Part& part) {
    PartState& state = state_of(part);
    state.sweeps.pack(rows_, scratch_);
    for (FourContacts& four : state.sweeps.fours()) {
        for (std::size_t k = 0; k < FourContacts::count; ++k) {
            if (four.row[k] == FourContacts::none) continue;
            const auto own =
                std::lower_bound(state.holding.begin(), state.holding.end(), static_cast<std::size_t>(four.row[k]),
                                 [](const Holding& holding, std::size_t row) { return holding.row < row; });
            if (own == state.holding.end() || own->row != static_cast<std::size_t>(four.row[k])) continue;
            own->is_in_four = true;
            four.holds[k] = -1;
            four.start[k] = four.error[k] = own->start;
            four.carried[k] = own->carried;
            four.beta[k] = own->correction->kind == PushKind::none ? 0.0 : own->correction->beta;
        }
    }
}

void SmallSteps::unpack(const Part& part) {
    PartSweeps& sweeps = state_of(part).sweeps;
    sweeps.unpack(rows_);
    for (const FourContacts& four : sweeps.fours()) {
        for (std::size_t k = 0; k < FourContacts::count; ++k) {
            for (int i = 0; i < FourContacts::rows && four.row[k] != FourContacts::none; ++i) {
                pushing_[static_cast<std::size_t>(four.row[k] + i)] = four.pushing[i][k];
                lasting_[static_cast<std::size_t>(four.row[k] + i)] = four.lasting[i][k];
            }
        }
    }
}

// Targets of a solve. Bodies move between the solve with the push and the one without.
void SmallSteps::aim(const Aim& aim, const Part& part) {
    PartState& state = state_of(part);
    engine::aim(state.sweeps.fours(), aim, moved_);
    for (Holding& own : state.holding) {
        if (own.is_in_four) continue;
        solvers::UnitRow& row = rows_.rows[own.row];
        if (!aim.pushes && !own.is_followed) own.error = own.start + moved_along(row) - aim.elapsed * own.carried;
        const Correction& correction = *own.correction;
        const double beta = correction.kind == PushKind::none ? 0.0 : correction.beta;
        const double most = own.open_side == 0.0 ? correction.max_speed : aim.fastest;
        const Target<double> target = target_of(aim, own.error, beta, own.open_side, most);
        row.keeps = target.keeps;
        row.t = (target.speed + own.carried) / row.scale;
    }
}

// The body of this number in the island, where it is now.
Body SmallSteps::placed(const Step& step, int number, int body) const {
    Body now = step.bodies[static_cast<std::size_t>(body)];
    if (static_cast<std::size_t>(number) >= moved_.size()) return now;
    const InverseMass& inverse_mass = step.system.inverse_mass[static_cast<std::size_t>(body)];
    const Vector6& moved = moved_[static_cast<std::size_t>(number)];
    now.position += inverse_mass.linear_root * moved.head<3>();
    now.orientation = exponential(inverse_mass.angular_root * moved.tail<3>()) * now.orientation;
    return now;
}

void SmallSteps::add_impulse(const solvers::UnitRow& row, double y) {
    const auto add = [&](int body, const Vector6& axis) {
        const auto number = static_cast<std::size_t>(body);
        if (number >= impulse_.size()) return;
        impulse_[number] += y * axis;
    };
    add(row.a, row.unit->a);
    add(row.b, row.unit->b);
}

void SmallSteps::follow(const Step& step, const Part& part) {
    PartState& state = state_of(part);
    if (state.followed.empty()) return;
    for (const Followed& own : state.followed) follow(step, own, state);
    rows_.couple(state.sweeps.blocks());
}

// Writes the rows of a bar or a joint again where its bodies are now; their forces stay.
void SmallSteps::follow(const Step& step, const Followed& own, PartState& state) {
    const SystemEquation& system = step.system;
    const auto first = static_cast<std::size_t>(own.of_step), count = static_cast<std::size_t>(own.count);
    const ConstraintRow& before = system.rows[first];
    const solvers::UnitRow& some = rows_.rows[own.first_row];
    const Body a = placed(step, some.a, before.body_a), b = placed(step, some.b, before.body_b);
    state.rows.clear();
    own.source->append_rows_of(static_cast<std::size_t>(before.label.point), {before.body_a, before.body_b, a, b},
                               step.h, state.rows);
    std::size_t holding = own.first_holding;
    for (std::size_t k = 0; k < count; ++k) {
        solvers::UnitRow& row = rows_.rows[own.first_row + k];
        if (!(row.scale > 0.0)) continue;
        const double force = row.y / row.scale;
        add_impulse(row, -row.y);
        rows_.replace(system, state.rows[k], own.first_row + k, step.h);
        row.y = force * row.scale;
        add_impulse(row, row.y);
        if (holding < state.holding.size() && state.holding[holding].row == own.first_row + k) {
            state.holding[holding++].error = state.rows[k].error;
        } else {
            row.t = (state.rows[k].push.lasting + system.carried_by(first + k)) / row.scale;
        }
    }
}

void SmallSteps::small_step(const Step& step, int number, Team& team) {
    const double begun = number * step.h, ended = begun + step.h;
    each_body(team, [this](std::size_t i) { base_[i] = rows_.velocity[i] + pull_[i]; });
    if (number > 0) dissection_.by_rounds(team, [&](const Part& part) { follow(step, part); });
    const bool strays = !detours_.empty();
    each_body(team, [&](std::size_t i) {
        rows_.velocity[i] = base_[i] + impulse_[i];
        if (strays) rows_.velocity[i] += detours_[i];
    });
    solve(step, Solve::with_push, begun, team);
    each_body(team, [&](std::size_t i) {
        moved_[i] += step.h * rows_.velocity[i];
        if (strays) rows_.velocity[i] -= detours_[i];
    });
    solve(step, Solve::without_push, ended, team);
    each_body(team, [this](std::size_t i) { impulse_[i] = rows_.velocity[i] - base_[i]; });
}

void SmallSteps::solve(const Step& step, Solve which, double elapsed, Team& team) {
    using constants::small_steps::most_sweeps;
    const bool pushes = which == Solve::with_push;
    std::vector<double>& sums = pushes ? pushing_ : lasting_;
    const Aim aims{pushes, step.h, static_cast<double>(step.division.steps), step.fastest, elapsed};
    each_body(team, [this](std::size_t i) { stirred_[i] = PartSweeps::never; });
    team.wait_for_all();  // until all bodies have moved
    dissection_.in_any_order(team, [&](const Part& part) { aim(aims, part); });
    double restless = constants::small_steps::hit * step.fastest / step.division.steps;
    double largest = infinity;
    const int whole = step.division.sweeps;  // sweeps of all rows
    for (int k = 0; k < whole || (largest > restless && k < most_sweeps); ++k) {
        dissection_.by_rounds(team, [&](const Part& part) {
            PartState& state = state_of(part);
            state.change =
                k < whole ? state.sweeps.sweep(rows_)
                          : state.sweeps.sweep_restless(rows_, restless, k, k == whole, stirred_, state.updates);
        });
        largest = 0.0;
        for (const PartState& state : states_) largest = std::max(largest, state.change);
        if (k == 0) restless = std::max(restless, constants::small_steps::small_share * largest);
        team.wait_for_all();  // before anyone writes the next changes
    }
    dissection_.in_any_order(team, [&](const Part& part) {
        PartSweeps& sweeps = state_of(part).sweeps;
        add_up(sweeps.fours(), pushes);
        for (const PartSweeps::Block& block : sweeps.blocks()) {
            for (int i = 0; i < block.count; ++i) {
                const solvers::UnitRow& row = rows_.rows_of(block)[i];
                if (row.scale > 0.0) sums[static_cast<std::size_t>(block.begin + i)] += row.y / row.scale;
            }
        }
    });
}

// Writes the forces of the rows, and the lasting forces on the bodies.
void SmallSteps::store(const Step& step, Team& team) {
    const Eigen::Index last = step.lambda.cols() - 1;
    const bool two = dissection_.island().columns == 2;  // else both columns hold the same
    dissection_.by_rounds(team, [&](const Part& part) {
        each_row(part, [&](std::size_t number, int j) {
            const double scale = rows_.rows[number].scale;
            step.lambda(j, last) = lasting_[number] / step.system.dt;
            step.lambda(j, 0) = two ? pushing_[number] / step.system.dt : step.lambda(j, last);
            const double latest = scale > 0.0 ? rows_.rows[number].y / (step.h * scale) : 0.0;
            step.ending[static_cast<std::size_t>(j)] = {latest, latest};
        });
        for (Eigen::Index column = 0; column <= last; ++column) {
            each_row(part, [&](std::size_t, int j) { clamp_force(step.system.rows, j, column, step.lambda); });
        }
    });
}

// Targets of the displacement of each one-sided row of the part, after the last small step: what is left of the
// correction of its source, and no way into each other for the others.
void SmallSteps::plan_push(const Step& step, const Part& part) {
    PartState& state = state_of(part);
    state.is_pushed = false;
    for (const Holding& own : state.holding) {
        if (own.open_side == 0.0) continue;
        const ConstraintRow& source = row_of(step.system, own.of_step);
        solvers::UnitRow& row = rows_.rows[own.row];
        const double moved = moved_along(row) - step.system.dt * own.carried;
        const double error = own.open_side * (source.error + moved), before = own.open_side * source.error;
        const double correcting = own.open_side * step.system.dt * source.push.correcting;
        double want = -error;
        if (error <= 0.0) {
            // By what its force compresses it, it would be compressed again, and what it carries would creep.
            const double pressed = std::abs(row.y) * row.scale * step.h / constants::small_steps::stiffness;
            want = std::clamp(correcting, 0.0, std::max(0.0, -before - pressed)) -
                   std::max(0.0, own.open_side * moved);
            want = std::max(0.0, want);
        }
        row.t = own.open_side * want / row.scale;
        row.y = 0.0;
        state.is_pushed = state.is_pushed || want > 0.0;
    }
}

// The velocities of the rows become displacements.
void SmallSteps::push_apart(const Step& step, Team& team) {
    each_body(team, [this](std::size_t i) { base_[i] = rows_.velocity[i]; });
    dissection_.in_any_order(team, [&](const Part& part) { plan_push(step, part); });
    team.wait_for_all();
    if (std::none_of(states_.begin(), states_.end(), [](const PartState& state) { return state.is_pushed; }))
        return;
    each_body(team, [this](std::size_t i) { rows_.velocity[i].setZero(); });
    for (int k = 0; k < constants::small_steps::push_sweeps; ++k) {
        dissection_.by_rounds(team, [&](const Part& part) {
            for (const Holding& own : state_of(part).holding) {
                if (own.open_side == 0.0) continue;
                solvers::UnitRow& row = rows_.rows[own.row];
                rows_.set(row, rows_.clamped(row, row.y + rows_.error(row)));
            }
        });
    }
    each_body(team, [this](std::size_t i) { moved_[i] += rows_.velocity[i]; });
}

// Constant forces that move the bodies in a whole step as far as the small steps did, and leave their velocities.
void SmallSteps::write_forces(const Step& step, Team& team) const {
    each_body(team, [&](std::size_t i) {
        const auto body = static_cast<std::size_t>(dissection_.island().bodies[i]);
        const Body& own = step.bodies[body];
        const auto force_for = [&](const Vector6& x) {
            const Vector6 momenta = momenta_of(step.system.inverse_mass[body], own.inverse_inertia, x);
            return Vector6((momenta - stacked(own.linear_momentum, own.angular_momentum)) / step.system.dt -
                           stacked(own.force, own.torque));
        };
        step.forces.moving[body] = force_for(moved_[i] / step.system.dt);
        if (!detours_.empty()) step.forces.moving[body] -= step.system.detours[body];
        step.forces.lasting[body] = force_for(base_[i]);
    });
}

}  // namespace pushfactor::engine
