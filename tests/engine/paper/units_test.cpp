// Paper section 9, line by line and in its order. Every line is checked while this file is compiled; a line that is
// wrong in the paper is followed by the right one.
//
// Symbols: J axes of the rows, v velocities, M masses, f forces, lambda, v (here: push) push factors, A and b of
// 6.2.9; _lin and _ang are the linear and the angular part. The tables of 9.2 for 6.2.7, 12.3.1 and the left sides
// of 12.3.3 are not in the text (12.3.3 is the line before b = A lambda in 12.3.1): here they follow from the
// equations.
#include "tests/engine/paper/units.h"

#include "engine/constraints/distance_constraints.h"
#include "engine/solvers/solver.h"
#include "tests/catch.h"
#include "tests/engine/rows.h"

#include <cmath>

using namespace pushfactor::tests::units;
namespace engine = pushfactor::engine;

namespace {

// Definitions of sections 3 and 6.1, before the question of units.
constexpr Second dt{};
constexpr Kilogram mass{};
constexpr Quantity<1, 2, 0> inertia{};
constexpr MetrePerSecond v_lin{};
constexpr PerSecond v_ang{};
constexpr MetrePerSecond2 vdot_lin{};  // d/dt of v
constexpr Quantity<0, 0, -2> vdot_ang{};
constexpr Newton f_lin{};
constexpr NewtonMetre f_ang{};
constexpr One radian{};

// The units of 9.1, in which J v is said to be work.
struct First {
    static constexpr Quantity<1, 1, -1> j_lin{};
    static constexpr Quantity<1, 2, -1> j_ang{};
    static constexpr PerSecond lambda{};
    static constexpr Quantity<1, 2, -2> push{};
};

// The units at the end of 9.2, which are the engine's.
struct Last {
    static constexpr One j_lin{};
    static constexpr Metre j_ang{};
    static constexpr Newton lambda{};
    static constexpr MetrePerSecond push{};
};

// 5.2.1 with p_b - p_a as printed, and the push that belongs to it.
struct Unnormalised {
    static constexpr Metre j_lin{};
    static constexpr Quantity<0, 2, 0> j_ang{};
    static constexpr Quantity<1, 0, -2> lambda{};
    static constexpr Quantity<0, 2, -1> push{};
};

// 5.2.1 with the push of 5.2.3, as section 5.2 has them side by side.
struct AsPrinted : Unnormalised {
    static constexpr MetrePerSecond push{};
};

// 6.2.7 and 12.3.3: every sum is of equal units, and both sides have the same unit.
template <class Units>
concept closes = requires(Units u) {
    mass* vdot_lin - (u.j_lin * u.lambda + f_lin);
    inertia* vdot_ang - (u.j_ang * u.lambda + f_ang);
    u.push / dt - u.j_lin*(v_lin / dt + f_lin / mass) - u.j_lin / mass* u.j_lin* u.lambda;
    u.push / dt - u.j_ang*(v_ang / dt + f_ang / inertia) - u.j_ang / inertia* u.j_ang* u.lambda;
};

}  // namespace

TEST_CASE("section 9.1: the paper's first unit system, line by line") {
    using Work = NewtonMetre;
    // "rad s^-1, which is the same as s^-1 because [...] rad = m/m"
    STATIC_REQUIRE(is<One>(Metre{} / Metre{}));
    STATIC_REQUIRE(is<PerSecond>(radian / Second{}));

    // "constraints do not perform work: J v = 0 | kg m^2 s^-2". That is a choice: J v = 0 has every unit. What does
    // no work is the constraint force, lambda^T J v = 0, and that product is a power, here too:
    STATIC_REQUIRE(is<Work>(First::j_lin * v_lin));
    STATIC_REQUIRE(is<Work>(First::j_ang * v_ang));
    STATIC_REQUIRE(is<Watt>(First::lambda * (First::j_lin * v_lin)));
    STATIC_REQUIRE(is<Watt>(First::lambda * (First::j_ang * v_ang)));
    // "w = tau phi"
    STATIC_REQUIRE(is<Work>(NewtonMetre{} * radian));
    // "J_lin | kg m s^-1", "J_ang | kg m^2 s^-1"
    STATIC_REQUIRE(is<Quantity<1, 1, -1>>(Work{} / v_lin));
    STATIC_REQUIRE(is<Quantity<1, 2, -1>>(Work{} / v_ang));

    // "M is kg for the linear part and kg m^2 for the angular part". 6.1.3 applies M^-1 to the velocities, which
    // has no meaning; the accelerations that it speaks of come from the forces.
    STATIC_REQUIRE(is<Quantity<-1, 1, -1>>(v_lin / mass));
    STATIC_REQUIRE(is<MetrePerSecond2>(f_lin / mass));
    STATIC_REQUIRE(is<Quantity<0, 0, -2>>(f_ang / inertia));
    // "f is kg m s^-2 for the linear part and kg m^2 s^-2 for the angular part"
    STATIC_REQUIRE(is<Newton>(mass * vdot_lin));
    STATIC_REQUIRE(is<NewtonMetre>(inertia * vdot_ang));

    // "f_lin = J_lin^T lambda | kg m s^-2 = kg m s^-1 s^-1; lambda | s^-1", and the angular part
    STATIC_REQUIRE(is<PerSecond>(f_lin / First::j_lin));
    STATIC_REQUIRE(is<PerSecond>(f_ang / First::j_ang));
    // Then lambda is no force, and the bounds of 5.1 and of the table of symbols, in newton, cannot bound it.
    STATIC_REQUIRE_FALSE(can_subtract<decltype(First::lambda), Newton>);
    // "J_lin v_lin = v | kg m s^-1 m s^-1; v | kg m^2 s^-2", and the angular part
    STATIC_REQUIRE(is<Quantity<1, 2, -2>>(First::j_lin * v_lin));
    STATIC_REQUIRE(is<Quantity<1, 2, -2>>(First::j_ang * v_ang));
    STATIC_REQUIRE(is<Quantity<1, 2, -2>>(First::push));
    // Then v is no speed as in 5.2.3 and in the table of symbols.
    STATIC_REQUIRE_FALSE(can_subtract<decltype(First::push), decltype(Metre{} / dt)>);
}

