// Paper section 5: j_c of every kind of row against finite differences of its primitive, in all twelve directions
// in which two bodies can move, at random poses. Bars, ropes and struts have c = |p_ab| - l, and RATTLE has their
// rows; contacts have c = -d, the gap; rows across the normal have no c (5.4), they are the rates at which the
// material points of the bodies slide over each other.
#include "engine/collision/pairs/collide.h"
#include "engine/collision/time_of_impact.h"
#include "engine/constraints/contact_constraints.h"
#include "engine/constraints/distance_constraints.h"
#include "tests/catch.h"
#include "tests/engine/rows.h"
#include "tests/random.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

using namespace pushfactor::engine;
using namespace pushfactor::engine::collision;
using pushfactor::tests::Random;

namespace {

constexpr double dt = 1.0 / 60.0;

// Central differences err by h^2/6 of the third derivative of c: below 100 for arms of 2 m and distances over 0.3
// m. Rounding adds 1e-16 / h.
constexpr double h = 1e-4;  // m or rad
constexpr double tolerance = 100.0 * h * h / 6.0;
// The error that must be detected.
constexpr double wrong = 1000.0 * tolerance;

// `body` moved along (0..2) or turned about (3..5) an axis of the world, about its centre of mass.
Body moved(Body body, int direction, double by) {
    if (direction < 3) {
        body.position[direction] += by;
    } else {
        body.orientation = Quaternion(Eigen::AngleAxisd(by, Vector3::Unit(direction - 3))) * body.orientation;
    }
    return body;
}

// The largest difference between j_c and the derivative of `c`, a function of both bodies. Empty where c is
// undefined after a small motion. The half of a static body has to be zero (5.3).
template <class C>
std::optional<double> error_of(const Jacobian& j, const Body& a, const Body& b, const C& c) {
    double squares = 0.0;
    const auto compare = [&](const Vector6& half, const Body& body, const auto& c_of) {
        for (int direction = 0; direction < 6; ++direction) {
            double rate = 0.0;
            if (!body.is_static()) {
                const std::optional<double> after = c_of(moved(body, direction, h));
                const std::optional<double> before = c_of(moved(body, direction, -h));
                if (!after || !before) return false;
                rate = (*after - *before) / (2.0 * h);
            }
            squares += (half[direction] - rate) * (half[direction] - rate);
        }
        return true;
    };
    const bool there = compare(j.a, a, [&](const Body& other) { return c(other, b); }) &&
                       compare(j.b, b, [&](const Body& other) { return c(a, other); });
    return there ? std::optional(std::sqrt(squares)) : std::nullopt;
}

// The component of p_b - p_a along a direction, p_a and p_b being the material points of the bodies that are at
// `point`.
auto parting(const Body& a, const Body& b, const Vector3& point, const Vector3& direction) {
    const Vector3 on_a = a.orientation.conjugate() * (point - a.position);
    const Vector3 on_b = b.orientation.conjugate() * (point - b.position);
    return [=](const Body& moved_a, const Body& moved_b) -> std::optional<double> {
        const Vector3 p_a = moved_a.position + moved_a.orientation * on_a;
        const Vector3 p_b = moved_b.position + moved_b.orientation * on_b;
        return direction.dot(p_b - p_a);
    };
}

// The slip of 5.2, r_a in the place of r_b, for a row along `direction` with this r_a.
Jacobian with_wrong_arm(Jacobian j, const Vector3& r_a, const Vector3& direction) {
    j.b.tail<3>() = r_a.cross(direction);
    return j;
}

}  // namespace

TEST_CASE("every row's j_c is the derivative of its c: bars, ropes and struts") {
    Random random(51);
    for (int i = 0; i < 200; ++i) {
        std::vector<Body> bodies;
        for (const double x : {-1.0, 1.0}) {
            const Vector3 position = Vector3(x, 0, 0) + random.vector(-0.5, 0.5);
            bodies.push_back(box_body(1.0, Vector3::Ones(), position, random.rotation()));
        }
        if (i % 4 == 0) bodies[static_cast<std::size_t>(i / 4 % 2)].inverse_mass = 0.0;
        Distance distance{.body_a = 0, .body_b = 1, .length = random.in(0.5, 3)};
        distance.acts = i % 3 == 0   ? Distance::Acts::both
                        : i % 3 == 1 ? Distance::Acts::pulls
                                     : Distance::Acts::pushes;
        distance.point_a = random.vector(-1, 1);
        distance.point_b = random.vector(-1, 1);
        const auto c = [&](const Body& a, const Body& b) -> std::optional<double> {
            const auto [from, to] = span_of(distance, std::array{a, b});
            return (to - from).norm() - distance.length;
        };
        const auto [p_a, p_b] = span_of(distance, bodies);
        if ((p_b - p_a).norm() < 0.3) continue;

        std::vector<ConstraintRow> rows = pushfactor::tests::rows_of(
            DistanceConstraints({distance}, {PushKind::persistent, 1.0}, false), {bodies, dt});
        REQUIRE(error_of(rows[0].jacobian, bodies[0], bodies[1], c).value() < tolerance);
        // What RATTLE uses in place of the push.
        REQUIRE(rows[0].push.lasting * dt == Approx(-c(bodies[0], bodies[1]).value()).margin(1e-14));
        if (bodies[1].is_static()) continue;
        const Jacobian slip = with_wrong_arm(rows[0].jacobian, p_a - bodies[0].position, (p_b - p_a).normalized());
        REQUIRE(error_of(slip, bodies[0], bodies[1], c).value() > wrong);
    }
}

