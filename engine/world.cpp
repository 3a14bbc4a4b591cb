// The step, paper sections 3.2, 5, 6 and 8.1.
//
// The paper solves twice if the single-frame push is used: f_cv with the whole push moves the bodies, f_c0 with the
// lasting part alone sets their velocity. Both have the same A, so here they are two columns of one solve.
#include "engine/world.h"

#include "engine/constraints/carried.h"

#include <algorithm>
#include <cassert>

namespace pushfactor::engine {

namespace {

// Limit on re-solves per step; each adds contacts for bodies that the last solve threw into something, one more
// body of a chain of collisions each time; one of them finishes what was left unsolved.
constexpr int most_looks = 9;

// Multiply-adds of the last step that threads could have shared, from which on this step uses threads: some tenths
// of a millisecond, while waking them takes some hundredths. Rows and bodies count as that many in addition to the
// solver.
constexpr double worth_threads = 6e5;
constexpr double work_of_a_row = 200.0, work_of_a_body = 100.0;

// Work items per thread task.
constexpr std::size_t bodies_of_a_part = 250, rows_of_a_part = 1000;

bool has_row_from(const Island& island, std::size_t first_row) {
    return static_cast<std::size_t>(island.runs.back().end) > first_row;
}

}  // namespace

StepCount World::step(double dt, PhaseObserver* observer) {
    assert(dt > 0.0);
    if (!threads_worth_calling()) return take_step(dt, observer);
    StepCount count;
    sharing_ = threads.get();
    threads->keep_at_hand([&] { count = take_step(dt, observer); });
    sharing_ = nullptr;
    return count;
}

Threads* World::threads_worth_calling() const {
    return shareable_work_ >= worth_threads ? threads.get() : nullptr;
}

StepCount World::take_step(double dt, PhaseObserver* observer) {
    const auto ended = [observer](Phase phase) {
        if (observer) observer->phase_ended(phase);
    };
    SolveWork work;
    begin_paths(dt);  // of moved bodies
    do {
        find_awake();  // all, unless some are at rest
        add_forces();  // 3.1
        ended(Phase::forces);
        append_rows(dt);  // 5
        ended(Phase::rows);
        build_system(bodies, awake_.members(), rows_, dt, system_, sharing_);  // 6: A lambda = b, 6.2.9
        ended(Phase::system);
        work = solve_and_look(dt);  // 7, island by island
        ended(Phase::solve);
    } while (wakes_some());
    shareable_work_ = work.multiply_adds - work.alone + work_of_a_row * static_cast<double>(rows_.size()) +
                      work_of_a_body * static_cast<double>(awake_.members().size());
    remember();  // 6.2.3
    ended(Phase::remember);
    integrate(dt);  // 3.2, 8.1
    time_ += dt;
    follow_paths();
    if (rest) settle(dt);
    ended(Phase::integrate);
    return count(work);
}

void World::move(int body, std::unique_ptr<const Path> path) {
    assert(bodies[static_cast<std::size_t>(body)].is_static());
    moved_.push_back({static_cast<std::size_t>(body), std::move(path)});
    follow_paths();
}

// Velocities of the moved bodies in the coming step. What rests on them, or in their way, wakes.
void World::begin_paths(double dt) {
    bool any = false;
    for (const Moved& own : moved_) {
        Body& body = bodies[own.body];
        body.prescribed = own.path->mean(time_, time_ + dt);
        any = any || body.is_moved();
    }
    if (!any || !rest || rest->count() == 0) return;
    for (const auto& source : constraints) {
        for (const int body : source->met_by_moved(start_of(dt)).some) {
            if (rest->is_at_rest(body)) rest->wake(body);
        }
    }
}

void World::follow_paths() {
    for (const Moved& own : moved_) {
        const Place place = own.path->at(time_);
        bodies[own.body].position = place.position;
        bodies[own.body].orientation = place.orientation;
    }
}

void World::find_awake() {
    const bool first = awake_.of() != bodies.size();
    if (!rest) {
        if (first) awake_ = Awake(bodies.size());
        return;
    }
    if (!rest->take_change() && !first) return;
    if (first) add_forces(Awake(bodies.size()));  // resting ones keep theirs from here on
    awake_ = rest->awake(bodies.size());
    island_solver_.forget_islands();
    for (const auto& source : constraints) source->leave_out_others(bodies, awake_);
    forces_.moving.resize(bodies.size());
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        // For code that predicts their motion: resting bodies are held.
        if (!awake_.has(static_cast<int>(i))) forces_.moving[i] = -stacked(bodies[i].force, bodies[i].torque);
    }
}

