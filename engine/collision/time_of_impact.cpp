#include "engine/collision/time_of_impact.h"

#include "engine/base/overloaded.h"
#include "engine/collision/pairs/collide.h"
#include "engine/collision/pairs/hull_axes.h"
#include "engine/collision/pairs/separations.h"

#include <algorithm>
#include <cmath>

namespace pushfactor::engine::collision {

namespace {

constexpr int most_waits = 400;  // a box that spins by hundreds of radians per step needs many

// A direction serves for so many waits, or until it is closed; then the one with the longest wait is searched
// again.
constexpr int most_served = 8;

// A pair at one time of its motion.
struct Placed {
    const Moving& a;
    const Moving& b;
    Pose pose_a, pose_b;
};

// A direction from a to b, which may turn with one of them: that of a face does, and stays the best one longer.
struct Direction {
    Vector3 normal = Vector3::Zero();   // unit length
    Vector3 turning = Vector3::Zero();  // rad/s
};

// How far the shapes are at least apart along a direction, t seconds later (0 <= t <= rest). Seen from a frame that
// turns with the direction,
//
//   gap(t) = n . (x + t (v - w x x)) - s_a(n + t n x w_a) - s_b(-n - t n x w_b) - t^2 / 2 A
//
// Symbols: n the direction, unit length; w its angular velocity; x and v position and velocity of b relative to a;
// w_a, w_b the angular velocities of the shapes relative to the direction; s(d) the support of a shape, the largest
// of d . r over its points r; A a bound on all accelerations along n. Of a point r only w_a x r is linear in time,
// so s(n + t n x w_a) is its largest n . r then. The gap is concave in t: its chords lie below it, and a root of
// one never comes after its own.
class LeastGap {
  public:
    LeastGap(const Placed& pair, const Direction& direction, double rest)
        : a_(pair.a.shape),
          b_(pair.b.shape),
          turn_a_(pair.pose_a.rotation),
          turn_b_(pair.pose_b.rotation),
          normal_(direction.normal) {
        const Vector3& w = direction.turning;
        const Vector3 x = pair.pose_b.position - pair.pose_a.position;
        const Vector3 v = pair.b.motion.velocity - pair.a.motion.velocity;
        offset_ = normal_.dot(x);
        speed_ = normal_.dot(v - w.cross(x));
        if (!w.isZero(0.0)) {
            const double tilt = normal_.cross(w).norm(), fast = v.norm();
            acceleration_ = tilt * (w.norm() * (x.norm() + rest * fast) + 2.0 * fast);
        }
        across_a_ = across(pair.a, normal_, w);
        across_b_ = across(pair.b, -normal_, w);
    }

    double at(double time) const {
        return offset_ + time * (speed_ - 0.5 * time * acceleration_) -
               support(a_, turn_a_, normal_ + time * across_a_) - support(b_, turn_b_, time * across_b_ - normal_);
    }

    // The time until the gap may be closed, not after it is; `rest` [s] if it stays open so long. `now`, `later`:
    // the gap at present, > 0, and after `rest`.
    double time_to_close(double now, double later, double rest) const {
        if (later >= 0.0) return rest;
        const double enough = 0.01 * now;  // what is left is the next wait's
        double open = 0.0, closed = rest;  // s
        for (int i = 0; i < 20 && now > enough; ++i) {
            const double chord = open + (closed - open) * now / (now - later);
            const double gap = std::max(0.0, at(chord));
            // The line through the last two points lies above the gap beyond them.
            const double beyond = now > gap ? chord + (chord - open) * gap / (now - gap) : closed;
            open = chord, now = gap;
            if (beyond >= closed) continue;
            const double next = at(beyond);
            if (next < 0.0) closed = beyond, later = next;
        }
        return open;
    }

  private:
    static double support(const Shape& shape, const Matrix3& rotation, const Vector3& direction) {
        return is_finite(shape) ? reach_along(shape, rotation, direction) : 0.0;  // of a plane along its own normal
    }

    Vector3 across(const Moving& moving, const Vector3& out, const Vector3& turning) {
        const double radius = std::sqrt(squared_turning_radius(moving.shape));
        if (radius == 0.0) return Vector3::Zero();
        const Vector3& own = moving.motion.angular_velocity;
        const Vector3 relative = own - turning, across = out.cross(relative);
        acceleration_ += turning.isZero(0.0) ? across.norm() * own.norm() * radius
                                             : relative.norm() * (own.norm() + turning.norm()) * radius;
        return across;
    }

