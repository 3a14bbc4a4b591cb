#include "engine/constraints/contact_constraints.h"

#include "engine/constraints/carried.h"

#include <algorithm>
#include <cmath>

namespace pushfactor::engine {

namespace {

// Contacts per thread task.
constexpr std::size_t contacts_of_a_part = 128;

// Share of the size above which a gap is real, not an error that the solver has left.
constexpr double apart_share = 1e-5;

// Overlap along an axis up to which bodies count as separated along it, as a fraction of the size: the allowed
// penetration plus some room. With zero slop, bodies touch the surface only up to the solver's error; the
// margin then gives the scale.
double permitted_overlap(double slop, double margin) {
    return std::min(0.02, std::max(1.1 * slop, 0.2 * margin));
}

BodyPair bodies_of(const collision::Touch& touch, std::span<const Body> bodies) {
    if (touch.meeting) return {touch.body_a, touch.body_b, touch.meeting->a, touch.meeting->b};
    return {touch.body_a, touch.body_b, bodies[static_cast<std::size_t>(touch.body_a)],
            bodies[static_cast<std::size_t>(touch.body_b)]};
}

// Whether an impulse along `axis` (the body's half of j_c) turns a body with unequal moments of inertia.
bool turns(const Body& body, const Vector6& axis, double size) {
    const Vector3& moments = body.inverse_inertia;
    return axis.tail<3>().norm() > 1e-9 * size && moments.maxCoeff() > (1.0 + 1e-9) * moments.minCoeff();
}

// State of a contact row before the step, for 8.2.
Impact impact_of(const ConstraintRow& row, const BodyPair& pair, const collision::Touch& touch, double slop,
                 double dt) {
    const auto velocity_of = [](const Body& body) { return stacked(velocity(body), angular_velocity(body)); };
    const auto acceleration_of = [](const Body& body) {
        return stacked(body.inverse_mass * body.force, world_inverse_inertia(body) * body.torque);
    };
    const Jacobian& j = row.jacobian;
    const double acceleration_a = j.a.dot(acceleration_of(pair.body_a));
    const double acceleration_b = j.b.dot(acceleration_of(pair.body_b));
    return {.speed = j.a.dot(velocity_of(pair.body_a)) + j.b.dot(velocity_of(pair.body_b)) -
                     carried_speed(row, pair.body_a, pair.body_b, dt),
            .acceleration = acceleration_a + acceleration_b,
            .weight = std::max(std::abs(acceleration_a), std::abs(acceleration_b)),
            .gap = row.label.gap,
            .touching = touching_gap(slop),
            .restitution = touch.restitution,
            .dt = dt,
            .turns = turns(pair.body_a, j.a, touch.size) || turns(pair.body_b, j.b, touch.size)};
}

}  // namespace

ContactConstraints::ContactConstraints(std::vector<collision::Collider> colliders, const ContactChoices& choices)
    : colliders_(std::move(colliders)), choices_(choices) {
    choices_.detection.permitted = permitted_overlap(choices.slop, choices.detection.margin);
    any_bounces_ = std::any_of(colliders_.begin(), colliders_.end(),
                               [](const collision::Collider& collider) { return collider.restitution > 0.0; });
}

void ContactConstraints::set_filter(std::unique_ptr<const collision::PairFilter> filter) {
    filter_ = std::move(filter);
    detector_.broad_phase().leave_out(filter_.get());
}

void ContactConstraints::set_materials(std::unique_ptr<const collision::MaterialPairs> materials) {
    materials_ = std::move(materials);
    choices_.detection.materials = materials_.get();
    any_bounces_ = any_bounces_ || (materials_ && materials_->any_bounces());
}

// Default until leave_out_others() is called.
void ContactConstraints::wake_all(std::size_t bodies) {
    all_bodies_ = awake_bodies_ = Awake(bodies);
    all_colliders_ = awake_colliders_ = Awake(colliders_.size());
    awake_anew_ = true;
}

void ContactConstraints::leave_out_others(std::span<const Body> bodies, const Awake& awake) {
    wake_all(bodies.size());
    awake_bodies_ = awake;
    std::vector<char> is_awake;
    for (const collision::Collider& collider : colliders_) is_awake.push_back(awake.has(collider.body));
    awake_colliders_ = Awake(std::move(is_awake));
    if (!cache_) return;
    const auto moves = [&](const collision::Pair& pair) {
        const auto body_of = [&](int collider) { return colliders_[static_cast<std::size_t>(collider)].body; };
        return is_any_moving(bodies, awake, body_of(pair.a), body_of(pair.b));
    };
    cache_->take_from(at_rest_, moves);
    at_rest_.take_from(*cache_, [&](const collision::Pair& pair) { return !moves(pair); });
}

bool ContactConstraints::turns_unseen(int body) const {
    return std::none_of(colliders_.begin(), colliders_.end(), [body](const collision::Collider& collider) {
        return collider.body == body && !collision::turns_in_itself(collider.shape);
    });
}

// Resting bodies on a belt that starts to run.
SomeBodies ContactConstraints::changed_anew(double from, double until) const {
    SomeBodies changed;
    const auto begins = [&](int collider) {
        const collision::Collider& own = colliders_[static_cast<std::size_t>(collider)];
        return collision::runs_at(own, from) != collision::runs_at(own, until);
    };
    if (std::none_of(colliders_.begin(), colliders_.end(),
                     [](const auto& own) { return own.surface_from > 0.0; })) {
        return changed;
    }
    if (!cache_) {  // without a cache the bodies on the belt are unknown
        for (int i = 0; i < static_cast<int>(colliders_.size()) && !changed.all; ++i) changed.all = begins(i);
        return changed;
    }
    for (const ContactCache::Entry& entry : at_rest_.entries()) {
        if (!begins(entry.pair.a) && !begins(entry.pair.b)) continue;
        for (const int collider : {entry.pair.a, entry.pair.b}) {
            changed.some.push_back(colliders_[static_cast<std::size_t>(collider)].body);
        }
    }
    return changed;
}

// Those within the margin of its way. A plane that turns may meet all.
SomeBodies ContactConstraints::met_by_moved(const StepStart& step) const {
    SomeBodies met;
    const bool is_known = awake_bodies_.of() == step.bodies.size();  // not before the first step
    for (const collision::Collider& own : colliders_) {
        const Body& moved = step.bodies[static_cast<std::size_t>(own.body)];
        if (!moved.is_moved()) continue;
        const collision::Way way(own, moved, step.dt);
        for (const collision::Collider& other : colliders_) {
            if ((is_known && awake_bodies_.has(other.body)) || !is_finite(other.shape)) continue;
            const Body& resting = step.bodies[static_cast<std::size_t>(other.body)];
            const double margin = choices_.detection.margin * size_of(other.shape);
            if (way.meets(other.shape, resting, margin)) met.some.push_back(other.body);
        }
    }
    return met;
}

void ContactConstraints::all_forces(ContactCache& into) const {
    into = cache_ ? *cache_ : ContactCache{};
    if (at_rest_.entries().empty()) return;
    ContactCache at_rest = at_rest_;
    into.take_from(at_rest, [](const collision::Pair&) { return true; });
}

// Relative surface velocity of the belts [m/s]. Its normal component does not affect friction.
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
                                                                  const BodyPair& pair,
                                                                  const StepStart& step) const {
    const Vector3 belt = belt_of(touch, pair, step.time);
    const Vector3& normal = touch.normal;
    const auto a = static_cast<std::size_t>(pair.a), b = static_cast<std::size_t>(pair.b);
    const FrictionBound bound = friction_->bound({.bodies = pair,
                                                  .normal = normal,
                                                  .friction = touch.friction,
                                                  .points = static_cast<int>(touch.points.size()),
                                                  .size = touch.size,
                                                  .acceleration = std::max(accelerations_[a], accelerations_[b]),
                                                  .dt = step.dt});
    return {.bound = bound,
            .apart = bound.of_normal_force ? bound : FrictionBound{},
            .belt = belt,
            .motion = RelativeMotion(pair, motions_[a], motions_[b], belt),
            .resting = collision::tangent_fixed_in(detector_.poses()[a].rotation, normal)};
}