bool World::wakes_some() {
    const bool woken = rest && rest->wake_pushed(system_, lambda_);
    if (woken) island_solver_.take_back(awake_.members());
    return woken;
}

void World::add_forces() {
    add_forces(awake_);
}

void World::add_forces(const Awake& to) {
    for (const int index : to.members()) {
        Body& body = bodies[static_cast<std::size_t>(index)];
        body.force.setZero();
        body.torque.setZero();
    }
    const ForcedBodies forced(bodies, to);
    for (const auto& source : forces) source->add_forces(forced, time_);
}

void World::append_rows(double dt) {
    const StepStart step = start_of(dt);
    rows_.clear();
    appended_.clear();
    for (std::size_t s = 0; s < constraints.size(); ++s) {
        const std::size_t begin = rows_.size();
        constraints[s]->append_rows(step, rows_);
        appended_.push_back({s, begin, rows_.size()});
    }
    system_.carried.clear();
    carry_rows(dt);
}

void World::append_unforeseen(double dt) {
    const StepStart step = start_of(dt);
    for (std::size_t s = 0; s < constraints.size(); ++s) {
        const std::size_t begin = rows_.size();
        constraints[s]->append_unforeseen(step, forces_.moving, changed_, rows_);
        if (rows_.size() > begin) appended_.push_back({s, begin, rows_.size()});
    }
    carry_rows(dt);
}

// Moved bodies take the others along: their part of J v1.
void World::carry_rows(double dt) {
    if (!moved_.empty()) carried_speeds(bodies, dt, rows_, system_.carried);
}

SolveWork World::solve_and_look(double dt) {
    SolveWork work = solve_islands();
    bool finished = false;
    for (int look = 0; look < most_looks; ++look) {
        const std::size_t known = rows_.size();
        append_unforeseen(dt);
        if (rows_.size() > known) {
            extend_system(rows_, system_);
            work += solve_islands_again(known);
        } else if (!finished) {
            work += finish_islands();
            finished = true;
        } else {
            break;
        }
    }
    return work;
}

void World::note_changed(const Island& island) {
    const NewForce kind = outcome_of(island).in_small_steps ? NewForce::of_small_steps : NewForce::of_answer;
    for (const int body : island.bodies) changed_[static_cast<std::size_t>(body)] = kind;
}

SolveWork World::solve_islands() {
    island_solver_.begin(bodies.size(), awake_.members());
    islands_.find(system_, sharing_);
    lambda_.resize(system_.row_count(), system_.column_count());
    guess(0, lambda_);
    forces_.moving.resize(bodies.size());
    forces_.lasting.resize(bodies.size());
    for (const int body : awake_.members()) forces_.moving[static_cast<std::size_t>(body)].setZero();
    choose([](const Island&) { return true; });
    return solve_chosen([this](const Island& island, auto& bench) { return solve(island, nullptr, bench); });
}

SolveWork World::solve_islands_again(std::size_t first_new_row) {
    islands_.find_again(system_, first_new_row);
    const bool second_column = system_.column_count() > lambda_.cols();
    lambda_.conservativeResize(system_.row_count(), system_.column_count());
    if (second_column) lambda_.col(1) = lambda_.col(0);
    guess(first_new_row, lambda_);
    first_guess_.resize(lambda_.rows(), lambda_.cols());
    guess(0, first_guess_);
    choose([&](const Island& island) { return has_row_from(island, first_new_row); });
    return solve_chosen([this](const Island& island, auto& bench) { return solve(island, &first_guess_, bench); });
}

