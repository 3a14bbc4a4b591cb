#include "engine/constraints/contact_constraints.h"

#include "engine/base/constants.h"
#include "engine/base/index.h"
#include "engine/constraints/carried.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace pushfactor::engine {

namespace {

// Contacts per thread task.
constexpr std::size_t contacts_of_a_part = 128;

// Sliding as a share of the velocity of an impact that is more than rounding.
constexpr double has_direction = 1e-9;

constexpr Correction at_once{PushKind::single_frame, 1.0};

// Overlap along an axis up to which bodies count as separated along it, as a fraction of the size: the allowed
// penetration plus some room. With zero slop, bodies touch the surface only up to the solver's error; the
// margin then gives the scale.
double permitted_overlap(double slop, double margin) {
    return std::min(0.02, std::max(1.1 * slop, 0.2 * margin));
}

// The body with its momenta unchanged and its centre where `motion` takes it in `time` [s].
Body moved(const Body& body, const Motion& motion, double time) {
    Body moved = body;
    moved.position += time * motion.velocity;
    return moved;
}

// State of a contact row before the step, for 8.2.
Impact impact_of(const ConstraintRow& row, const BodyPair& pair, double restitution, double dt) {
    const auto velocity_of = [](const Body& body) { return stacked(velocity(body), angular_velocity(body)); };
    const auto acceleration_of = [](const Body& body) {
        return stacked(body.inverse_mass * body.force, world_inverse_inertia(body) * body.torque);
    };
    const Jacobian& j = row.jacobian;
    return {.speed = j.a.dot(velocity_of(pair.body_a)) + j.b.dot(velocity_of(pair.body_b)) -
                     carried_speed(row, pair.body_a, pair.body_b, dt),
            .acceleration = j.a.dot(acceleration_of(pair.body_a)) + j.b.dot(acceleration_of(pair.body_b)),
            .gap = row.label.gap,
            .restitution = restitution,
            .dt = dt};
}

}  // namespace

ContactConstraints::ContactConstraints(std::vector<collision::Collider> colliders, const ContactChoices& choices)
    : colliders_(std::move(colliders)), choices_(choices) {
    choices_.detection.permitted = permitted_overlap(choices.slop, choices.detection.margin);
    belts_start_ = std::any_of(colliders_.begin(), colliders_.end(),
                               [](const collision::Collider& own) { return own.surface_from > 0.0; });
}

void ContactConstraints::set_filter(std::unique_ptr<const collision::PairFilter> filter) {
    filter_ = std::move(filter);
    detector_.broad_phase().leave_out(filter_.get());
}

void ContactConstraints::set_materials(std::unique_ptr<const collision::MaterialPairs> materials) {
    materials_ = std::move(materials);
    choices_.detection.materials = materials_.get();
}

Vector3 ContactConstraints::belt_of(const collision::Touch& touch, const BodyPair& pair, double time) const {
    const auto run = [&](int collider, const Body& body) -> Vector3 {
        const collision::Collider& own = colliders_[static_cast<std::size_t>(collider)];
        return runs_at(own, time) ? Vector3(body.orientation * own.surface_velocity) : Vector3::Zero();
    };
    return run(touch.pair.a, pair.body_a) - run(touch.pair.b, pair.body_b);
}

// Friction data shared by all contact points of a touch.
struct ContactConstraints::TouchFriction {
    FrictionBound bound, apart;  // of touching points, and of separated ones
    Vector3 belt;                // m/s
    RelativeMotion motion;       // at the start of the step
    Vector3 resting;             // tangent of points that slide more slowly than the limit
};

