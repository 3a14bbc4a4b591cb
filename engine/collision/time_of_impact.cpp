#include "engine/collision/time_of_impact.h"

#include "engine/base/overloaded.h"
#include "engine/collision/pairs/axis_choice.h"
#include "engine/collision/pairs/hull_axes.h"
#include "engine/collision/pairs/pair_table.h"
#include "engine/collision/pairs/separations.h"

#include <algorithm>
#include <cmath>

namespace pushfactor::engine::collision {

namespace {

constexpr int most_waits = 400;  // a box that spins by hundreds of radians per step needs many

// A pair at one time of its motion.
struct Placed {
    const Moving& a;
    const Moving& b;
    Pose pose_a, pose_b;
};

// Upper bound on the motion of a shape's extent along a direction: first- and second-order terms in time.
struct Reach {
    double speed = 0.0;         // m/s, of the fastest point
    double acceleration = 0.0;  // m/s^2, the most that turning can add to it
};

Reach operator+(const Reach& p, const Reach& q) {
    return {p.speed + q.speed, p.acceleration + q.acceleration};
}

Reach reach_along(const Moving& moving, const Pose& pose, const Vector3& direction) {
    Reach reach{.speed = moving.motion.velocity.dot(direction)};
    const double radius = std::sqrt(squared_turning_radius(moving.shape));
    if (radius == 0.0) return reach;
    // direction . (w x r) = r . across, and its rate of change is (w x r) . -across.
    const Vector3 across = direction.cross(moving.motion.angular_velocity);
    reach.speed += reach_along(moving.shape, pose.rotation, across);
    reach.acceleration = across.norm() * moving.motion.angular_velocity.norm() * radius;
    return reach;
}

Reach closing(const Placed& pair, const Vector3& normal) {
    return reach_along(pair.a, pair.pose_a, normal) + reach_along(pair.b, pair.pose_b, -normal);
}

// The root of gap = speed t + acceleration t^2 / 2.
double time_to_close(double gap, const Reach& reach) {
    if (gap <= 0.0) return 0.0;
    if (reach.acceleration <= 0.0) return reach.speed > 0.0 ? gap / reach.speed : never;
    const double root = std::sqrt(reach.speed * reach.speed + 2.0 * reach.acceleration * gap);
    return reach.speed > 0.0 ? 2.0 * gap / (reach.speed + root) : (root - reach.speed) / reach.acceleration;
}

// The direction in which the shapes are closest.
Separation closest(const Placed& pair) {
    Manifold nearest;
    collide(pair.a.shape, pair.pose_a, pair.b.shape, pair.pose_b, never, nearest);
    double gap = never;
    for (const ContactPoint& point : nearest.points()) gap = std::min(gap, point.gap);
    return {nearest.normal, gap};
}

// Calls `visit` with the separations that matter: the largest, and those of a gap above `least` [m]; of polyhedra
// those of faces alone if they are `enough()`.
template <typename Visit, typename Enough>
void visit_separations(const Placed& pair, double least, const Visit& visit, const Enough& enough) {
    const auto visit_hulls = [&](const auto& a, const auto& b) {
        visit_separations(PlacedHull(a, pair.pose_a), PlacedHull(b, pair.pose_b), least, visit, enough);
    };
    std::visit(Overloaded{[&](const Box& a, const Box& b) {
                              const Separations separations(a, pair.pose_a, b, pair.pose_b);
                              for (const Separation& axis : separations.all()) visit(axis);
                          },
                          [&](const Polyhedron& a, const Polyhedron& b) { visit_hulls(a, b); },
                          [&](const Polyhedron& a, const Box& b) { visit_hulls(a, b); },
                          [&](const Box& a, const Polyhedron& b) { visit_hulls(a, b); },
                          [&](const Sphere&, const auto&) { visit(closest(pair)); },
                          [&](const auto&, const Sphere&) { visit(closest(pair)); },
                          [&](const Sphere&, const Sphere&) { visit(closest(pair)); },
                          [&](const Plane&, const auto&) { visit(closest(pair)); },
                          [&](const auto&, const Plane&) { visit(closest(pair)); },
                          [&](const Plane&, const Plane&) { visit(closest(pair)); },
                          [&](const Plane&, const Sphere&) { visit(closest(pair)); },
                          [&](const Sphere&, const Plane&) { visit(closest(pair)); }},
               pair.a.shape, pair.b.shape);
}

// Whether visit_separations() looks along all axes of the pair and not only along those that matter.
bool has_all_directions(const Placed& pair) {
    const auto is_polyhedron = [](const Shape& shape) { return std::holds_alternative<Polyhedron>(shape); };
    return !is_polyhedron(pair.a.shape) && !is_polyhedron(pair.b.shape);
}

// Upper bound on the speed of points of the shapes towards each other, m/s.
double fastest(const Placed& pair) {
    const auto turning = [](const Moving& moving) {
        return moving.motion.angular_velocity.norm() * std::sqrt(squared_turning_radius(moving.shape));
    };
    return (pair.a.motion.velocity - pair.b.motion.velocity).norm() + turning(pair.a) + turning(pair.b);
}

// Time before which the shapes cannot meet, and their distance now.
struct Wait {
    double time = 0.0;     // s
    double gap = -never;   // m, largest
    double fastest = 0.0;  // m/s, over these directions
};

// `permitted`: overlap [m] up to which they still count as separated. `enough`: a wait [s] and a gap [m] beyond
// which longer ones do not matter.
Wait wait_of(const Placed& pair, double permitted, const Wait& enough) {
    Wait wait;
    visit_separations(
        pair, -permitted,
        [&](const Separation& separation) {
            const Reach reach = closing(pair, separation.normal);
            const double gap = separation.gap + permitted;
            wait.time = std::max(wait.time, time_to_close(gap, reach));
            wait.gap = std::max(wait.gap, gap);
            wait.fastest = std::max(wait.fastest, reach.speed);
        },
        [&] { return wait.time > enough.time && wait.gap > enough.gap; });
    return wait;
}

double path(const Reach& reach, double time) {
    return std::max(0.0, (reach.speed + 0.5 * reach.acceleration * time) * time);
}

// Points of a pair that has just met, including those that may close in the `rest` [s] of the step.
Manifold manifold_of(const Placed& pair, double rest, double margin) {
    Manifold manifold;
    collide(pair.a.shape, pair.pose_a, pair.b.shape, pair.pose_b, margin, manifold);
    if (manifold.count == 0) return manifold;
    const double reach = margin + path(closing(pair, manifold.normal), rest);
    collide(pair.a.shape, pair.pose_a, pair.b.shape, pair.pose_b, reach, manifold);
    return manifold;
}

}  // namespace

Pose pose_at(const Moving& moving, double time) {
    Pose pose = moving.start;
    pose.position += time * moving.motion.velocity;
    const double rate = moving.motion.angular_velocity.norm();
    if (rate * time > 0.0) {
        pose.rotation = Eigen::AngleAxisd(rate * time, moving.motion.angular_velocity / rate) * pose.rotation;
    }
    return pose;
}

double approach(const Moving& a, const Moving& b, const Vector3& normal, double time) {
    return path(closing({a, b, a.start, b.start}, normal), time);
}

Course course_of(const Moving& a, const Moving& b, double dt, const Nearness& nearness) {
    const double tolerance = nearness.tolerance;
    double time = 0.0;
    double overlap = 0.0;
    std::optional<Meeting> graze;
    int i = 0;
    for (; i < most_waits && time < dt; ++i) {
        const Placed pair{a, b, pose_at(a, time), pose_at(b, time)};
        Wait wait = wait_of(pair, overlap, {.time = dt - time, .gap = tolerance});
        if (wait.gap <= tolerance) {
            const Manifold manifold = manifold_of(pair, dt - time, std::max(nearness.margin, 2.0 * tolerance));
            const bool grazes = manifold.count > 0 && overlap < nearness.permitted &&
                                manifold.other_gap + nearness.permitted > tolerance;
            const Meeting here{time, pair.pose_a, pair.pose_b, manifold};
            if (grazes) {
                graze = here;
                overlap = nearness.permitted;
                continue;
            }
            // They meet where they grazed first, unless they went on to another face.
            const bool same = graze && graze->manifold.normal.dot(manifold.normal) > same_direction;
            if (manifold.count > 0) return {same ? *graze : here};
            // All axes within tolerance but the manifold is empty (corner beside corner): advance and retry.
            const double speed = has_all_directions(pair) ? wait.fastest : fastest(pair);
            wait.time = std::max(wait.time, 0.1 * tolerance / speed);
        }
        time += wait.time;
    }
    return {.meeting = std::nullopt, .decided = i < most_waits};
}

}  // namespace pushfactor::engine::collision
