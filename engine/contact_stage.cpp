#include "engine/contact_stage.h"

#include <cmath>

namespace pushfactor::engine {

namespace {

// Sliding that would move a point by less than this share of the size in one step has no direction.
constexpr double sliding_share = 1e-4;

BodyPair bodies_of(const collision::Touch& touch, std::span<const Body> bodies) {
    if (touch.meeting) return {touch.body_a, touch.body_b, touch.meeting->a, touch.meeting->b};
    return {touch.body_a, touch.body_b, bodies[static_cast<std::size_t>(touch.body_a)],
            bodies[static_cast<std::size_t>(touch.body_b)]};
}

// Whether an impulse along `axis` (a body's half of j_c) turns a body with unequal moments of inertia.
bool turns(const Body& body, const Vector6& axis, double size) {
    const Vector3& moments = body.inverse_inertia;
    return axis.tail<3>().norm() > 1e-9 * size && moments.maxCoeff() > (1.0 + 1e-9) * moments.minCoeff();
}

// What 8.2 needs to know of a contact row before the step.
Impact impact_of(const ConstraintRow& row, const BodyPair& pair, const collision::Touch& touch, double dt) {
    const auto velocity_of = [](const Body& body) { return stacked(velocity(body), angular_velocity(body)); };
    const auto acceleration_of = [](const Body& body) {
        return stacked(body.inverse_mass * body.force, world_inverse_inertia(body) * body.torque);
    };
    const Jacobian& j = row.jacobian;
    const double acceleration_a = j.a.dot(acceleration_of(pair.body_a));
    const double acceleration_b = j.b.dot(acceleration_of(pair.body_b));
    return {.speed = j.a.dot(velocity_of(pair.body_a)) + j.b.dot(velocity_of(pair.body_b)),
            .acceleration = acceleration_a + acceleration_b,
            .weight = std::max(std::abs(acceleration_a), std::abs(acceleration_b)),
            .gap = row.label.gap,
            .restitution = touch.restitution,
            .dt = dt,
            .turns = turns(pair.body_a, j.a, touch.size) || turns(pair.body_b, j.b, touch.size)};
}

}  // namespace

// Each surface velocity is across the normal as far as friction is concerned.
Vector3 ContactStage::belt_of(const collision::Touch& touch, const BodyPair& pair) const {
    const auto run = [this](int collider, const Body& body) -> Vector3 {
        const Vector3& velocity = colliders_[static_cast<std::size_t>(collider)].surface_velocity;
        return velocity.isZero(0.0) ? Vector3::Zero() : body.orientation * velocity;
    };
    return run(touch.pair.a, pair.body_a) - run(touch.pair.b, pair.body_b);
}

const collision::Touch& ContactStage::touch_of(std::size_t index) const {
    return touches_[static_cast<std::size_t>(order_[index].touch)];
}

const collision::ContactPoint& ContactStage::point_of(std::size_t index) const {
    return touch_of(index).points[static_cast<std::size_t>(order_[index].point)];
}

// What the contact points of one touch have in common as far as friction is concerned.
struct ContactStage::TouchFriction {
    FrictionBound bound;
    Vector3 belt;           // m/s
    RelativeMotion motion;  // at the start of the step
    double least_sliding;   // m/s
    Vector3 resting;        // the tangent of points that slide less
};

ContactStage::TouchFriction ContactStage::friction_of(const collision::Touch& touch, const BodyPair& pair,
                                                      double dt) const {
    const Vector3 belt = belt_of(touch, pair);
    const Vector3& normal = touch.normal;
    const auto a = static_cast<std::size_t>(pair.a), b = static_cast<std::size_t>(pair.b);
    return {.bound = friction_->bound({.bodies = pair,
                                       .normal = normal,
                                       .friction = touch.friction,
                                       .points = static_cast<int>(touch.points.size())}),
            .belt = belt,
            .motion = RelativeMotion(pair, motions_[a], motions_[b], belt),
            .least_sliding = sliding_share * touch.size / dt,
            .resting = collision::tangent_fixed_in(detector_.poses()[a].rotation, normal)};
}

void ContactStage::append_normal(std::size_t index, const BodyPair& pair, const PairPoint& at, double dt,
                                 std::vector<ConstraintRow>& rows) {
    const collision::Touch& touch = touch_of(index);
    contacts_[index].normal_row = static_cast<int>(rows.size() - first_row_);
    ConstraintRow& row = append_contact_row(at, touch.normal, point_of(index).gap, choices_.correction,
                                            choices_.slop * touch.size, dt, rows);
    if (restitution_ && touch.restitution > 0.0) {
        row.push = restitution_(row.push, impact_of(row, pair, touch, dt));
    }
    row.label.point = order_[index].point;
    row.guess = forces_[contacts_[index].force].normal;
}

void ContactStage::append_friction(std::size_t index, const PairPoint& at, const TouchFriction& shared,
                                   std::vector<ConstraintRow>& rows) {
    const collision::Touch& touch = touch_of(index);
    const collision::ContactPoint& point = point_of(index);
    const Vector3& normal = touch.normal;
    Contact& contact = contacts_[index];

    const Bounds bounds = shared.bound.at(static_cast<int>(first_row_) + contact.normal_row);
    contact.tangents = friction_tangents(normal, shared.motion.sliding(point.position, normal),
                                         shared.least_sliding, shared.resting);
    contact.friction_row = static_cast<int>(rows.size() - first_row_);
    for (const Vector3& tangent : contact.tangents) {
        ConstraintRow& row = append_friction_row(at, tangent, bounds, tangent.dot(shared.belt), rows);
        const ContactForce& force = forces_[contact.force];
        row.label.point = order_[index].point;
        row.label.gap = point.gap;
        row.guess = {tangent.dot(force.friction_first), tangent.dot(force.friction_last)};
    }
}

// Detects, orders, and recalls what the cache knows.
void ContactStage::find_contacts(std::span<const Body> bodies, double dt) {
    touches_ = detector_.detect(colliders_, bodies, choices_.detection);
    if (sweep_) touches_ = sweep_->refine(touches_, {colliders_, bodies, dt, choices_.detection});
    order_ = ordering_.put(choices_.order, touches_, bodies);

    first_force_.clear();
    std::size_t points = 0;
    for (const collision::Touch& touch : touches_) {
        first_force_.push_back(points);
        points += touch.points.size();
    }
    if (cache_) {
        cache_->recall(touches_, forces_);
    } else {
        forces_.assign(points, {});
    }

    contacts_.resize(order_.size());
    runs_.clear();
    for (std::size_t i = 0; i < order_.size(); ++i) {
        contacts_[i].force =
            first_force_[static_cast<std::size_t>(order_[i].touch)] + static_cast<std::size_t>(order_[i].point);
        contacts_[i].friction_row = -1;
        if (i == 0 || order_[i].touch != order_[i - 1].touch) runs_.push_back({i, i});
        runs_.back().end = i + 1;
    }
}

// As motion_of() has them, with the rotations that the detector has made.
void ContactStage::find_motions(std::span<const Body> bodies) {
    motions_.resize(bodies.size());
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const Body& body = bodies[i];
        if (body.is_static()) continue;
        const Matrix3& rotation = detector_.poses()[i].rotation;
        const Vector3 in_body = rotation.transpose() * body.angular_momentum;
        motions_[i] = {velocity(body), rotation * body.inverse_inertia.cwiseProduct(in_body)};
    }
}

