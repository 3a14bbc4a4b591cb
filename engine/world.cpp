// The step, paper sections 3.2, 5, 6 and 8.1.
//
// The paper solves twice if the single-frame push is used: f_cv with the whole push moves the bodies, f_c0 with the
// lasting part alone sets their velocity. Both have the same A, so here they are two columns of one solve.
#include "engine/world.h"

#include "engine/base/constants.h"
#include "engine/constraints/carried.h"
#include "engine/impacts/impacts.h"

#include <cassert>

namespace pushfactor::engine {

namespace {

// Multiply-adds of the last step that threads could have shared, from which on this step uses threads: some tenths
// of a millisecond, while waking them takes some hundredths. Rows and bodies count as that many in addition to the
// solver.
constexpr double worth_threads = 6e5;
constexpr double work_of_a_row = 200.0, work_of_a_body = 100.0;

}  // namespace

World::World() = default;
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;
World::~World() = default;

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
    for (bool again = true; again;) {
        put_back();
        find_awake(dt);  // all, unless some are at rest
        add_forces(dt);  // 3.1
        ended(Phase::forces);
        append_rows(dt);  // 5
        again = impacts && !take_impacts(dt);
        if (again) continue;
        ended(Phase::rows);
        build_system(bodies, awake_.members(), rows_.all(), dt, system_, sharing_);  // 6: A lambda = b, 6.2.9
        ended(Phase::system);
        work = solve_and_look(dt);  // 7, island by island
        ended(Phase::solve);
        again = wakes_some();
    }
    shareable_work_ = work.multiply_adds - work.alone + work_of_a_row * static_cast<double>(rows_.size()) +
                      work_of_a_body * static_cast<double>(awake_.members().size());
    remember();  // 6.2.3
    ended(Phase::remember);
    integrate(dt);  // 3.2, 8.1
    strayed_.clear();
    before_.clear();
    system_.detours.clear();
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

void World::find_awake(double dt) {
    if (awake_.of() != bodies.size()) {
        awake_ = Awake(bodies.size());
        if (rest) add_forces(awake_, dt);  // resting ones keep theirs from here on
    }
    if (!rest) return;
    const std::vector<int> changed = rest->take_changed();
    if (changed.empty()) return;
    awake_.update(changed, [this](int body) { return !rest->is_at_rest(body); });
    for (const auto& source : constraints) source->leave_out_others(bodies, awake_, changed);
    step_solver_.leave_out_others(bodies, awake_, changed);
}

bool World::wakes_some() {
    return rest && rest->wake_pushed(system_, lambda());
}

void World::add_forces(double dt) {
    add_forces(awake_, dt);
}

void World::add_forces(const Awake& to, double dt) {
    for (const int index : to.members()) {
        Body& body = bodies[static_cast<std::size_t>(index)];
        body.force.setZero();
        body.torque.setZero();
    }
    const ForcedBodies forced(bodies, to);
    for (const auto& source : forces) source->add_forces(forced, time_, time_ + dt);
}

// Against the gravity of all sources, unit length; zero without any.
Vector3 World::up() const {
    Vector3 gravity = Vector3::Zero();
    for (const auto& source : forces) gravity += source->gravity();
    return gravity.isZero(0.0) ? Vector3(Vector3::Zero()) : Vector3(-gravity / gravity.norm());
}

void World::append_rows(double dt) {
    rows_.append(constraints, start_of(dt));
    system_.carried.clear();
    carry_rows(dt);
}

bool World::append_unforeseen(double dt) {
    const std::size_t known = rows_.size();
    rows_.append_unforeseen(constraints, start_of(dt), step_solver_.forces().moving, step_solver_.changed());
    carry_rows(dt);
    return rows_.size() > known;
}

bool World::take_impacts(double dt) {
    if (!impacts->fly(start_of(dt), rows_.sources_of(constraints), rows_.all(), awake_)) return true;
    if (!impacts->resting().empty()) {
        for (const int body : impacts->resting()) rest->wake(body);
        return false;
    }
    for (const int body : impacts->followed()) stray(body, dt);
    append_rows(dt);
    return true;
}

// The body enters the step with the momenta that its impacts have left, and takes another way to where it ends.
void World::stray(int body, double dt) {
    const auto i = static_cast<std::size_t>(body);
    Body& own = bodies[i];
    before_.push_back(own);
    const Flight& flight = impacts->flight_of(body);
    own.linear_momentum = flight.linear_momentum();
    own.angular_momentum = flight.angular_momentum();
    const Place end = flight.end();
    const Motion way = motion_between({own.position, own.orientation}, end, dt);
    strayed_.push_back({body, end, way});
    system_.detours.resize(bodies.size(), Vector6::Zero());
    const Vector3 spin = angular_momentum_of(own, way.angular_velocity);
    system_.detours[i] = stacked((way.velocity / own.inverse_mass - own.linear_momentum) / dt - own.force,
                                 (spin - own.angular_momentum) / dt - own.torque);
}

// Takes back the impacts of a step that begins again.
void World::put_back() {
    for (std::size_t k = 0; k < strayed_.size(); ++k)
        bodies[static_cast<std::size_t>(strayed_[k].body)] = before_[k];
    strayed_.clear();
    before_.clear();
    system_.detours.clear();
}

// Moved bodies take the others along: their part of J v1.
void World::carry_rows(double dt) {
    if (!moved_.empty()) carried_speeds(bodies, dt, rows_.all(), system_.carried);
}

SolveWork World::solve_and_look(double dt) {
    SolveWork work = step_solver_.solve(problem());
    for (int look = 0; look < constants::collision::most_looks; ++look) {
        const std::size_t known = rows_.size();
        if (!append_unforeseen(dt)) break;
        extend_system(rows_.all(), system_);
        work += step_solver_.solve_again(problem(), known);
    }
    return work;
}

void World::remember() {
    rows_.hand_out(constraints, step_solver_.end(problem()));
}

double World::stored_energy() const {
    double sum = 0.0;
    for (const auto& source : constraints) sum += source->stored_energy(bodies);
    return sum;
}

void World::resume(double time) {
    time_ = time;
    awake_ = {};
    follow_paths();
}

void World::prepare(double dt) {
    begin_paths(dt);
    find_awake(dt);
    add_forces(dt);
    append_rows(dt);
    build_system(bodies, awake_.members(), rows_.all(), dt, system_, sharing_);
    step_solver_.solve(problem());
    remember();
}

void World::kick_back_half(double dt) {
    prepare(dt);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        Body& body = bodies[i];
        if (body.is_static()) continue;
        const Vector6& f_c = step_solver_.lasting_force(i);
        body.linear_momentum = advance_momentum(body.linear_momentum, body.force + f_c.head<3>(), -0.5 * dt);
        body.angular_momentum = advance_momentum(body.angular_momentum, body.torque + f_c.tail<3>(), -0.5 * dt);
    }
}