// Chooses islands to be solved again, whose bodies get new forces.
template <typename Predicate>
void World::choose(const Predicate& predicate) {
    changed_.assign(bodies.size(), NewForce::none);
    chosen_.clear();
    for (std::size_t k = 0; k < islands_.all().size(); ++k) {
        if (predicate(islands_.all()[k])) chosen_.push_back(static_cast<int>(k));
    }
}

SolveWork World::finish_islands() {
    choose([this](const Island& island) { return island_solver_.can_go_on(island, termination); });
    return solve_chosen([this](const Island& island, auto& bench) {
        return SolveWork(island, island_solver_.go_on(bench, termination, system_, island, lambda_, forces_));
    });
}

template <typename Solve>
SolveWork World::solve_chosen(const Solve& solve) {
    if (chosen_.empty()) return {};
    if (small_steps) endings_.resize(rows_.size());
    benches_.set_up(solver.get(), small_steps.get(), sharing_);
    const SolveWork work = benches_.solve(islands_.all(), chosen_, solve);
    for (const int number : chosen_) note_changed(islands_.all()[static_cast<std::size_t>(number)]);
    return work;
}

void World::guess(std::size_t first_row, Columns& lambda) const {
    const Eigen::Index last = lambda.cols() - 1;
    share(sharing_, rows_.size() - first_row, rows_of_a_part, [&](std::size_t begin, std::size_t end) {
        for (std::size_t j = first_row + begin; j < first_row + end; ++j) {
            const auto row = static_cast<Eigen::Index>(j);
            lambda(row, 0) = rows_[j].guess.first;
            lambda(row, last) = rows_[j].guess.last;  // with one column these forces set the momenta
        }
    });
    for (const Island& island : islands_.all()) {
        if (island.columns > last || !has_row_from(island, first_row)) continue;
        for (const RowRun& run : island.runs) {
            for (int j = std::max(run.begin, static_cast<int>(first_row)); j < run.end; ++j) {
                lambda(j, 0) = lambda(j, last);
            }
        }
    }
    // Rows without movable bodies belong to no island.
    for (std::size_t j = first_row; j < rows_.size() && !islands_.hold_all_rows(); ++j) {
        const auto row = static_cast<Eigen::Index>(j);
        if (!(system_.diagonal[row] > 0.0)) lambda.row(row).setZero();
    }
}

SolveWork World::solve(const Island& island, Columns* first_guess, IslandSolver::Bench& bench) {
    IslandSolver::Allowed allowed;
    // A single row is solved exactly at no cost.
    if (small_steps && island.rows > 1) {
        allowed.iterates_up_to = small_step_rules::largest_to_sweep(system_.dt, bodies, island);
        allowed.stands_up_to = small_step_rules::standing_speed(system_.dt, bodies, island);
    }
    SolveWork work(
        island, island_solver_.solve(bench, termination, system_, island, allowed, first_guess, lambda_, forces_));
    if (!outcome_of(island).unfinished) return work;
    work.add(SolveWork(
        island, island_solver_.take_small_steps(bench, system_, bodies, island, lambda_, forces_, endings_)));
    return work;
}

void World::remember() {
    answers_.assign(rows_.size(), {});
    for (const Island& island : islands_.all()) {
        share(sharing_, island.runs.size(), rows_of_a_part, [&](std::size_t begin, std::size_t end) {
            for (const RowRun& run : island.runs.subspan(begin, end - begin)) find_next_guesses(island, run);
        });
    }
    island_solver_.end(awake_.members());
    hand_out_answers();
}