TEST_CASE("section 9.2: lambda is a force, and the units close") {
    // 6.2.7, M d/dt v = J^T lambda + f_ext
    STATIC_REQUIRE(is<Newton>(mass * vdot_lin));
    STATIC_REQUIRE(is<Newton>(First::j_lin * First::lambda + f_lin));
    STATIC_REQUIRE(is<NewtonMetre>(inertia * vdot_ang));
    STATIC_REQUIRE(is<NewtonMetre>(First::j_ang * First::lambda + f_ang));
    // 12.3.1, v_2 = dt M^-1 (J^T lambda + f_ext) + v_1
    STATIC_REQUIRE(is<MetrePerSecond>(dt / mass * (First::j_lin * First::lambda + f_lin) + v_lin));
    STATIC_REQUIRE(is<PerSecond>(dt / inertia * (First::j_ang * First::lambda + f_ang) + v_ang));
    // 12.3.3, the left side: v/dt - J (v_1/dt + M^-1 f_ext)
    STATIC_REQUIRE(is<Quantity<1, 2, -3>>(First::push / dt - First::j_lin * (v_lin / dt + f_lin / mass)));
    STATIC_REQUIRE(is<Quantity<1, 2, -3>>(First::push / dt - First::j_ang * (v_ang / dt + f_ang / inertia)));
    // "J M^-1 J^T lambda: kg m s^-1, kg^-1, kg m s^-1, s^-1; kg m^2 s^-1, kg^-1 m^-2, kg m^2 s^-1, s^-1",
    // "both sides have kg m^2 s^-3"
    STATIC_REQUIRE(is<Quantity<1, 2, -3>>(First::j_lin / mass * First::j_lin * First::lambda));
    STATIC_REQUIRE(is<Quantity<1, 2, -3>>(First::j_ang / inertia * First::j_ang * First::lambda));
    STATIC_REQUIRE(closes<First>);

    // "units can be exchanged between J and lambda", as long as "v is in the same units as J v"
    STATIC_REQUIRE(closes<Unnormalised>);
    // "The constraint formulas from Section 5 are not complying": that is of 9.1 and no harm, but 5.2.1 beside
    // 5.2.3 breaks the very rule that follows it. With p_ab normalised the same text is right.
    STATIC_REQUIRE_FALSE(closes<AsPrinted>);

    // "J has no linear unit and m as angular unit, and v has the same units as" the linear velocity. 5.1 says that
    // c depends on a length in m: |p_ab| - l does, the squares of 5.2 do not.
    STATIC_REQUIRE(is<MetrePerSecond>(Last::j_lin * v_lin));
    STATIC_REQUIRE(is<MetrePerSecond>(Last::j_ang * v_ang));
    STATIC_REQUIRE(is<MetrePerSecond>(Last::push));
    STATIC_REQUIRE(is<MetrePerSecond>((Metre{} - Metre{}) / dt));
    STATIC_REQUIRE_FALSE(is<MetrePerSecond>((Metre{} * Metre{} - Metre{} * Metre{}) / dt));
    // 12.3.3 again, the left side, which is b
    STATIC_REQUIRE(is<MetrePerSecond2>(Last::push / dt - Last::j_lin * (v_lin / dt + f_lin / mass)));
    STATIC_REQUIRE(is<MetrePerSecond2>(Last::push / dt - Last::j_ang * (v_ang / dt + f_ang / inertia)));
    // "J M^-1 J^T lambda: -, kg^-1, -, m kg s^-2; m, kg^-1 m^-2, m, m kg s^-2", "both sides having m s^-2"
    STATIC_REQUIRE(is<MetrePerSecond2>(Last::j_lin / mass * Last::j_lin * Last::lambda));
    STATIC_REQUIRE(is<MetrePerSecond2>(Last::j_ang / inertia * Last::j_ang * Last::lambda));
    // so A is in 1/kg, whichever part of a row it comes from
    STATIC_REQUIRE(is<Quantity<-1, 0, 0>>(Last::j_lin / mass * Last::j_lin + Last::j_ang / inertia * Last::j_ang));
    STATIC_REQUIRE(closes<Last>);
    // "f = J^T lambda: kg m s^-2 = -, m kg s^-2; kg m^2 s^-2 = m, m kg s^-2"
    STATIC_REQUIRE(is<Newton>(Last::j_lin * Last::lambda));
    STATIC_REQUIRE(is<NewtonMetre>(Last::j_ang * Last::lambda));
    // "The units of the constraints from Section 5 are correct in this case": those of 5.3 and 5.4 are, 5.2.1's
    // not.
    STATIC_REQUIRE_FALSE(is<One>(Unnormalised::j_lin));
    STATIC_REQUIRE(is<One>(Unnormalised::j_lin / Metre{}));
    // lambda is a force as c_min and c_max are, lambda dt the impulse, and lambda^T J v the power.
    STATIC_REQUIRE(can_subtract<decltype(Last::lambda), Newton>);
    STATIC_REQUIRE(is<decltype(mass * v_lin)>(Last::lambda * dt));
    STATIC_REQUIRE(is<Watt>(Last::lambda * (Last::j_lin * v_lin)));
}