ContactConstraints::TouchFriction ContactConstraints::friction_of(const collision::Touch& touch,
                                                                  const BodyPair& pair, const Motion& motion_a,
                                                                  const Motion& motion_b,
                                                                  const StepStart& step) const {
    const Vector3 belt = belt_of(touch, pair, step.time);
    const Vector3& normal = touch.normal;
    const FrictionBound bound =
        friction_({.bodies = pair,
                   .normal = normal,
                   .friction = touch.friction,
                   .points = static_cast<int>(touch.points.size()),
                   .size = touch.size,
                   .acceleration = std::max(accelerations_[at(touch.body_a)], accelerations_[at(touch.body_b)]),
                   .dt = step.dt});
    return {.bound = bound,
            .apart = bound.of_normal_force ? bound : FrictionBound{},
            .belt = belt,
            .motion = RelativeMotion(pair, motion_a, motion_b, belt),
            .resting = collision::tangent_fixed_in(pair.body_a.orientation.toRotationMatrix(), normal)};
}

bool ContactConstraints::closes_loop(const BodyPair& pair) const {
    return !mechanisms_.empty() && mechanisms_[at(pair.a)] == mechanisms_[at(pair.b)];
}

void ContactConstraints::write_normal(const Contact& contact, const BodyPair& pair, const PairPoint& at, double dt,
                                      ConstraintRow& row) const {
    const collision::Touch& touch = *contact.touch;
    const collision::ContactPoint& point = touch.points[static_cast<std::size_t>(contact.point)];
    std::construct_at(&row);
    const double slop = choices_.slop * touch.size;
    write_contact_row(at, touch.normal, point.gap, choices_.correction, slop, dt, row);
    // What the solution so far leaves at the end of the step is taken away whole, and leaves no speed.
    if (touch.ends_deep && point.gap < 0.0) {
        row.push = {.correcting = -point.gap / dt, .lasting = 0.0};
        row.correction = &at_once;
    }
    if (restitution_ && touch.restitution > 0.0) {
        row.push = restitution_(row.push, impact_of(row, pair, touch.restitution, dt));
        if (row.push.lasting < 0.0) row.error = point.gap;  // it does not aim at rest
    }
    if (closes_loop(pair)) soften(pair.body_a, pair.body_b, row);
    row.label.point = contact.point;
    row.guess = forces_[contact.force].normal;
}

void ContactConstraints::write_friction(Contact& contact, const PairPoint& at, const TouchFriction& shared,
                                        std::span<ConstraintRow> rows) const {
    const Vector3& normal = contact.touch->normal;
    const collision::ContactPoint& point = contact.touch->points[static_cast<std::size_t>(contact.point)];

    const bool apart = point.gap > constants::rows::apart * contact.touch->size;
    const FrictionBound& bound = apart ? shared.apart : shared.bound;
    contact.tangents = friction_tangents(normal, shared.motion.sliding(point.position, normal), bound.least_sliding,
                                         shared.resting);
    for (const Disc which : {Disc::first, Disc::second}) {
        const std::size_t k = which == Disc::first ? 0 : 1;
        const Vector3& tangent = contact.tangents[k];
        ConstraintRow& row = rows[static_cast<std::size_t>(contact.friction_row) + k];
        std::construct_at(&row);
        write_friction_row(at, tangent, bound.at(contact.normal_row, which), tangent.dot(shared.belt), row);
        const ContactForce& force = forces_[contact.force];
        row.label.point = contact.point;
        row.label.gap = point.gap;
        row.guess = {tangent.dot(force.friction_first), tangent.dot(force.friction_last)};
    }
}

// Appends the contacts of the touches in the given order, whose rows begin with `row`: per contact one normal row,
// then its two friction rows if it has any; or all friction rows after all normal rows.
std::span<ContactConstraints::Contact> ContactConstraints::add_contacts(std::span<const collision::Touch> touches,
                                                                        std::span<const ContactIndex> order,
                                                                        int row) {
    std::size_t force = contacts_.empty() ? 0 : forces_.size();
    first_force_.clear();
    for (const collision::Touch& touch : touches) {
        first_force_.push_back(force);
        force += touch.points.size();
    }
    forces_.resize(force);  // zero if not cached

    const bool interleaved = choices_.order != RowOrder::normals_first;
    const int begin = row, foreign_rows = row - own_rows_;
    int friction = row + static_cast<int>(order.size());  // behind all normal rows
    for (const ContactIndex& index : order) {
        Contact& contact = contacts_.emplace_back();
        contact.touch = &touches[at(index.touch)];
        contact.point = index.point;
        contact.force = first_force_[at(index.touch)] + at(index.point);
        contact.foreign_rows = foreign_rows;
        contact.normal_row = row++;
        contact.friction_row = -1;
        if (!has_friction(*contact.touch)) continue;
        int& next = interleaved ? row : friction;
        contact.friction_row = next;
        next += 2;
    }
    own_rows_ += (interleaved ? row : friction) - begin;
    return std::span(contacts_).last(order.size());
}