void World::find_next_guesses(const Island& island, const RowRun& run) {
    if (outcome_of(island).in_small_steps) {
        std::copy(endings_.begin() + run.begin, endings_.begin() + run.end, answers_.begin() + run.begin);
        return;
    }
    const Eigen::Index last = lambda_.cols() - 1;
    const ConstraintRow& first = rows_[static_cast<std::size_t>(run.begin)];
    const WarmStart::Next next = island_solver_.warm_start().next(first.body_a, first.body_b);
    for (int j = run.begin; j < run.end; ++j) {
        const auto row = static_cast<std::size_t>(j);
        const Lambda answer{lambda_(j, 0), lambda_(j, last)};
        answers_[row] = next.takes_answer() ? answer : next(rows_[row].guess, answer);
    }
}

// Each source gets its own rows, in the order in which it has appended them.
void World::hand_out_answers() {
    const std::span answers(answers_);
    for (std::size_t s = 0; s < constraints.size(); ++s) {
        const Appended& first = appended_[s];
        const bool all = appended_.size() == constraints.size();
        if (all) {
            constraints[s]->remember(answers.subspan(first.begin, first.end - first.begin));
            continue;
        }
        answers_of_source_.clear();
        for (const Appended& part : appended_) {
            if (part.source != s) continue;
            const auto own = answers.subspan(part.begin, part.end - part.begin);
            answers_of_source_.insert(answers_of_source_.end(), own.begin(), own.end());
        }
        constraints[s]->remember(answers_of_source_);
    }
}

double World::stored_energy() const {
    double sum = 0.0;
    for (const auto& source : constraints) sum += source->stored_energy(bodies);
    return sum;
}

void World::resume(double time, std::span<const IslandSolver::Memory> memory) {
    time_ = time;
    follow_paths();
    island_solver_.set_memory(memory);
}

void World::prepare(double dt) {
    begin_paths(dt);
    find_awake();
    add_forces();
    append_rows(dt);
    build_system(bodies, awake_.members(), rows_, dt, system_, sharing_);
    solve_islands();
    remember();
}

bool World::has_lasting_force(std::size_t body) const {
    const int island = islands_.of_body(static_cast<int>(body));
    if (island < 0) return false;
    const Island& of_body = islands_.all()[static_cast<std::size_t>(island)];
    return of_body.columns == 2 || outcome_of(of_body).in_small_steps;
}

double World::residual() const {
    // With a fixed number of iterations the solve has not computed the residual.
    if (!(termination.tolerance_high > 0.0)) {
        const auto took_small_steps = [this](const Island& island) { return outcome_of(island).in_small_steps; };
        const std::span<const Island> islands = islands_.all();
        if (std::none_of(islands.begin(), islands.end(), took_small_steps))
            return natural_residual(system_, lambda_);
    }
    double largest = 0.0;
    for (const Island& island : islands_.all()) {
        const IslandSolver::Outcome& outcome = outcome_of(island);
        const bool measured = outcome.in_small_steps || termination.tolerance_high > 0.0;
        const double own = measured ? std::max(outcome.residuals[0], outcome.residuals[1])
                                    : natural_residual(system_, island, lambda_);
        if (!(own <= largest)) largest = own;
    }
    return largest;
}

void World::kick_back_half(double dt) {
    prepare(dt);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        Body& body = bodies[i];
        if (body.is_static()) continue;
        const Vector6& f_c = has_lasting_force(i) ? forces_.lasting[i] : forces_.moving[i];
        body.linear_momentum = advance_momentum(body.linear_momentum, body.force + f_c.head<3>(), -0.5 * dt);
        body.angular_momentum = advance_momentum(body.angular_momentum, body.torque + f_c.tail<3>(), -0.5 * dt);
    }
}

void World::integrate(double dt) {
    const std::span<const int> awake = awake_.members();
    share(sharing_, awake.size(), bodies_of_a_part, [&](std::size_t begin, std::size_t end) {
        for (const int index : awake.subspan(begin, end - begin)) {
            const auto i = static_cast<std::size_t>(index);
            integrate(bodies[i], i, dt);
        }
    });
}

