// Contact and friction rows, paper sections 5.3 and 5.4.
#include "engine/constraints/contact_row.h"
#include "engine/constraints/friction_row.h"
#include "tests/catch.h"
#include "tests/random.h"

#include <cmath>

using namespace pushfactor::engine;
using pushfactor::tests::Random;

namespace {

Body moving_box(Random& random) {
    Body body = box_body(random.in(0.5, 3), random.vector(0.3, 2), random.vector(-2, 2), random.rotation());
    body.linear_momentum = random.vector(-3, 3);
    body.angular_momentum = random.vector(-3, 3);
    return body;
}

Vector6 velocity_of(const Body& body) {
    Vector6 v;
    v << velocity(body), angular_velocity(body);
    return v;
}

ConstraintRow contact(const BodyPair& pair, double gap, const Correction& correction, double slop = 0.0) {
    ConstraintRow row;
    write_contact_row(PairPoint(pair, {0.3, 0, 0.1}), Vector3::UnitY(), gap, correction, slop, 0.1, row);
    return row;
}

Jacobian along(const Vector3& direction, const PairPoint& point) {
    ConstraintRow row;
    point.place(row, direction);
    return row.jacobian;
}

}  // namespace

TEST_CASE("j_c v_ab is the speed at which the two material points part along the direction") {
    Random random(8);
    for (int i = 0; i < 500; ++i) {
        const Body a = moving_box(random);
        const Body b = moving_box(random);
        const Vector3 point = random.vector(-2, 2);
        const Vector3 n = random.rotation() * Vector3::UnitX();
        const Jacobian j = along(n, PairPoint({0, 1, a, b}, point));
        const double parting = n.dot(velocity_at(b, point) - velocity_at(a, point));
        REQUIRE(j.a.dot(velocity_of(a)) + j.b.dot(velocity_of(b)) == Approx(parting).margin(1e-12));
    }
}

TEST_CASE("the block of a static body is zero, whichever side it is on") {
    Random random(9);
    const Body wall = static_body(Vector3::Zero());
    const Body box = moving_box(random);
    CHECK(along(Vector3::UnitY(), PairPoint({0, 1, wall, box}, {1, 2, 3})).a == Vector6::Zero());
    CHECK(along(Vector3::UnitY(), PairPoint({1, 0, box, wall}, {1, 2, 3})).b == Vector6::Zero());
}

TEST_CASE("5.3.1: penetration beyond the slop is pushed out by beta d / dt, in the part that the kind names") {
    const Body ground = static_body(Vector3::Zero());
    const Body box = box_body(1.0, Vector3::Ones(), {0, 0.5, 0});
    const BodyPair pair{0, 1, ground, box};

    const ConstraintRow persistent = contact(pair, -0.05, {PushKind::persistent, 0.2});
    CHECK(persistent.push.lasting == Approx(0.1));
    CHECK(persistent.push.correcting == 0.0);
    const ConstraintRow single = contact(pair, -0.05, {PushKind::single_frame, 0.2}, 0.01);
    CHECK(single.push.lasting == 0.0);
    CHECK(single.push.correcting == Approx(0.08));
    CHECK(contact(pair, -0.05, {PushKind::none, 0.2}).push.correcting == 0.0);
    CHECK(contact(pair, -0.005, {PushKind::single_frame, 0.2}, 0.01).push.correcting == 0.0);
    CHECK(single.bounds.c_min == 0.0);
    CHECK(single.bounds.c_max == std::numeric_limits<double>::infinity());
}

TEST_CASE("the correcting push is limited to the speed that is given, either way") {
    const Body ground = static_body(Vector3::Zero());
    const Body box = box_body(1.0, Vector3::Ones(), {0, 0.5, 0});
    const BodyPair pair{0, 1, ground, box};
    const Correction limited{PushKind::single_frame, 0.2, 0.08};
    CHECK(contact(pair, -0.05, limited).push.correcting == 0.08);                 // 0.1 m/s without a limit
    CHECK(contact(pair, -0.02, limited).push.correcting == Approx(0.04));         // slower than that
    CHECK(correct({PushKind::persistent, 1.0, 0.5}, -3.0, 1.0).lasting == -0.5);  // a distance that is too long
}