// What constraints add to these forces is what their next solution takes away again.
void World::change_step(double from, double dt) {
    find_awake(dt);
    add_forces(dt);
    const double back = 0.5 * (from - dt);
    for (const int body : awake_.members()) {
        Body& own = bodies[static_cast<std::size_t>(body)];
        if (own.is_static()) continue;
        own.linear_momentum = advance_momentum(own.linear_momentum, own.force, back);
        own.angular_momentum = advance_momentum(own.angular_momentum, own.torque, back);
    }
}

void World::integrate(double dt) {
    const std::span<const int> awake = awake_.members();
    share_each(sharing_, awake, bodies_of_a_part, [&](int index) {
        const auto i = static_cast<std::size_t>(index);
        integrate(bodies[i], i, dt);
    });
    for (const Strayed& own : strayed_) {
        const auto i = static_cast<std::size_t>(own.body);
        const Vector6 held = dt * dt * accelerate(system_.inverse_mass[i], step_solver_.forces().moving[i]);
        bodies[i].position = own.end.position + held.head<3>();
        bodies[i].orientation = own.end.orientation;
        if (!held.tail<3>().isZero(0.0)) bodies[i].orientation = exponential(held.tail<3>()) * own.end.orientation;
    }
}

void World::integrate(Body& body, std::size_t i, double dt) {
    if (body.is_static()) return;
    const Vector6& f_cv = step_solver_.forces().moving[i];

    // With a single-frame push (8.1) these momenta are used for this move only.
    const Vector3 p = advance_momentum(body.linear_momentum, body.force + f_cv.head<3>(), dt);
    const Vector3 l = advance_momentum(body.angular_momentum, body.torque + f_cv.tail<3>(), dt);
    const Quaternion turned = rotate(body, l, dt);
    body.position = advance_position(body, p, dt);
    if (!step_solver_.has_lasting_force(i)) {
        body.orientation = turned;
        body.linear_momentum = p;
        body.angular_momentum = l;
        return;
    }
    const Vector6& f_c0 = step_solver_.forces().lasting[i];
    body.linear_momentum = advance_momentum(body.linear_momentum, body.force + f_c0.head<3>(), dt);
    body.angular_momentum = advance_momentum(body.angular_momentum, body.torque + f_c0.tail<3>(), dt);
    body.orientation = turned;
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
    for (const StepRows::Part& part : rows_.parts()) {
        if (constraints[part.source]->can_leave_out()) continue;
        for (const ConstraintRow& row : rows_.all().subspan(part.begin, part.end - part.begin)) {
            rest->wake(row.body_a);
            rest->wake(row.body_b);
        }
    }
    if (turns_unseen_.size() != bodies.size()) find_what_turns_unseen();
    rest->end_step(bodies, turns_unseen_, system_, step_solver_, dt);
}

StepCount World::count(const SolveWork& work) const {
    StepCount count = step_solver_.count(system_, work);
    if (rest) count.at_rest = rest->count();
    if (impacts) {
        count.impacts = impacts->count();
        count.impacts_cut_short = impacts->is_cut_short();
    }
    return count;
}

}  // namespace pushfactor::engine