namespace {

// A bar between two boxes in units of these fractions of kilogram, metre and second.
pushfactor::tests::Frozen measured_in(double kilogram, double metre, double second) {
    const double newton = kilogram * metre / (second * second);
    std::vector<engine::Body> bodies;
    for (const double side : {-1.0, 1.0}) {
        engine::Body body =
            engine::box_body(3.0 * kilogram, metre * engine::Vector3(1, 2, 0.5), {side * metre, 0, 0});
        body.linear_momentum = kilogram * metre / second * engine::Vector3(side, 2, -1);
        body.angular_momentum = kilogram * metre * metre / second * engine::Vector3(0.5, side, 2);
        body.force = newton * engine::Vector3(0, -30, side);
        body.torque = newton * metre * engine::Vector3(side, 1, 2);
        bodies.push_back(body);
    }
    const engine::Distance bar{.body_a = 0,
                               .body_b = 1,
                               .point_a = metre * engine::Vector3(0.5, 1, 0.25),
                               .point_b = metre * engine::Vector3(-0.5, 1, -0.25),
                               .length = 1.2 * metre};
    engine::DistanceConstraints source({bar}, {engine::PushKind::persistent, 0.2}, false);
    std::vector<engine::ConstraintRow> rows = pushfactor::tests::rows_of(source, {bodies, second / 60.0});
    return {bodies, rows, second / 60.0};
}

double force_of(const pushfactor::tests::Frozen& frozen) {
    engine::Columns lambda = frozen.zero();
    engine::solvers::make_solver("dense")->solve(frozen.system, {.iterations = 1}, lambda);
    return lambda(0, 0);
}

}  // namespace

TEST_CASE("section 9.2: the engine's numbers change with the units of measurement as those of 9.2 do") {
    const auto ours = measured_in(1, 1, 1);
    const double kg = 1000, m = 100, s = 50;  // a gram, a centimetre, a fiftieth of a second
    const auto theirs = measured_in(kg, m, s);
    const auto linear = [](const auto& frozen) { return frozen.rows[0].jacobian.b.template head<3>().norm(); };
    const auto angular = [](const auto& frozen) { return frozen.rows[0].jacobian.b.template tail<3>().norm(); };

    CHECK(linear(theirs) == Approx(linear(ours)));
    CHECK(angular(theirs) == Approx(angular(ours) * m));
    CHECK(theirs.rows[0].push.lasting == Approx(ours.rows[0].push.lasting * m / s));
    CHECK(theirs.system.diagonal[0] == Approx(ours.system.diagonal[0] / kg));
    CHECK(theirs.system.b(0, 0) == Approx(ours.system.b(0, 0) * m / (s * s)));
    CHECK(force_of(theirs) == Approx(force_of(ours) * kg * m / (s * s)));
    CHECK(std::abs(force_of(ours)) > 1.0);
}

TEST_CASE("wrong sums of units do not compile") {
    STATIC_REQUIRE(can_add<Newton, Newton>);
    STATIC_REQUIRE(can_subtract<Newton, Newton>);
    STATIC_REQUIRE_FALSE(can_add<Newton, MetrePerSecond2>);
    STATIC_REQUIRE_FALSE(can_subtract<Newton, MetrePerSecond2>);
    STATIC_REQUIRE_FALSE(can_add<NewtonMetre, Newton>);
    STATIC_REQUIRE_FALSE(can_add<Newton, double>);
    STATIC_REQUIRE(can_add<decltype(Kilogram{} * MetrePerSecond2{}), Newton>);
    CHECK((Newton{3.0} + Kilogram{2.0} * MetrePerSecond2{0.5} - Newton{8.0} / One{4.0}).value == 2.0);
}