void ContactConstraints::write_normal(const Contact& contact, const BodyPair& pair, const PairPoint& at, double dt,
                                      ConstraintRow& row) const {
    const collision::Touch& touch = *contact.touch;
    const collision::ContactPoint& point = touch.points[static_cast<std::size_t>(contact.point)];
    std::construct_at(&row);
    const double slop = choices_.slop * touch.size;
    write_contact_row(at, touch.normal, point.gap, choices_.correction, slop, dt, row);
    if (restitution_ && touch.restitution > 0.0) {
        const Rebound rebound = restitution_(row.push, impact_of(row, pair, touch, slop, dt));
        row.push = rebound.push;
        if (row.push.lasting < 0.0) row.error = point.gap;  // it does not aim at rest
        row.bounds.in_momenta = rebound.in_momenta;
    }
    row.label.point = contact.point;
    row.guess = forces_[contact.force].normal;
}

void ContactConstraints::write_friction(Contact& contact, const PairPoint& at, const TouchFriction& shared,
                                        std::span<ConstraintRow> rows) const {
    const Vector3& normal = contact.touch->normal;
    const collision::ContactPoint& point = contact.touch->points[static_cast<std::size_t>(contact.point)];

    const bool apart = point.gap > apart_share * contact.touch->size;
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

// Appends the contacts of the touches in the given order.
std::span<ContactConstraints::Contact> ContactConstraints::add_contacts(std::span<const collision::Touch> touches,
                                                                        std::span<const ContactIndex> order,
                                                                        Threads* threads) {
    std::size_t force = contacts_.empty() ? 0 : forces_.size();
    first_force_.clear();
    for (const collision::Touch& touch : touches) {
        first_force_.push_back(force);
        force += touch.points.size();
    }
    forces_.resize(force);  // zero if not cached

    const std::size_t before = contacts_.size();
    contacts_.resize(before + order.size());
    const std::span<Contact> added = std::span(contacts_).subspan(before);
    share(threads, order.size(), contacts_of_a_part, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const auto touch = static_cast<std::size_t>(order[i].touch);
            added[i].touch = &touches[touch];
            added[i].point = order[i].point;
            added[i].force = first_force_[touch] + static_cast<std::size_t>(order[i].point);
        }
    });
    return added;
}