namespace {

// Two bodies with shapes, the first two of a contact stage.
struct ShapePair {
    const char* name;
    Shape a, b;
};

const Box brick{Vector3(0.5, 0.8, 0.3)}, cube{Vector3(0.6, 0.6, 0.6)};
const Sphere small{0.4}, large{0.9};
const std::array shape_pairs{
    ShapePair{"box and box", brick, cube},         ShapePair{"box and sphere", brick, small},
    ShapePair{"sphere and box", small, brick},     ShapePair{"sphere and sphere", small, large},
    ShapePair{"plane and box", Plane{}, brick},    ShapePair{"box and plane", cube, Plane{}},
    ShapePair{"plane and sphere", Plane{}, large}, ShapePair{"sphere and plane", small, Plane{}},
};

Body body_of(const Shape& shape, const Vector3& position, const Quaternion& orientation) {
    if (const auto* box = std::get_if<Box>(&shape)) {
        return box_body(1.0, 2.0 * box->half_size, position, orientation);
    }
    if (const auto* sphere = std::get_if<Sphere>(&shape)) {
        return ball_body(1.0, sphere->radius, position, orientation);
    }
    return static_body(position, orientation);
}

constexpr double everything = 10.0;  // m, a margin

Manifold touching(const ShapePair& shapes, const Body& a, const Body& b) {
    Manifold manifold;
    collide(shapes.a, pose_of(a), shapes.b, pose_of(b), everything, manifold);
    return manifold;
}

// The pair at a random pose with the nearest points `gap` apart.
std::array<Body, 2> random_pair(const ShapePair& shapes, double gap, Random& random) {
    const Quaternion of_a = random.rotation(), of_b = random.rotation();
    std::array<Body, 2> bodies{body_of(shapes.a, Vector3::Zero(), of_a),
                               body_of(shapes.b, random.vector(-1, 1), of_b)};
    const Manifold manifold = touching(shapes, bodies[0], bodies[1]);
    double nearest = everything;
    for (const ContactPoint& point : manifold.points()) nearest = std::min(nearest, point.gap);
    Body& shifted = bodies[1].is_static() ? bodies[0] : bodies[1];
    const double towards = bodies[1].is_static() ? -1.0 : 1.0;
    shifted.position += towards * (gap - nearest) * manifold.normal;
    return bodies;
}

// Where a point lies on the surface of a box: how many of its faces meet there, 3 at a corner and 2 on an edge, and
// whether the edge, or one of the box's faces for a point of the other, is square to the normal.
struct Spot {
    int faces = 0;
    bool on_square_edge = false;
    bool has_face_of_normal = false;

