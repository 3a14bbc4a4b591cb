#include "engine/collision/passing.h"

#include "engine/base/overloaded.h"
#include "engine/collision/pairs/axis_choice.h"
#include "engine/collision/pairs/box_box.h"
#include "engine/collision/pairs/polyhedron_pairs.h"
#include "engine/collision/pairs/sphere_pairs.h"

#include <algorithm>
#include <cmath>

namespace pushfactor::engine::collision {

namespace {

constexpr double noise = 1e-6;           // of the permitted overlap: motion per step of a body at rest
constexpr double holding_along = 0.999;  // cosine above which a touch blocks motion along an axis

struct Mover {
    Vector3 centre;
    Motion before, with_forces;
};

Mover mover_of(const Body& body, const Shape& shape, double dt) {
    Mover mover{body.position, motion_of(body), motion_of(body, dt)};
    if (turns_in_itself(shape)) {
        mover.before.angular_velocity.setZero();
        mover.with_forces.angular_velocity.setZero();
    }
    return mover;
}

Vector3 velocity_at(const Motion& motion, const Vector3& centre, const Vector3& point) {
    return motion.velocity + motion.angular_velocity.cross(point - centre);
}

struct Movers {
    Mover a, b;

    // Closing speed of a towards b along `normal`, m/s.
    double before(const Vector3& normal, const Vector3& point) const {
        return normal.dot(velocity_at(a.before, a.centre, point) - velocity_at(b.before, b.centre, point));
    }
    double with_forces(const Vector3& normal, const Vector3& point) const {
        return normal.dot(velocity_at(a.with_forces, a.centre, point) -
                          velocity_at(b.with_forces, b.centre, point));
    }
    // Upper bound, because the weight of either may be held.
    double at_most(const Vector3& normal, const Vector3& point) const {
        return std::max(normal.dot(velocity_at(a.before, a.centre, point)),
                        normal.dot(velocity_at(a.with_forces, a.centre, point))) -
               std::min(normal.dot(velocity_at(b.before, b.centre, point)),
                        normal.dot(velocity_at(b.with_forces, b.centre, point)));
    }
};

const Body& body_of(int body, const Passing::Step& step) {
    return step.bodies[static_cast<std::size_t>(body)];
}

// With the centres at the time of impact, if the pair meets.
Movers movers_of(const Touch& touch, const Passing::Step& step) {
    const Body& a = touch.meeting ? touch.meeting->a : body_of(touch.body_a, step);
    const Body& b = touch.meeting ? touch.meeting->b : body_of(touch.body_b, step);
    return {mover_of(a, step.colliders[static_cast<std::size_t>(touch.pair.a)].shape, step.dt),
            mover_of(b, step.colliders[static_cast<std::size_t>(touch.pair.b)].shape, step.dt)};
}

Separation reversed(Separation axis) {
    axis.normal = -axis.normal;
    return axis;
}

// The two shapes of a touch at the start of the step.
struct Shapes {
    const Shape &a, &b;
    Pose pose_a, pose_b;

    Shapes(const Touch& touch, const Passing::Step& step)
        : a(step.colliders[static_cast<std::size_t>(touch.pair.a)].shape),
          b(step.colliders[static_cast<std::size_t>(touch.pair.b)].shape),
          pose_a(pose_of(body_of(touch.body_a, step))),
          pose_b(pose_of(body_of(touch.body_b, step))) {}