void ContactConstraints::find_motions(const StepStart& step) {
    before_.resize(step.bodies.size());
    after_.resize(step.bodies.size());
    paths_.resize(step.bodies.size());
    accelerations_.resize(step.bodies.size(), 0.0);
    const std::span<const int> awake = awake_bodies_.members();
    share_each(step.threads, awake, bodies_of_a_part, [&](int index) {
        const auto i = static_cast<std::size_t>(index);
        const Body& body = step.bodies[i];
        before_[i] = motion_of(body);
        after_[i] = motion_of(body, step.dt);
        paths_[i] = motion_in_step(body, step.dt, step.rotate);
        accelerations_[i] = body.inverse_mass * body.force.norm();
    });
    strayed_.clear();
    if (step.strayed.empty()) return;
    strayed_.resize(step.bodies.size());
    for (const Strayed& own : step.strayed) {
        after_[at(own.body)] = paths_[at(own.body)] = own.way;
        strayed_[at(own.body)] = 1;
    }
}

void ContactConstraints::append_touches(std::span<const collision::Touch> touches, ContactOrder& order,
                                        const StepStart& step, std::span<const Motion> paths, RowList& rows) {
    const std::span<const ContactIndex> in_order = order.put(choices_.order, touches, step.bodies, step.up);
    const int before = own_rows_;
    const std::span<Contact> contacts = add_contacts(touches, in_order, static_cast<int>(rows.size()));
    const std::span<ConstraintRow> all = rows.append(at(own_rows_ - before));
    share(step.threads, contacts.size(), contacts_of_a_part,
          [&](std::size_t begin, std::size_t end) { write_rows(contacts, begin, end, step, paths, all); });
}

// Writes the rows of contacts `begin` .. `end` - 1. Of bodies that meet within the step the lever arms are those of
// that time, where `paths` have taken them.
void ContactConstraints::write_rows(std::span<Contact> contacts, std::size_t begin, std::size_t end,
                                    const StepStart& step, std::span<const Motion> paths,
                                    std::span<ConstraintRow> rows) const {
    for (std::size_t i = begin; i < end;) {
        const collision::Touch& touch = *contacts[i].touch;
        const auto a = static_cast<std::size_t>(touch.body_a), b = static_cast<std::size_t>(touch.body_b);
        std::optional<Body> a_then, b_then;
        if (touch.time > 0.0) {
            a_then = moved(step.bodies[a], paths[a], touch.time);
            b_then = moved(step.bodies[b], paths[b], touch.time);
        }
        const BodyPair pair{touch.body_a, touch.body_b, a_then ? *a_then : step.bodies[a],
                            b_then ? *b_then : step.bodies[b]};
        std::optional<TouchFriction> shared;
        if (has_friction(touch)) shared = friction_of(touch, pair, before_[a], before_[b], step);
        for (; i < end && contacts[i].touch == &touch; ++i) {
            Contact& contact = contacts[i];
            const PairPoint at(pair, touch.points[static_cast<std::size_t>(contact.point)].position);
            write_normal(contact, pair, at, step.dt, rows[static_cast<std::size_t>(contact.normal_row)]);
            if (shared) write_friction(contact, at, *shared, rows);
        }
    }
}

