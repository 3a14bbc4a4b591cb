#include "engine/collision/seams.h"

#include "engine/collision/meeting.h"
#include "engine/collision/pairs/collide.h"

#include <algorithm>
#include <optional>

namespace pushfactor::engine::collision {

namespace {

constexpr double same_normal = 1.0 - 1e-9;  // cosine above which two normals differ by rounding alone
constexpr double noise = 1e-6;              // of the permitted overlap: motion per step of a body at rest

// Speed at which the shapes of a touch approach each other along `normal` (from a to b) at `point`, m/s. What turns
// in itself does not come closer by turning.
double closing(const Touch& touch, std::span<const Motion> motions, const Vector3& point, const Vector3& normal,
               const StepScene& step) {
    const auto motion_of = [&](int collider, int body) {
        Motion motion = motions[static_cast<std::size_t>(body)];
        const Shape& shape = step.colliders[static_cast<std::size_t>(collider)].shape;
        if (turns_in_itself(shape)) motion.angular_velocity.setZero();
        return motion;
    };
    return closing_speed(motion_of(touch.pair.a, touch.body_a), step.centre(touch.body_a, touch.time),
                         motion_of(touch.pair.b, touch.body_b), step.centre(touch.body_b, touch.time), point,
                         normal);
}

double gap_along(const Touch& touch, const Vector3& normal, const StepScene& step) {
    return gap_along(step.moving(touch.pair.a), step.moving(touch.pair.b), normal);
}

// The direction `out` of `body` as one from a to b of a touch of that body.
Vector3 seen_from(const Touch& touch, int body, const Vector3& out) {
    return touch.body_a == body ? out : Vector3(-out);
}

// Whether anything that the bodies do closes the touch in this step: at rest no contact changes.
bool closes(const Touch& touch, const StepScene& step) {
    const double least = noise * step.detection.permitted * touch.size;
    return std::any_of(touch.points.begin(), touch.points.end(), [&](const ContactPoint& point) {
        const double speed = std::max(closing(touch, step.motions->before, point.position, touch.normal, step),
                                      closing(touch, step.motions->after, point.position, touch.normal, step));
        return step.motions->dt * speed > std::max(point.gap, least);
    });
}

// Whether `holder` keeps `body` from coming closer along `out`, its normal away from the body, to the other body of
// `touch` than is permitted.
bool holds(const Touch& holder, int body, const Vector3& out, const Touch& touch, const StepScene& step) {
    const Vector3 along = seen_from(touch, body, out);
    if (along.dot(touch.normal) > same_normal) return false;
    const double permitted = step.detection.permitted * touch.size, dt = step.motions->dt;
    const double gap = gap_along(touch, along, step);
    if (gap < -permitted) return false;
    // Two in doubt that touch now may hold each other apart: then neither does.
    if (touch.time == 0.0 && holder.doubtful &&
        gap_along(holder, seen_from(holder, body, seen_from(touch, body, touch.normal)), step) >= -permitted) {
        return false;
    }
    const Vector3& where = touch.points.front().position;
    const auto distance = [&](const ContactPoint& own) { return (own.position - where).squaredNorm(); };
    const ContactPoint& point = *std::ranges::min_element(holder.points, {}, distance);
    const double free = std::max(point.gap, 0.0);
    const int other = holder.body_a == body ? holder.body_b : holder.body_a;
    const bool gives_way = !step.bodies[static_cast<std::size_t>(other)].is_static();
    if (gives_way &&
        dt * closing(holder, step.motions->before, point.position, holder.normal, step) > free + permitted) {
        return false;
    }
    const double stopped =
        std::max(0.0, dt * closing(holder, step.motions->after, point.position, holder.normal, step) - free);
    return dt * closing(touch, step.motions->after, where, along, step) - stopped <= gap + permitted;
}

bool has_plane(const Touch& touch, const StepScene& step) {
    const auto is_plane = [&](int collider) {
        return !is_finite(step.colliders[static_cast<std::size_t>(collider)].shape);
    };
    return is_plane(touch.pair.a) || is_plane(touch.pair.b);
}

}  // namespace

void Seams::list(std::span<const Touch> touches, std::size_t bodies) {
    first_.assign(bodies, -1);
    next_.resize(2 * touches.size());
    for (std::size_t i = 0; i < touches.size(); ++i) {
        for (const std::size_t place : {2 * i, 2 * i + 1}) {
            const auto body = static_cast<std::size_t>(place == 2 * i ? touches[i].body_a : touches[i].body_b);
            next_[place] = first_[body];
            first_[body] = static_cast<int>(place);
        }
    }
}

// The normal of what holds the pair, from a to b, if anything does.
std::optional<Vector3> Seams::held_along(const Touch& touch, std::span<const Touch> holders,
                                         const StepScene& step) const {
    for (const int body : {touch.body_a, touch.body_b}) {
        if (step.bodies[static_cast<std::size_t>(body)].is_static()) continue;
        for (int place = first_[static_cast<std::size_t>(body)]; place >= 0;
             place = next_[static_cast<std::size_t>(place)]) {
            const Touch& holder = holders[static_cast<std::size_t>(place / 2)];
            if (&holder == &touch || holder.points.empty()) continue;
            if (holder.time > 0.0 && holder.time >= touch.time) continue;
            const Vector3 out = seen_from(holder, body, holder.normal);
            if (holds(holder, body, out, touch, step)) return seen_from(touch, body, out);
        }
    }
    return std::nullopt;
}

void Seams::put_right(const StepScene& step, std::span<const Touch> holders, std::vector<Touch>& touches) {
    found_.clear();
    in_doubt_.clear();
    for (std::size_t i = 0; i < touches.size(); ++i) {
        const Touch& touch = touches[i];
        if ((touch.doubtful || touch.time > 0.0) && !touch.ends_deep && !has_plane(touch, step) &&
            closes(touch, step)) {
            in_doubt_.push_back(i);
        }
    }
    if (in_doubt_.empty()) return;
    list(holders, step.bodies.size());
    // In order of time: what does not meet as found holds nothing.
    std::sort(in_doubt_.begin(), in_doubt_.end(), [&](std::size_t i, std::size_t j) {
        return std::pair(touches[i].time, i) < std::pair(touches[j].time, j);
    });
    for (const std::size_t i : in_doubt_) {
        Touch& touch = touches[i];
        const std::optional<Vector3> normal = held_along(touch, holders, step);
        if (!normal) continue;
        const Moving a = step.moving(touch.pair.a), b = step.moving(touch.pair.b);
        collide_along(*normal, a.shape, a.start, b.shape, b.start, step.detection.margin * touch.size, manifold_);
        found_.emplace_back(i, step.kept->keep(manifold_.points()));
        touch.normal = *normal;
        touch.time = 0.0;
        touch.points = {};
    }
    for (const auto& [touch, points] : found_) touches[touch].points = points;
    if (!found_.empty()) std::erase_if(touches, [](const Touch& touch) { return touch.points.empty(); });
}

}  // namespace pushfactor::engine::collision