// Per contact one normal row, then two friction rows; or all friction rows after all normal rows.
void ContactConstraints::number_rows(std::span<Contact> contacts, std::size_t first_row) {
    const int foreign_rows = static_cast<int>(first_row) - own_rows_;
    const bool interleaved = choices_.order != RowOrder::normals_first;
    const int normals = friction_ && interleaved ? 3 : 1;
    int normal = static_cast<int>(first_row);
    int friction = interleaved ? normal + 1 : normal + static_cast<int>(contacts.size());
    for (Contact& contact : contacts) {
        contact.foreign_rows = foreign_rows;
        contact.normal_row = normal;
        contact.friction_row = friction_ ? friction : -1;
        normal += normals;
        friction += interleaved ? 3 : 2;
    }
    own_rows_ += static_cast<int>(contacts.size()) * (friction_ ? 3 : 1);
}

// Like motion_of(), but with the rotations that the detector has computed.
void ContactConstraints::find_motions(const StepStart& step) {
    motions_.resize(step.bodies.size());
    accelerations_.resize(step.bodies.size(), 0.0);
    const std::span<const int> awake = awake_bodies_.members();
    share(step.threads, awake.size(), contacts_of_a_part, [&](std::size_t begin, std::size_t end) {
        for (const int index : awake.subspan(begin, end - begin)) {
            const auto i = static_cast<std::size_t>(index);
            const Body& body = step.bodies[i];
            if (body.is_static()) {
                motions_[i] = body.prescribed;
                continue;
            }
            const Matrix3& rotation = detector_.poses()[i].rotation;
            const Vector3 in_body = rotation.transpose() * body.angular_momentum;
            accelerations_[i] = body.inverse_mass * body.force.norm();
            motions_[i] = {velocity(body), rotation * body.inverse_inertia.cwiseProduct(in_body)};
        }
    });
}

void ContactConstraints::append_touches(std::span<const collision::Touch> touches, ContactOrder& order,
                                        const StepStart& step, RowList& rows) {
    const std::span<const ContactIndex> in_order =
        order.put(choices_.order, touches, step.bodies, step.up, step.threads);
    const std::span<Contact> contacts = add_contacts(touches, in_order, step.threads);
    number_rows(contacts, rows.size());
    const std::span<ConstraintRow> all = rows.append(contacts.size() * (friction_ ? 3 : 1));
    share(step.threads, contacts.size(), contacts_of_a_part,
          [&](std::size_t begin, std::size_t end) { write_rows(contacts, begin, end, step, all); });
}

// Writes the rows of contacts `begin` .. `end` - 1.
void ContactConstraints::write_rows(std::span<Contact> contacts, std::size_t begin, std::size_t end,
                                    const StepStart& step, std::span<ConstraintRow> rows) const {
    for (std::size_t i = begin; i < end;) {
        const collision::Touch& touch = *contacts[i].touch;
        const BodyPair pair = bodies_of(touch, step.bodies);
        std::optional<TouchFriction> shared;
        if (friction_) shared = friction_of(touch, pair, step);
        for (; i < end && contacts[i].touch == &touch; ++i) {
            Contact& contact = contacts[i];
            const PairPoint at(pair, touch.points[static_cast<std::size_t>(contact.point)].position);
            write_normal(contact, pair, at, step.dt, rows[static_cast<std::size_t>(contact.normal_row)]);
            if (friction_) write_friction(contact, at, *shared, rows);
        }
    }
}