void ContactConstraints::append_impact_rows(const collision::Touch& touch, const BodyPair& bodies,
                                            const StepStart& step, RowList& rows) const {
    const Motion motion_a = motion_of(bodies.body_a), motion_b = motion_of(bodies.body_b);
    std::optional<TouchFriction> shared;
    if (has_friction(touch)) shared = friction_of(touch, bodies, motion_a, motion_b, step);
    if (shared && !shared->bound.of_normal_force) shared->bound.limit *= step.dt;
    for (const collision::ContactPoint& point : touch.points) {
        const PairPoint place(bodies, point.position);
        const auto normal_row = static_cast<int>(rows.size());
        ConstraintRow& normal = rows.emplace_back();
        place.place(normal, touch.normal);
        normal.bounds.c_min = 0.0;
        normal.label = {.kind = RowKind::contact, .point = 0, .gap = 0.0};
        if (!shared) continue;
        const double speed =
            (velocity_at(bodies.body_b, point.position) - velocity_at(bodies.body_a, point.position) - shared->belt)
                .norm();
        const double least = std::max(shared->bound.least_sliding, has_direction * speed);
        const auto tangents = friction_tangents(touch.normal, shared->motion.sliding(point.position, touch.normal),
                                                least, shared->resting);
        for (const Disc which : {Disc::first, Disc::second}) {
            const Vector3& tangent = tangents[which == Disc::first ? 0 : 1];
            write_friction_row(place, tangent, shared->bound.at(normal_row, which), tangent.dot(shared->belt),
                               rows.emplace_back());
        }
    }
}

collision::StepScene ContactConstraints::scene_of(const StepStart& step, const StepMotions& motions) {
    return {colliders_, step.bodies, detector_.poses(), choices_.detection, &motions, &kept_};
}

void ContactConstraints::append_rows(const StepStart& step, RowList& rows) {
    const std::span<const Body> bodies = step.bodies;
    threads_ = step.threads;
    // First drop references to the touches of the last step, whose points and meetings the search invalidates.
    contacts_.clear();
    unforeseen_.clear();
    kept_.clear();
    touches_ = {};
    if (awake_bodies_.of() != bodies.size()) wake_all(bodies.size());
    const auto moved = [](const Awake& awake, const std::vector<int>& known) {
        return known.empty() ? awake.members() : std::span<const int>(known);
    };
    const collision::AwakeColliders awake{awake_colliders_, moved(awake_colliders_, moved_colliders_),
                                          moved(awake_bodies_, moved_bodies_)};
    find_motions(step);
    const StepMotions motions{step.dt, before_, after_, paths_, strayed_};
    std::vector<collision::Touch>& touches =
        detector_.detect(colliders_, bodies, choices_.detection, &motions, awake, step.threads);
    if (choices_.detection.permitted > 0.0) seams_.put_right(scene_of(step, motions), touches);
    touches_ = touches;
    if (continuous_collision_) {
        continuous_collision_->begin(touches_);
        after_solved_.resize(bodies.size());
        paths_solved_.resize(bodies.size());
        for (const int body : awake.moved_bodies) {
            after_solved_[at(body)] = after_[at(body)];
            paths_solved_[at(body)] = paths_[at(body)];
        }
    }
    moved_bodies_.clear();
    moved_colliders_.clear();
    forces_.clear();
    own_rows_ = 0;
    if (cache_) cache_->recall(touches_, forces_);
    append_touches(touches_, order_, step, paths_, rows);
}