    Spot(const Box& box, const Body& body, const Vector3& point, const Vector3& normal) {
        const Vector3 local = body.orientation.conjugate() * (point - body.position);
        const Vector3 along = (body.orientation.conjugate() * normal).cwiseAbs();
        for (int axis = 0; axis < 3; ++axis) {
            const bool on_face = std::abs(std::abs(local[axis]) - box.half_size[axis]) < 1e-9;
            faces += on_face;
            if (!on_face && along[axis] < 1e-12) on_square_edge = true;
        }
        has_face_of_normal = along.maxCoeff() > 1.0 - 1e-12;
    }
};

// Whether the gap at a point follows from the motion of the bodies alone: at the corner of a box on a face to which
// the normal belongs, where two edges to which it is square cross, and wherever a sphere takes part. Other corners
// slide along an edge or a face that is tilted against the normal, which turns into gap.
bool has_gap_of_its_own(const ShapePair& shapes, const Body& a, const Body& b, const ContactSite& site,
                        double gap) {
    const auto* box_a = std::get_if<Box>(&shapes.a);
    const auto* box_b = std::get_if<Box>(&shapes.b);
    if (!box_a || !box_b) return true;
    const Spot on_a(*box_a, a, site.position - 0.5 * gap * site.normal, site.normal);
    const Spot on_b(*box_b, b, site.position + 0.5 * gap * site.normal, site.normal);
    const bool cross = on_a.faces == 2 && on_b.faces == 2 && on_a.on_square_edge && on_b.on_square_edge;
    return (on_a.faces == 3 && on_b.has_face_of_normal) || (on_b.faces == 3 && on_a.has_face_of_normal) || cross;
}

// The number of points of a pair whose gap was compared, and of those that were apart.
struct Compared {
    int gaps = 0;
    int margin = 0;
};

// Compares the rows of all `sites`, whose bodies are at `a` and `b`.
void compare_rows(const ShapePair& shapes, const Body& a, const Body& b, std::span<const ConstraintRow> rows,
                  std::span<const ContactSite> sites, Compared& compared) {
    const Manifold manifold = touching(shapes, a, b);
    for (const ContactSite& site : sites) {
        const auto points = manifold.points();
        const auto point = std::find_if(points.begin(), points.end(), [&](const ContactPoint& candidate) {
            return (candidate.position - site.position).norm() < 1e-9;
        });
        REQUIRE(point != points.end());
        const auto gap = [&](const Body& moved_a, const Body& moved_b) -> std::optional<double> {
            const Manifold moved = touching(shapes, moved_a, moved_b);
            for (const ContactPoint& now : moved.points()) {
                if (now.feature == point->feature) return now.gap;
            }
            return std::nullopt;
        };

        const Jacobian& normal = rows[site.normal_row].jacobian;
        const auto apart = parting(a, b, site.position, site.normal);
        REQUIRE(error_of(normal, a, b, apart).value() < tolerance);
        if (has_gap_of_its_own(shapes, a, b, site, point->gap)) {
            if (const std::optional<double> error = error_of(normal, a, b, gap)) {
                REQUIRE(*error < tolerance);
                ++compared.gaps;
                compared.margin += point->gap > 0.0;
            }
        }
        for (const std::size_t which : {0u, 1u}) {
            const Vector3& tangent = site.tangents[which];
            const Jacobian& across = rows[*site.friction_row + which].jacobian;
            const auto sliding = parting(a, b, site.position, tangent);
            REQUIRE(error_of(across, a, b, sliding).value() < tolerance);
            REQUIRE(error_of(normal, a, b, sliding).value() > wrong);
            if (a.is_static() || b.is_static()) continue;
            const Jacobian slip = with_wrong_arm(across, site.position - a.position, tangent);
            REQUIRE(error_of(slip, a, b, sliding).value() > wrong);
        }
    }
}

ContactConstraints stage_of(const ShapePair& shapes, double margin) {
    ContactConstraints stage({{.body = 0, .shape = shapes.a}, {.body = 1, .shape = shapes.b}},
                             {.correction = {},
                              .slop = 0.0,
                              .detection = {.margin = margin, .reduce_to_four_points = false},
                              .order = RowOrder::bottom_up});
    stage.set_friction(coulomb_friction);
    return stage;
}

}  // namespace

TEST_CASE("every row's j_c is the derivative of its c: contacts and friction, in and beyond the margin") {
    Random random(53);
    for (const ShapePair& shapes : shape_pairs) {
        INFO(shapes.name);
        Compared compared;
        for (int i = 0; i < 150; ++i) {
            const std::array<Body, 2> bodies = random_pair(shapes, random.in(-0.1, 0.1), random);
            ContactConstraints stage = stage_of(shapes, 0.3);
            std::vector<ConstraintRow> rows = pushfactor::tests::rows_of(stage, {bodies, dt});
            REQUIRE(rows.size() >= 3);
            compare_rows(shapes, bodies[0], bodies[1], rows, stage.sites(), compared);
        }
        CHECK(compared.margin > 20);
        CHECK(compared.gaps - compared.margin > 20);
    }
}

TEST_CASE("every row's j_c is the derivative of its c where fast bodies meet within the step") {
    Random random(54);
    for (const ShapePair& shapes : shape_pairs) {
        INFO(shapes.name);
        Compared compared;
        for (int i = 0; i < 30; ++i) {
            std::array<Body, 2> bodies = random_pair(shapes, 0.5, random);
            const Vector3 normal = touching(shapes, bodies[0], bodies[1]).normal;
            for (Body& body : bodies) {
                if (body.is_static()) continue;
                body.linear_momentum = (&body == &bodies[0] ? 60.0 : -60.0) * normal + random.vector(-5, 5);
                body.angular_momentum = random.vector(-1, 1);
            }
            ContactConstraints stage = stage_of(shapes, 0.01);
            stage.set_continuous_collision(std::make_unique<ContinuousCollision>());
            std::vector<ConstraintRow> rows = pushfactor::tests::rows_of(stage, {bodies, dt});
            REQUIRE(rows.size() >= 3);
            REQUIRE(stage.sites()[0].swept);

            // Their rows belong to the time of impact, including the rotation.
            const double size = std::min(size_of(shapes.a), size_of(shapes.b));
            const auto moving = [&](const Shape& shape, const Body& body) {
                return Moving{shape, pose_of(body), motion_in_step(body, dt, rotate_splitting)};
            };
            const Moving first = moving(shapes.a, bodies[0]), second = moving(shapes.b, bodies[1]);
            const double time = course_of(first, second, dt, 2e-6 * size).time;
            REQUIRE(time < dt);
            const auto met = [](Body body, const Pose& pose) {
                body.position = pose.position;
                body.orientation = Quaternion(pose.rotation);
                return body;
            };
            const Body a = met(bodies[0], pose_at(first, time)), b = met(bodies[1], pose_at(second, time));
            compare_rows(shapes, a, b, rows, stage.sites(), compared);
        }
        CHECK(compared.gaps > 20);
    }
}