void ContactStage::append_rows(std::span<const Body> bodies, double dt, std::vector<ConstraintRow>& rows) {
    find_contacts(bodies, dt);
    if (friction_) find_motions(bodies);
    first_row_ = rows.size();
    const bool interleaved = choices_.order != RowOrder::normals_first;
    const auto append = [&](const Run& run, bool normals, bool tangents) {
        const collision::Touch& touch = touch_of(run.begin);
        const BodyPair pair = bodies_of(touch, bodies);
        std::optional<TouchFriction> shared;
        if (tangents) shared = friction_of(touch, pair, dt);
        for (std::size_t i = run.begin; i < run.end; ++i) {
            const PairPoint at(pair, point_of(i).position);
            if (normals) append_normal(i, pair, at, dt, rows);
            if (tangents) append_friction(i, at, *shared, rows);
        }
    };
    for (const Run& run : runs_) append(run, true, friction_ && interleaved);
    if (!friction_ || interleaved) return;
    for (const Run& run : runs_) append(run, false, true);
}

std::vector<ContactSite> ContactStage::sites() const {
    std::vector<ContactSite> sites;
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        const Contact& contact = contacts_[i];
        ContactSite site{.body_a = touch_of(i).body_a,
                         .body_b = touch_of(i).body_b,
                         .position = point_of(i).position,
                         .normal = touch_of(i).normal,
                         .normal_row = first_row_ + static_cast<std::size_t>(contact.normal_row),
                         .swept = touch_of(i).meeting != nullptr};
        if (contact.friction_row >= 0) {
            site.friction_row = first_row_ + static_cast<std::size_t>(contact.friction_row);
            site.tangents = contact.tangents;
        }
        sites.push_back(site);
    }
    return sites;
}

bool ContactStage::foresaw(std::span<const Body> bodies, std::span<const Vector6> forces, double dt) {
    return !sweep_ || sweep_->foresaw(forces, {colliders_, bodies, dt, choices_.detection});
}

void ContactStage::remember(std::span<const Lambda> answers) {
    if (sweep_) sweep_->forget();
    if (!cache_) return;
    for (const Contact& contact : contacts_) {
        ContactForce& force = forces_[contact.force];
        force.normal = answers[static_cast<std::size_t>(contact.normal_row)];
        if (contact.friction_row < 0) continue;
        const Lambda& along = answers[static_cast<std::size_t>(contact.friction_row)];
        const Lambda& across = answers[static_cast<std::size_t>(contact.friction_row) + 1];
        force.friction_first = contact.tangents[0] * along.first + contact.tangents[1] * across.first;
        force.friction_last = contact.tangents[0] * along.last + contact.tangents[1] * across.last;
    }
    cache_->store(touches_, forces_);
}

}  // namespace pushfactor::engine