void ContactConstraints::append_unforeseen(const StepStart& step, std::span<const Vector6> forces,
                                           std::span<const char> changed, RowList& rows) {
    if (!continuous_collision_) return;
    const std::span<const int> awake = awake_bodies_.members();
    share_each(step.threads, awake, bodies_of_a_part, [&](int index) {
        const auto i = static_cast<std::size_t>(index);
        if (!changed[i]) return;
        after_solved_[i] = motion_of(step.bodies[i], step.dt, forces[i]);
        paths_solved_[i] = motion_in_step(step.bodies[i], step.dt, step.rotate, forces[i]);
    });
    for (const Strayed& own : step.strayed) {
        const Vector6& force = forces[at(own.body)];
        const Body& body = step.bodies[at(own.body)];
        Motion& motion = after_solved_[at(own.body)];
        motion.velocity = own.way.velocity + step.dt * body.inverse_mass * force.head<3>();
        motion.angular_velocity =
            own.way.angular_velocity + step.dt * (world_inverse_inertia(body) * force.tail<3>());
        paths_solved_[at(own.body)] = motion;
    }
    const StepMotions motions{step.dt, before_, after_solved_, paths_solved_, strayed_};
    const auto found =
        continuous_collision_->look(scene_of(step, motions), forces, changed, awake_colliders_.members(),
                                    detector_.broad_phase(), step.threads);
    if (found.empty()) return;
    // No warm start: the solution that takes the bodies there was found without these rows.
    const std::size_t before = contacts_.size(), first = unforeseen_.size();
    append_touches(found, unforeseen_order_, step, paths_solved_, rows);
    // The touches of look() are valid only until its next call, so copy them.
    unforeseen_.insert(unforeseen_.end(), found.begin(), found.end());
    for (Contact& contact : std::span(contacts_).subspan(before)) {
        contact.touch = &unforeseen_[first + static_cast<std::size_t>(contact.touch - found.data())];
    }
}

collision::Touch ContactConstraints::touch_of(const collision::Pair& pair, std::span<const Body> bodies) const {
    collision::Touch touch;
    collision::name_touch(pair, {colliders_, bodies, detector_.poses(), choices_.detection}, touch);
    return touch;
}

std::vector<ContactSite> ContactConstraints::sites() const {
    std::vector<ContactSite> sites;
    for (const Contact& contact : contacts_) {
        const collision::Touch& touch = *contact.touch;
        ContactSite site{.body_a = touch.body_a,
                         .body_b = touch.body_b,
                         .position = touch.points[static_cast<std::size_t>(contact.point)].position,
                         .normal = touch.normal,
                         .normal_row = static_cast<std::size_t>(contact.normal_row),
                         .swept = touch.time > 0.0};
        if (contact.friction_row >= 0) {
            site.friction_row = static_cast<std::size_t>(contact.friction_row);
            site.tangents = contact.tangents;
        }
        sites.push_back(site);
    }
    return sites;
}

void ContactConstraints::remember(std::span<const Lambda> answers) {
    if (!cache_) return;
    const auto take = [&](const Contact& contact) {
        ContactForce& force = forces_[contact.force];
        const auto answer = [&](int row) { return answers[static_cast<std::size_t>(row - contact.foreign_rows)]; };
        force.normal = answer(contact.normal_row);
        if (contact.friction_row < 0) return;
        const Lambda along = answer(contact.friction_row);
        const Lambda across = answer(contact.friction_row + 1);
        force.friction_first = contact.tangents[0] * along.first + contact.tangents[1] * across.first;
        force.friction_last = contact.tangents[0] * along.last + contact.tangents[1] * across.last;
    };
    share_each(threads_, std::span(contacts_), contacts_of_a_part, take);
    store_forces();
}

// The cache needs ascending order of the pair. Of a pair that was found again the points of the start of the step
// stay.
void ContactConstraints::store_forces() {
    cache_->clear();
    std::size_t force = 0;
    const auto forces_of = [&](const collision::Touch& touch) {
        force += touch.points.size();
        return std::span<const ContactForce>(forces_).subspan(force - touch.points.size(), touch.points.size());
    };
    if (unforeseen_.empty()) {
        for (const collision::Touch& touch : touches_) cache_->store(touch, forces_of(touch));
        return;
    }
    std::map<collision::Pair, std::pair<const collision::Touch*, std::span<const ContactForce>>> known;
    const auto add = [&](const collision::Touch& touch) {
        known.try_emplace(touch.pair, &touch, forces_of(touch));
    };
    std::for_each(touches_.begin(), touches_.end(), add);
    std::for_each(unforeseen_.begin(), unforeseen_.end(), add);
    for (const auto& [pair, own] : known) cache_->store(*own.first, own.second);
}

}  // namespace pushfactor::engine
