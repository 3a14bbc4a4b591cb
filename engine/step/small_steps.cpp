#include "engine/step/small_steps.h"

#include "engine/base/constants.h"
#include "engine/base/index.h"
#include "engine/base/overloaded.h"
#include "engine/bodies/integrator.h"
#include "engine/step/choice.h"

#include <algorithm>
#include <cmath>

namespace pushfactor::engine {

namespace {

// Momenta from x = M^(-1/2)^T p.
Vector6 momenta_of(const InverseMass& inverse_mass, const Vector3& inverse_inertia, const Vector6& x) {
    const Vector3 turning = x.tail<3>().cwiseQuotient(inverse_inertia);
    return stacked(x.head<3>() / inverse_mass.linear_root, inverse_mass.angular_root * turning);
}

Vector6 weighted(const InverseMass& inverse_mass, const Vector3& linear, const Vector3& angular) {
    return stacked(inverse_mass.linear_root * linear, inverse_mass.angular_root.transpose() * angular);
}

// Calls `visit(number in the island, row of the step)` for each row of some blocks of the runs.
template <typename Visit>
void each_row(std::span<const RowRun> runs, std::span<const PartSweeps::Block> blocks, const Visit& visit) {
    auto run = runs.begin();
    for (const PartSweeps::Block& block : blocks) {
        for (int number = block.begin; number < block.begin + block.count; ++number) {
            while (number >= run->first + run->end - run->begin) ++run;
            visit(static_cast<std::size_t>(number), run->begin + number - run->first);
        }
    }
}

}  // namespace

// Calls `visit` with the number of each movable body of this member.
template <typename Visit>
void SmallSteps::each_body(Team& team, const Visit& visit) const {
    dissection_.by_leaves(team, [&](const Dissection::Leaf& leaf, std::size_t) {
        for (int i = leaf.begin; i < leaf.end; ++i) visit(static_cast<std::size_t>(i));
    });
}

SmallSteps::Division SmallSteps::division_of(const SystemEquation& system, std::span<const Body> bodies,
                                             const Island& island) const {
    return division_ ? *division_ : choice::division_of(system, bodies, island);
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

    double aimed = 0.0, updates = 0.0;
    residual_ = 0.0;
    for (const PartState& state : states_) {
        aimed += state.aimed;
        updates += state.updates;
        if (!(state.residual <= residual_)) residual_ = state.residual;
    }
    const int sweeps = 2 * division.steps * division.sweeps;
    updates += 1.0 * sweeps * island.rows;
    return {.iterations = sweeps,
            .row_updates = updates,
            .multiply_adds = 24.0 * (updates + 2.0 * division.steps * aimed)};
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
    dissection_.in_any_order(team, [&](const Part& part) {
        state_of(part).residual = state_of(part).sweeps.residual(rows_);
        store(step, part);
    });
    push_apart(step, team);
    write_forces(step, team);
}

void SmallSteps::load(const Step& step, Team& team) {
    each_body(team, [this](std::size_t i) { rows_.velocity[i].setZero(); });
    team.wait_for_all();
    dissection_.by_rounds(team, [&](const Part& part) {
        state_of(part).sweeps.load(
            {step.system, dissection_.island(), part.runs, step.lambda, step.lambda.cols() - 1, step.h}, rows_,
            scratch_);
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
    dissection_.in_any_order(team, [&](const Part& part) { begin(step, part); });
}

void SmallSteps::begin(const Step& step, const Part& part) {
    PartState& state = state_of(part);
    state.updates = 0;
    state.holding.clear();
    state.followed.clear();
    each_row(part.runs, state.sweeps.blocks(), [&](std::size_t number, int j) {
        const ConstraintRow& source = step.system.rows[at(j)];
        solvers::UnitRow& row = rows_.rows[number];
        const double carried = step.system.carried_by(static_cast<std::size_t>(j));
        const ConstraintSource* const follows = step.sources.follower_of(j);
        if (follows) {
            const bool goes_on = !state.followed.empty() && state.followed.back().source == follows &&
                                 state.followed.back().of_step + state.followed.back().count == j &&
                                 step.system.rows[at(j - 1)].label.point == source.label.point;
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
    state.aimed = static_cast<double>(state.holding.size());
    for (const FourContacts& four : state.sweeps.fours()) {
        for (std::size_t k = 0; k < FourContacts::count; ++k) state.aimed += four.holds[k] ? 1.0 : 0.0;
    }
}

// s u . d of a row [m].
double SmallSteps::moved_along(const solvers::UnitRow& row) const {
    const auto half = [this](int body, const Vector6& axis) {
        const auto number = static_cast<std::size_t>(body);
        return number < moved_.size() ? axis.dot(moved_[number]) : 0.0;
    };
    return row.scale * (half(row.a, row.unit->a) + half(row.b, row.unit->b));
}

// Targets of a solve. Bodies move between the solve with the push and the one without.
void SmallSteps::aim(const Aim& aim, const Part& part) {
    PartState& state = state_of(part);
    engine::aim(state.sweeps.fours(), aim, moved_);
    for (Holding& own : state.holding) {
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
    dissection_.by_rounds(team, [&](const Part& part) { follow(step, part); });
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
            state.change = k < whole ? state.sweeps.sweep(rows_, !pushes)
                                     : state.sweeps.sweep_restless(rows_, !pushes, restless, k, k == whole,
                                                                   stirred_, state.updates);
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

// Writes the forces of the rows. Bounds follow rows of the same part.
void SmallSteps::store(const Step& step, const Part& part) {
    PartSweeps& sweeps = state_of(part).sweeps;
    const Eigen::Index last = step.lambda.cols() - 1;
    const bool two = dissection_.island().columns == 2;  // else both columns hold the same
    const auto write = [&](Eigen::Index j, double pushing, double lasting, double y, double scale) {
        step.lambda(j, last) = lasting / step.system.dt;
        step.lambda(j, 0) = two ? pushing / step.system.dt : step.lambda(j, last);
        const double latest = scale > 0.0 ? y / (step.h * scale) : 0.0;
        step.ending[static_cast<std::size_t>(j)] = {latest, latest};
    };
    const auto clamp = [&](Eigen::Index j) {
        for (Eigen::Index column = 0; column <= last; ++column)
            clamp_force(step.system.rows, j, column, step.lambda);
    };
    for (const FourContacts& four : sweeps.fours()) {
        for (std::size_t k = 0; k < FourContacts::count; ++k) {
            if (four.row[k] == FourContacts::none) continue;
            for (int i = 0; i < FourContacts::rows; ++i) {
                write(four.row[k] + i, four.pushing[i][k], four.lasting[i][k], four.y[i][k], four.scale[i][k]);
                clamp(four.row[k] + i);
            }
        }
    }
    each_row(part.runs, sweeps.blocks(), [&](std::size_t number, int j) {
        const solvers::UnitRow& row = rows_.rows[number];
        write(j, pushing_[number], lasting_[number], row.y, row.scale);
        clamp(j);
    });
}

// Targets of the displacement of each one-sided row of the part, after the last small step.
void SmallSteps::plan_push(const Step& step, const Part& part) {
    PartState& state = state_of(part);
    const Apart apart{step.system.dt, step.h};
    state.is_pushed = false;
    for (const Holding& own : state.holding) {
        if (own.open_side == 0.0) continue;
        solvers::UnitRow& row = rows_.rows[own.row];
        const double moved = moved_along(row) - apart.dt * own.carried;
        const double correcting = step.system.rows[at(own.of_step)].push.correcting;
        double want = 0.0;
        find_left(apart, own.open_side * own.start, own.open_side * moved, own.open_side * correcting,
                  row.y * row.scale, want);
        row.t = own.open_side * want / row.scale;
        row.y = 0.0;
        state.is_pushed = state.is_pushed || want > 0.0;
    }
    aim_apart(state.sweeps.fours(), apart, moved_);
    for (const FourContacts& four : state.sweeps.fours()) {
        for (std::size_t k = 0; k < FourContacts::count; ++k) {
            state.is_pushed = state.is_pushed || (four.holds[k] && four.t[0][k] > 0.0);
        }
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
        dissection_.by_rounds(team, [&](const Part& part) { push_apart(state_of(part)); });
    }
    each_body(team, [this](std::size_t i) { moved_[i] += rows_.velocity[i]; });
}

// One sweep over the one-sided rows of a part.
void SmallSteps::push_apart(PartState& state) {
    auto own = state.holding.begin();
    state.sweeps.in_turn(Overloaded{
        [&](std::span<FourContacts> some) { engine::push_apart(some, rows_.velocity); },
        [&](std::span<const PartSweeps::Block> some) {
            const auto end = static_cast<std::size_t>(some.back().begin + some.back().count);
            for (; own != state.holding.end() && own->row < end; ++own) {
                if (own->open_side == 0.0) continue;
                solvers::UnitRow& row = rows_.rows[own->row];
                rows_.set(row, rows_.clamped(row, row.y + rows_.error(row)));
            }
        },
    });
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