    // Calls `visit` with the separating axes in other directions than `normal`, at least those of which the gap
    // exceeds `least` [m]. Two spheres, and planes, have none.
    template <typename Visit>
    void visit_others(const Vector3& normal, double least, const Visit& visit) const {
        const auto visit_other = [&](const Separation& axis) {
            if (std::abs(axis.normal.dot(normal)) < same_direction) visit(axis);
        };
        const auto visit_hulls = [&](const auto& hull_a, const auto& hull_b) {
            visit_separations(PlacedHull(hull_a, pose_a), PlacedHull(hull_b, pose_b), least, visit_other);
        };
        std::visit(Overloaded{[&](const Box& box_a, const Box& box_b) {
                                  const Separations separations(box_a, pose_a, box_b, pose_b);
                                  for (const Separation& axis : separations.all()) visit_other(axis);
                              },
                              [&](const Box& box, const Sphere& sphere) {
                                  const Separations separations(box, pose_a, sphere, pose_b);
                                  for (const Separation& axis : separations.all()) visit(axis);
                              },
                              [&](const Sphere& sphere, const Box& box) {
                                  const Separations separations(box, pose_b, sphere, pose_a);
                                  for (const Separation& axis : separations.all()) visit(reversed(axis));
                              },
                              [&](const Polyhedron& p, const Polyhedron& q) { visit_hulls(p, q); },
                              [&](const Polyhedron& p, const Box& q) { visit_hulls(p, q); },
                              [&](const Box& p, const Polyhedron& q) { visit_hulls(p, q); },
                              [&](const Polyhedron& polyhedron, const Sphere& sphere) {
                                  visit_separations(polyhedron, pose_a, sphere, pose_b, visit);
                              },
                              [&](const Sphere& sphere, const Polyhedron& polyhedron) {
                                  visit_separations(polyhedron, pose_b, sphere, pose_a,
                                                    [&](const Separation& axis) { visit(reversed(axis)); });
                              },
                              [](const Sphere&, const Sphere&) {}, [](const Plane&, const auto&) {},
                              [](const auto&, const Plane&) {}, [](const Plane&, const Plane&) {}},
                   a, b);
    }