void World::integrate(Body& body, std::size_t i, double dt) {
    if (body.is_static()) return;
    const Vector6& f_cv = forces_.moving[i];

    // With a single-frame push (8.1) these momenta are used for this move only.
    const Vector3 p = advance_momentum(body.linear_momentum, body.force + f_cv.head<3>(), dt);
    const Vector3 l = advance_momentum(body.angular_momentum, body.torque + f_cv.tail<3>(), dt);
    body.position = advance_position(body, p, dt);
    body.orientation = rotate(body, l, dt);

    if (!has_lasting_force(i)) {
        body.linear_momentum = p;
        body.angular_momentum = l;
        return;
    }
    const Vector6& f_c0 = forces_.lasting[i];
    body.linear_momentum = advance_momentum(body.linear_momentum, body.force + f_c0.head<3>(), dt);
    body.angular_momentum = advance_momentum(body.angular_momentum, body.torque + f_c0.tail<3>(), dt);
}

void World::find_what_turns_unseen() {
    turns_unseen_.assign(bodies.size(), 1);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        for (const auto& source : constraints) {
            turns_unseen_[i] = turns_unseen_[i] && source->turns_unseen(static_cast<int>(i));
        }
        for (const auto& source : forces) {
            turns_unseen_[i] = turns_unseen_[i] && source->turns_unseen(static_cast<int>(i));
        }
    }
}

// Bodies affected by a change in the next step are woken now, so that a saved state includes it.
void World::settle(double dt) {
    for (const int body : rest->turning()) {
        Body& own = bodies[static_cast<std::size_t>(body)];
        own.orientation = rotate(own, own.angular_momentum, dt);
    }
    const auto wake = [this](const SomeBodies& changed) {
        if (changed.all) rest->wake_all();
        for (const int body : changed.some) rest->wake(body);
    };
    for (const auto& source : forces) wake(source->pushed_anew(time_ - dt, time_));
    for (const auto& source : constraints) wake(source->changed_anew(time_ - dt, time_));
    const auto forbid = [&](const Appended& part) {
        if (constraints[part.source]->can_leave_out()) return;
        for (std::size_t j = part.begin; j < part.end; ++j) {
            rest->wake(rows_[j].body_a);
            rest->wake(rows_[j].body_b);
        }
    };
    std::for_each(appended_.begin(), appended_.end(), forbid);
    if (turns_unseen_.size() != bodies.size()) find_what_turns_unseen();
    rest->end_step(bodies, turns_unseen_, system_, islands_, lambda_, dt);
}

StepCount World::count(const SolveWork& work) const {
    StepCount count;
    if (!rows_.empty()) {
        for (const RowDigest& row : system_.digests) ++count.rows_of_kind[static_cast<std::size_t>(row.kind)];
    }
    if (rest) count.at_rest = rest->count();
    count.columns = rows_.empty() ? 0 : static_cast<int>(system_.column_count());
    count.islands = static_cast<int>(islands_.all().size());
    for (const Island& island : islands_.all()) {
        const IslandSolver::Outcome& outcome = outcome_of(island);
        count.islands_unsolved += !outcome.solved;
        count.islands_contradicting += outcome.contradicts;
        switch (method_of(island)) {
            case WarmStart::Method::kept:
                ++count.islands_kept;
                break;
            case WarmStart::Method::swept:
                ++count.islands_swept;
                break;
            case WarmStart::Method::exact:
                ++count.islands_exact;
                break;
            case WarmStart::Method::in_small_steps:
                ++count.islands_in_small_steps;
        }
    }
    count.sweeps = work.sweeps;
    count.row_updates = work.row_updates;
    count.multiply_adds = work.multiply_adds;
    return count;
}

}  // namespace pushfactor::engine