collision::ContinuousCollision::Step ContactConstraints::collision_step(const StepStart& step) const {
    return {colliders_, step.bodies, step.dt, choices_.detection, awake_colliders_.members(), any_bounces_};
}

void ContactConstraints::append_rows(const StepStart& step, RowList& rows) {
    const std::span<const Body> bodies = step.bodies;
    threads_ = step.threads;
    // First drop references to the touches of the last step, whose points and meetings the search invalidates.
    contacts_.clear();
    unforeseen_.clear();
    touches_ = {};
    if (awake_bodies_.of() != bodies.size()) wake_all(bodies.size());
    const collision::AwakeColliders awake{
        awake_colliders_,
        (awake_anew_ ? all_colliders_ : awake_colliders_).members(),
        (awake_anew_ ? all_bodies_ : awake_bodies_).members(),
    };
    awake_anew_ = false;
    if (continuous_collision_)
        foresight_.look_ahead(colliders_, bodies, step.dt, awake.moved_colliders, step.threads);
    std::vector<collision::Touch>& touches = detector_.detect(
        colliders_, bodies, choices_.detection, continuous_collision_ ? &foresight_ : nullptr, awake, step.threads);
    if (choices_.detection.permitted > 0.0) passing_.put_right(touches, collision_step(step));
    touches_ = touches;
    if (continuous_collision_) touches_ = continuous_collision_->refine(touches_, collision_step(step), detector_);
    if (friction_) find_motions(step);
    forces_.clear();
    own_rows_ = 0;
    if (cache_) cache_->recall(touches_, forces_, step.threads);
    append_touches(touches_, order_, step, rows);
}

void ContactConstraints::append_unforeseen(const StepStart& step, std::span<const Vector6> forces,
                                           std::span<const NewForce> changed, RowList& rows) {
    if (!continuous_collision_) return;
    const auto found = continuous_collision_->look(forces, changed, collision_step(step), detector_);
    if (found.empty()) return;
    // No warm start: the solution that takes the bodies there was found without these rows.
    const std::size_t before = contacts_.size(), first = unforeseen_.size();
    append_touches(found, unforeseen_order_, step, rows);
    // The touches of look() are valid only until its next call, so copy them.
    unforeseen_.insert(unforeseen_.end(), found.begin(), found.end());
    for (Contact& contact : std::span(contacts_).subspan(before)) {
        contact.touch = &unforeseen_[first + static_cast<std::size_t>(contact.touch - found.data())];
    }
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
                         .swept = touch.meeting != nullptr};
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
    share(threads_, contacts_.size(), contacts_of_a_part, [&](std::size_t begin, std::size_t end) {
        for (const Contact& contact : std::span(contacts_).subspan(begin, end - begin)) take(contact);
    });
    store_forces();
}

// The cache needs ascending order of the pair.
void ContactConstraints::store_forces() {
    if (unforeseen_.empty()) {
        cache_->store(touches_, forces_, threads_);
        return;
    }
    struct Known {
        const collision::Touch* touch;
        std::size_t force;  // into forces_
    };
    std::size_t force = 0;
    for (const collision::Touch& touch : touches_) force += touch.points.size();
    std::vector<Known> unforeseen;
    for (const collision::Touch& touch : unforeseen_) {
        unforeseen.push_back({&touch, force});
        force += touch.points.size();
    }
    std::sort(unforeseen.begin(), unforeseen.end(),
              [](const Known& a, const Known& b) { return a.touch->pair < b.touch->pair; });

    const std::span<const ContactForce> forces(forces_);
    const auto store = [&](const Known& known) {
        cache_->store(*known.touch, forces.subspan(known.force, known.touch->points.size()));
    };
    cache_->clear();
    force = 0;
    auto next = unforeseen.begin();
    for (const collision::Touch& touch : touches_) {
        for (; next != unforeseen.end() && next->touch->pair < touch.pair; ++next) store(*next);
        store({&touch, force});
        // For a pair found twice, keep the points of the start of the step.
        if (next != unforeseen.end() && next->touch->pair == touch.pair) ++next;
        force += touch.points.size();
    }
    for (; next != unforeseen.end(); ++next) store(*next);
}

}  // namespace pushfactor::engine