TEST_CASE("a point in the margin may close its gap within the step, in both columns, whatever the kind") {
    const Body ground = static_body(Vector3::Zero());
    const Body box = box_body(1.0, Vector3::Ones(), {0, 0.6, 0});
    for (const PushKind kind : {PushKind::none, PushKind::persistent, PushKind::single_frame}) {
        const ConstraintRow row = contact({0, 1, ground, box}, 0.02, {kind, 0.2});
        CHECK(row.push.lasting == Approx(-0.2));
        CHECK(row.push.correcting == 0.0);
        // With a slop bodies apart by a thousandth of it touch and are not asked to move.
        CHECK(contact({0, 1, ground, box}, 0.02, {kind, 0.2}, 0.01).push.lasting == Approx(-0.2));
        CHECK(contact({0, 1, ground, box}, 1.1e-5, {kind, 0.2}, 0.01).push.lasting == Approx(-1.1e-4));
        CHECK(contact({0, 1, ground, box}, 0.9e-5, {kind, 0.2}, 0.01).push.lasting == 0.0);
        CHECK(contact({0, 1, ground, box}, 0.9e-5, {kind, 0.2}, 0.01).error == 0.0);
    }
}

TEST_CASE("the paper's friction bound is mu m |g n| over the points, whichever way n points") {
    const Body ground = static_body(Vector3::Zero());
    const Body one = box_body(2.0, Vector3::Ones(), Vector3::Zero());
    const Body other = box_body(3.0, Vector3::Ones(), Vector3::Zero());
    const FrictionRule rule = weight_friction(Vector3(0, -10, 0));
    const auto bound = [&](const Body& a, const Body& b, const Vector3& n) {
        const BodyPair pair{0, 1, a, b};
        return rule({.bodies = pair, .normal = n, .friction = 0.5, .points = 4}).at(0, Disc::first);
    };
    CHECK(bound(ground, one, Vector3::UnitY()).c_max == Approx(2.5));
    CHECK(bound(ground, one, -Vector3::UnitY()).c_max == Approx(2.5));
    CHECK(bound(one, other, Vector3::UnitY()).c_max == Approx(6.25));
    CHECK(bound(one, other, Vector3::UnitY()).c_min == Approx(-6.25));
    CHECK(bound(ground, one, Vector3::UnitX()).c_max == 0.0);
    CHECK(bound(ground, one, Vector3::UnitY()).of_row < 0);
}

TEST_CASE("Coulomb's bound names the contact row of the point, alone or together with the other tangent") {
    const Body ground = static_body(Vector3::Zero());
    const Body box = box_body(2.0, Vector3::Ones(), Vector3::Zero());
    const BodyPair pair{0, 1, ground, box};
    const Vector3 up = Vector3::UnitY();
    const FrictionSite site{.bodies = pair, .normal = up, .friction = 0.3, .points = 4};
    for (const Disc which : {Disc::first, Disc::second}) {
        for (const FrictionBound& bound : {coulomb_friction(site), cone_friction(site)}) {
            CHECK(bound.at(17, which).c_min == -0.3);
            CHECK(bound.at(17, which).c_max == 0.3);
            CHECK(bound.at(17, which).of_row == 17);
        }
        CHECK(coulomb_friction(site).at(17, which).disc == Disc::none);
        CHECK(cone_friction(site).at(17, which).disc == which);
    }
}

TEST_CASE("the first tangent lies along the sliding direction, or fixed in body a without one") {
    const Body ground = static_body(Vector3::Zero());
    Body box = box_body(2.0, Vector3::Ones(), {0, 0.5, 0});
    const BodyPair pair{0, 1, ground, box};
    const Vector3 up = Vector3::UnitY();
    const auto tangents = [&](const Vector3& belt) {
        const RelativeMotion motion(pair, motion_of(ground), motion_of(box), belt);
        return friction_tangents(up, motion.sliding(Vector3::Zero(), up), 1e-3, Vector3::UnitX());
    };
    CHECK(tangents(Vector3::Zero())[0] == Vector3::UnitX());
    box.linear_momentum = {6, -14, 8};
    const auto sliding = tangents(Vector3::Zero());
    CHECK((sliding[0] - Vector3(0.6, 0, 0.8)).norm() < 1e-15);
    CHECK(sliding[1].dot(sliding[0]) == Approx(0.0).margin(1e-15));
    CHECK(sliding[1].dot(up) == Approx(0.0).margin(1e-15));
    CHECK(sliding[1].norm() == Approx(1.0));
    // On a belt that runs as fast as the box it does not slide.
    CHECK(tangents(Vector3(3, 0, 4))[0] == Vector3::UnitX());
}