    const Shape &a_, &b_;
    const Matrix3 &turn_a_, &turn_b_;
    Vector3 normal_;
    double offset_ = 0.0, speed_ = 0.0, acceleration_ = 0.0;  // m, m/s, m/s^2
    Vector3 across_a_, across_b_;                             // n x w_a, 1/s
};

// A direction in which the shapes are separated, and the time before which they cannot meet along it.
struct Wait {
    Direction direction;
    double gap = -never;  // m
    double time = 0.0;    // s
};

Wait wait_along(const Placed& pair, const Direction& direction, double rest) {
    const LeastGap gap(pair, direction, rest);
    const double now = gap.at(0.0);
    return {direction, now, now > 0.0 ? gap.time_to_close(now, gap.at(rest), rest) : 0.0};
}

// Angular velocity of the unit vector that stays across two edges that turn, `normal` at present; zero if they are
// so nearly parallel that it turns faster than both.
Vector3 turning_between(const Vector3& normal, const Vector3& along_a, const Vector3& turn_a,
                        const Vector3& along_b, const Vector3& turn_b) {
    const Vector3 across = along_a.cross(along_b);
    const Vector3 rate = turn_a.cross(along_a).cross(along_b) + along_a.cross(turn_b.cross(along_b));
    const Vector3 turning = normal.cross(rate) * (across.dot(normal) / across.squaredNorm());
    return turning.norm() <= turn_a.norm() + turn_b.norm() ? turning : Vector3::Zero();
}

// The direction with the longest wait as its chord has it, and the largest gap of all.
Wait longest_wait(const Placed& pair, double rest, double& largest_gap) {
    Direction best;
    double longest = -1.0;
    largest_gap = -never;
    const Vector3 &turn_a = pair.a.motion.angular_velocity, &turn_b = pair.b.motion.angular_velocity;
    const auto consider = [&](const Vector3& normal, const Vector3& turning, double gap) {
        largest_gap = std::max(largest_gap, gap);
        if (gap <= 0.0) return;
        const double later = LeastGap(pair, {normal, turning}, rest).at(rest);
        const double chord = later >= 0.0 ? rest : rest * gap / (gap - later);
        if (chord > longest) longest = chord, best = {normal, turning};
    };
    const auto consider_axis = [&](const Separation& axis, const auto& edge_of_a, const auto& edge_of_b) {
        if (axis.gap > 0.0 && axis.of_a >= 0 && axis.of_b >= 0) {
            const Vector3 along_a = pair.pose_a.rotation * edge_of_a(axis.of_a);
            const Vector3 along_b = pair.pose_b.rotation * edge_of_b(axis.of_b);
            consider(axis.normal, turning_between(axis.normal, along_a, turn_a, along_b, turn_b), axis.gap);
        } else {
            consider(axis.normal, axis.of_b < 0 ? turn_a : turn_b, axis.gap);
        }
    };
    const auto consider_hulls = [&](const auto& a, const auto& b) {
        const PlacedHull hull_a(a, pair.pose_a), hull_b(b, pair.pose_b);
        visit_separations(hull_a, hull_b, 0.0, [&](const Separation& axis) {
            consider_axis(
                axis, [&](int edge) { return hull_a.hull().edge(edge).direction; },
                [&](int edge) { return hull_b.hull().edge(edge).direction; });
        });
    };
    // With a ball or a plane there is one direction; it turns with the other one.
    const auto consider_closest = [&] {
        const bool with_a =
            std::holds_alternative<Plane>(pair.a.shape) || std::holds_alternative<Sphere>(pair.b.shape);
        Manifold nearest;
        collide(pair.a.shape, pair.pose_a, pair.b.shape, pair.pose_b, 0.0, nearest);
        consider(nearest.normal, with_a ? turn_a : turn_b, nearest.separation);
    };
    std::visit(Overloaded{[&](const Box& a, const Box& b) {
                              const Separations separations(a, pair.pose_a, b, pair.pose_b);
                              const auto unit = [](int axis) { return Vector3(Vector3::Unit(axis)); };
                              for (const Separation& axis : separations.all()) consider_axis(axis, unit, unit);
                          },
                          [&](const Flat auto& a, const Flat auto& b) { consider_hulls(a, b); },
                          [&](const auto&, const auto&) { consider_closest(); }},
               pair.a.shape, pair.b.shape);
    return longest < 0.0 ? Wait{} : wait_along(pair, best, rest);
}

// The direction between the closest corners or corner and edge: where those are what is closest, no separating axis
// has all of the distance.
Vector3 between_corners(const PlacedHull& a, const PlacedHull& b) {
    double least = never;
    Vector3 best = Vector3::Zero();
    const auto search = [&](const PlacedHull& of_corners, const PlacedHull& of_edges, double way) {
        const auto place = [](const PlacedHull& hull, int vertex) -> Vector3 {
            return hull.pose().position + hull.pose().rotation * hull.hull().vertex(vertex);
        };
        for (int corner = 0; corner < static_cast<int>(of_corners.hull().vertices.size()); ++corner) {
            const Vector3 point = place(of_corners, corner);
            for (const HullEdge& edge : of_edges.hull().edges) {
                const Vector3 from = place(of_edges, edge.from), along = of_edges.pose().rotation * edge.direction;
                const double share = std::clamp(along.dot(point - from), 0.0, edge.length);
                const Vector3 offset = from + share * along - point;
                if (offset.squaredNorm() >= least) continue;
                least = offset.squaredNorm();
                best = way * offset;
            }
        }
    };
    search(a, b, 1.0);
    search(b, a, -1.0);
    return best.normalized();
}

Wait wait_between_corners(const Placed& pair, double rest) {
    return std::visit(Overloaded{[&](const Flat auto& a, const Flat auto& b) {
                                     const Vector3 normal =
                                         between_corners(PlacedHull(a, pair.pose_a), PlacedHull(b, pair.pose_b));
                                     return wait_along(pair, {normal}, rest);
                                 },
                                 [](const auto&, const auto&) { return Wait{}; }},
                      pair.a.shape, pair.b.shape);
}

// Upper bound on the speed of points of the shapes towards each other, m/s.
double fastest(const Placed& pair) {
    const auto turning = [](const Moving& moving) {
        return moving.motion.angular_velocity.norm() * std::sqrt(squared_turning_radius(moving.shape));
    };
    return (pair.a.motion.velocity - pair.b.motion.velocity).norm() + turning(pair.a) + turning(pair.b);
}

bool has_points(const Placed& pair, double margin) {
    Manifold manifold;
    collide(pair.a.shape, pair.pose_a, pair.b.shape, pair.pose_b, margin, manifold);
    return manifold.count > 0;
}

// Two balls: the first root of |offset + t velocity| = distance.
Course course_of_balls(const Vector3& offset, const Vector3& velocity, double distance, double dt) {
    const double excess = offset.squaredNorm() - distance * distance;
    if (excess <= 0.0) return {.time = 0.0};
    const double closing = -offset.dot(velocity), square = velocity.squaredNorm();
    const double root = closing * closing - square * excess;
    if (closing <= 0.0 || root < 0.0) return {};
    const double time = excess / (closing + std::sqrt(root));
    return {.time = time < dt ? time : never};
}

}  // namespace

Pose pose_at(const Moving& moving, double time) {
    Pose pose = moving.start;
    pose.position += time * moving.motion.velocity;
    if (time > 0.0) pose.rotation = exponential(time * moving.motion.angular_velocity) * pose.rotation;
    return pose;
}

double gap_along(const Moving& a, const Moving& b, const Vector3& normal) {
    const Placed pair{a, b, a.start, b.start};
    return LeastGap(pair, {normal}, 0.0).at(0.0);
}

double approach(const Moving& a, const Moving& b, const Vector3& normal, double time) {
    const Placed pair{a, b, a.start, b.start};
    const LeastGap gap(pair, {normal}, time);
    return std::max(0.0, gap.at(0.0) - gap.at(time));
}

Course course_of(const Moving& a, const Moving& b, double dt, double tolerance) {
    const auto* ball_a = std::get_if<Sphere>(&a.shape);
    const auto* ball_b = std::get_if<Sphere>(&b.shape);
    if (ball_a && ball_b) {
        return course_of_balls(b.start.position - a.start.position, b.motion.velocity - a.motion.velocity,
                               ball_a->radius + ball_b->radius + tolerance, dt);
    }
    double time = 0.0;
    Wait wait;
    int waits = 0, serves = 0;
    for (; waits < most_waits && time < dt; ++waits, time += wait.time) {
        const Placed pair{a, b, pose_at(a, time), pose_at(b, time)};
        if (serves-- > 0) {
            Direction& direction = wait.direction;
            if (!direction.turning.isZero(0.0)) {
                direction.normal = (exponential(wait.time * direction.turning) * direction.normal).normalized();
            }
            wait = wait_along(pair, direction, dt - time);
            if (wait.gap > tolerance) continue;
        }
        double largest_gap = 0.0;
        wait = longest_wait(pair, dt - time, largest_gap);
        serves = most_served;
        if (largest_gap > tolerance) continue;
        if (has_points(pair, 2.0 * tolerance)) return {.time = time};
        // Close along all axes, but without points.
        wait = wait_between_corners(pair, dt - time);
        if (wait.gap > tolerance) continue;
        wait.time = std::max(wait.time, tolerance / fastest(pair));
        serves = 0;
    }
    return {.decided = time >= dt};
}

}  // namespace pushfactor::engine::collision