    // Collides the shapes along one of these axes.
    void collide_along(const Separation& axis, double room, double margin, Manifold& manifold) const {
        const auto collide_hulls = [&](const auto& hull_a, const auto& hull_b) {
            collide_hulls_along(axis, PlacedHull(hull_a, pose_a), PlacedHull(hull_b, pose_b), room, margin,
                                manifold);
        };
        std::visit(Overloaded{[&](const Box& box_a, const Box& box_b) {
                                  collide_box_box_along(axis, box_a, pose_a, box_b, pose_b, room, margin, manifold);
                              },
                              [&](const Box& box, const Sphere& sphere) {
                                  collide_box_sphere_along(axis, box, pose_a, sphere, pose_b, room, margin,
                                                           manifold);
                              },
                              [&](const Sphere& sphere, const Box& box) {
                                  collide_box_sphere_along(reversed(axis), box, pose_b, sphere, pose_a, room,
                                                           margin, manifold);
                                  manifold.normal = -manifold.normal;
                              },
                              [&](const Polyhedron& p, const Polyhedron& q) { collide_hulls(p, q); },
                              [&](const Polyhedron& p, const Box& q) { collide_hulls(p, q); },
                              [&](const Box& p, const Polyhedron& q) { collide_hulls(p, q); },
                              [&](const Polyhedron& polyhedron, const Sphere& sphere) {
                                  collide_polyhedron_sphere_along(axis, polyhedron, pose_a, sphere, pose_b, room,
                                                                  margin, manifold);
                              },
                              [&](const Sphere& sphere, const Polyhedron& polyhedron) {
                                  collide_polyhedron_sphere_along(reversed(axis), polyhedron, pose_b, sphere,
                                                                  pose_a, room, margin, manifold);
                                  manifold.normal = -manifold.normal;
                              },
                              [](const Sphere&, const Sphere&) {}, [](const Plane&, const auto&) {},
                              [](const auto&, const Plane&) {}, [](const Plane&, const Plane&) {}},
                   a, b);
    }
};

// How the axis of a touch closes within the step.
struct Closing {
    double path = 0.0;                // m, the longest path of a point beyond its gap; 0 if no gap closes
    double time = never;              // s, until the motion before the step closes the first point
    Vector3 where = Vector3::Zero();  // the point with the longest path
};

Closing closing_of(const Touch& touch, const Movers& movers, double permitted, double dt) {
    Closing closing;
    for (const ContactPoint& point : touch.points) {
        const double least = std::max(point.gap, noise * permitted);
        const double path = dt * movers.at_most(touch.normal, point.position);
        if (path > least && path - std::max(point.gap, 0.0) > closing.path) {
            closing.path = path - std::max(point.gap, 0.0);
            closing.where = point.position;
        }
        const double speed = movers.before(touch.normal, point.position);
        if (dt * speed > least) closing.time = std::min(closing.time, std::max(point.gap + permitted, 0.0) / speed);
    }
    return closing;
}

double fastest_before(const Movers& movers, const Vector3& normal, std::span<const ContactPoint> points) {
    double fastest = 0.0;
    for (const ContactPoint& point : points) fastest = std::max(fastest, movers.before(normal, point.position));
    return fastest;
}

// A touch that is just as doubtful, or meets no earlier, does not count as holding: two could hold each other.
bool can_hold(const Touch& holder, const Touch& touch) {
    if (holder.meeting) return touch.meeting && holder.meeting->time < touch.meeting->time;
    return !holder.doubtful;
}

const ContactPoint& nearest_to(const Vector3& where, std::span<const ContactPoint> points) {
    return *std::min_element(points.begin(), points.end(), [&](const ContactPoint& p, const ContactPoint& q) {
        return (p.position - where).squaredNorm() < (q.position - where).squaredNorm();
    });
}

}  // namespace

void Passing::list(std::span<const Touch> touches, const Step& step) {
    of_body_.first.assign(step.bodies.size(), -1);
    of_body_.next.resize(2 * touches.size());
    for (std::size_t i = 0; i < touches.size(); ++i) {
        for (const std::size_t place : {2 * i, 2 * i + 1}) {
            const int body = place == 2 * i ? touches[i].body_a : touches[i].body_b;
            of_body_.next[place] = of_body_.first[static_cast<std::size_t>(body)];
            of_body_.first[static_cast<std::size_t>(body)] = static_cast<int>(place);
        }
    }
}

// Whether the touch `holder` of `body` prevents that body from closing `axis` of `touch` within the step.
bool Passing::holds(const Touch& holder, int body, const Touch& touch, const Separation& axis, const Vector3& where,
                    const Step& step) const {
    const double way = (touch.body_a == body) == (holder.body_a == body) ? 1.0 : -1.0;
    if (way * holder.normal.dot(axis.normal) < holding_along) return false;
    const double permitted = step.detection.permitted * touch.size;
    const Movers held = movers_of(holder, step);
    const ContactPoint& point = nearest_to(where, holder.points);
    const double gap = std::max(point.gap, 0.0);
    // A movable body may give way to more than a light touch.
    const bool is_fixed = body_of(holder.body_a == body ? holder.body_b : holder.body_a, step).is_static();
    if (!is_fixed && step.dt * held.before(holder.normal, point.position) > gap + permitted) return false;
    const double stopped = std::max(0.0, step.dt * held.with_forces(holder.normal, point.position) - gap);
    const double path = step.dt * movers_of(touch, step).with_forces(axis.normal, where);
    return path - stopped <= axis.gap + permitted;
}

bool Passing::is_held(const Touch& touch, const Separation& axis, const Vector3& where,
                      std::span<const Touch> touches, const Step& step) const {
    for (const int body : {touch.body_a, touch.body_b}) {
        if (body_of(body, step).is_static()) continue;
        int place = of_body_.first[static_cast<std::size_t>(body)];
        for (; place >= 0; place = of_body_.next[static_cast<std::size_t>(place)]) {
            const Touch& holder = touches[static_cast<std::size_t>(place / 2)];
            if (can_hold(holder, touch) && holds(holder, body, touch, axis, where, step)) return true;
        }
    }
    return false;
}

std::optional<Passing::Choice> Passing::last_to_close(const Touch& touch, std::span<const Touch> touches,
                                                      const Step& step) const {
    const double permitted = step.detection.permitted * touch.size;
    const Movers movers = movers_of(touch, step);
    const Closing closing = closing_of(touch, movers, permitted, step.dt);
    if (closing.path <= 0.0) return std::nullopt;
    std::optional<Choice> last;
    Shapes(touch, step)
        .visit_others(touch.normal, -permitted - axis_rounding * touch.size, [&](const Separation& axis) {
            if (axis.gap + permitted < 0.0) return;
            double time = 0.0;
            if (closing.time < never) {
                const double speed = fastest_before(movers, axis.normal, touch.points);
                time = speed > 0.0 ? (axis.gap + permitted) / speed : never;
                if (time <= closing.time) time = 0.0;
            }
            if (time < step.dt && is_held(touch, axis, closing.where, touches, step)) time = never;
            if (time == 0.0) return;
            // Among axes that are equal up to rounding take the first, which is a face axis.
            const bool later = !last || time > last->time ||
                               (time == last->time && axis.gap > last->axis.gap + axis_rounding * touch.size);
            if (later) last = {axis, time};
        });
    return last;
}

void Passing::put_right(std::vector<Touch>& touches, const Step& step) {
    found_.clear();
    bool is_listed = false, any_empty = false;
    for (std::size_t i = 0; i < touches.size(); ++i) {
        const Touch& touch = touches[i];
        if (!touch.doubtful) continue;
        if (!is_listed) list(touches, step);
        is_listed = true;
        const std::optional<Choice> choice = last_to_close(touch, touches, step);
        if (!choice) continue;
        // If the axis closes in this step, include the points that the motion brings in.
        const double speed = std::abs(fastest_before(movers_of(touch, step), touch.normal, touch.points));
        const double room = choice->time < step.dt ? speed * step.dt : 0.0;
        const Shapes shapes(touch, step);
        Manifold& manifold = found_.emplace_back(Found{i, {}}).manifold;
        shapes.collide_along(choice->axis, room, step.detection.margin * touch.size, manifold);
        if (step.detection.reduce_to_four_points) reduce_to_four(manifold, shapes.pose_a.rotation);
        any_empty = any_empty || manifold.count == 0;
    }
    points_.clear();
    for (const Found& found : found_) {
        const auto points = found.manifold.points();
        points_.insert(points_.end(), points.begin(), points.end());
    }
    std::span<const ContactPoint> left = points_;
    for (const Found& found : found_) {
        const auto count = static_cast<std::size_t>(found.manifold.count);
        touches[found.touch].normal = found.manifold.normal;
        touches[found.touch].points = left.first(count);
        left = left.subspan(count);
    }
    if (any_empty) std::erase_if(touches, [](const Touch& touch) { return touch.points.empty(); });
}

bool Passing::is_kept_apart(const Touch& touch, std::span<const Touch> touches, const Step& step) const {
    const double permitted = step.detection.permitted * touch.size;
    bool apart = false;
    Shapes(touch, step)
        .visit_others(touch.normal, -permitted - axis_rounding * touch.size, [&](const Separation& axis) {
            if (apart || axis.gap + permitted < 0.0) return;
            apart = is_held(touch, axis, touch.points.front().position, touches, step);
        });
    return apart;
}

void Passing::take_out_held(std::vector<Touch>& touches, const Step& step) {
    if (std::none_of(touches.begin(), touches.end(), [](const Touch& touch) { return touch.meeting; })) return;
    list(touches, step);
    std::vector<Pair> out;
    for (const Touch& touch : touches) {
        if (touch.meeting && is_kept_apart(touch, touches, step)) out.push_back(touch.pair);
    }
    std::erase_if(touches,
                  [&](const Touch& touch) { return std::binary_search(out.begin(), out.end(), touch.pair); });
}

}  // namespace pushfactor::engine::collision
