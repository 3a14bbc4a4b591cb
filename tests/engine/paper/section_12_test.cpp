// Paper section 12, the appendix, in numbers. The names go by the sections and equations of the text; 12.4.1 is the
// number of the equation in 12.4, and the derivative and its limit are section 12.5.
//
// Symbols: J all rows as one c x 6n matrix (6.1.2), M^-1 system inverse mass, v_1 and v_2 system velocities before
// and after the step, f_ext external forces, v push factors, lambda, A and b of 6.2.9; q orientation, w angular
// velocity.
#include "engine/bodies/integrator.h"
#include "engine/constraints/contact_constraints.h"
#include "engine/constraints/distance_constraints.h"
#include "engine/solvers/solver.h"
#include "tests/catch.h"
#include "tests/dense_algebra.h"
#include "tests/engine/paper/whole_system.h"
#include "tests/engine/rows.h"
#include "tests/random.h"

#include <cmath>
#include <numbers>

using namespace pushfactor::engine;
using namespace pushfactor::tests;

namespace {

constexpr double dt = Whole::dt;

const Correction no_push{PushKind::none, 0.0};
const Correction persistent{PushKind::persistent, 0.2};

VectorX random_numbers(Random& random, Eigen::Index count) {
    VectorX numbers(count);
    for (double& number : numbers) number = random.in(-10, 10);
    return numbers;
}

// |difference| relative to the larger of both.
double relative_error(const MatrixX& value, const MatrixX& expected) {
    return (value - expected).norm() / std::max(value.norm(), expected.norm());
}

}  // namespace

TEST_CASE("12.1: the derivative of a length is along it") {
    // The text derives the squared length, in the plane; it holds in any number of dimensions.
    Random random(121);
    for (const Eigen::Index dimensions : {2, 3, 12}) {
        const VectorX v = random_numbers(random, dimensions), rate = random_numbers(random, dimensions);
        const auto squared = [&](double t) { return (v + t * rate).squaredNorm(); };
        // For a square the central difference is exact.
        CHECK((squared(0.5) - squared(-0.5)) / 1.0 == Approx(2.0 * v.dot(rate)).epsilon(1e-13));
        // What is across v does not change the length.
        const VectorX across = rate - v * (v.dot(rate) / v.squaredNorm());
        CHECK((v + 1e-4 * across).norm() == Approx(v.norm()).epsilon(1e-7));
    }

    // The bar's length error is a length less a constant: its rate is the part along the bar, not twice that.
    const Vector3 p_ab(1, 2, -2), rate(0.3, -0.5, 0.7);
    const auto error = [&](double t) {
        const std::vector<Body> bodies{static_body(Vector3::Zero()), ball_body(1.0, 0.1, p_ab + t * rate)};
        std::vector<ConstraintRow> rows = pushfactor::tests::rows_of(
            DistanceConstraints({{.body_a = 0, .body_b = 1}}, persistent, false), {bodies, dt});
        return rows[0].label.gap;
    };
    const double h = 1e-4;
    CHECK((error(h) - error(-h)) / (2.0 * h) == Approx(p_ab.dot(rate) / p_ab.norm()).epsilon(1e-7));
}

TEST_CASE("12.2: products with J are those of Figure 11") {
    // A ball of 2 kg in a V of two planes, 30 and 50 degrees steep.
    const double angle_a = 30.0 * std::numbers::pi / 180.0, angle_b = 50.0 * std::numbers::pi / 180.0;
    const Vector3 a(std::sin(angle_a), std::cos(angle_a), 0), b(-std::sin(angle_b), std::cos(angle_b), 0);
    const auto plane = [](const Vector3& normal) {
        return static_body(Vector3::Zero(), rotation_between(Vector3::UnitY(), normal));
    };
    // At r from both planes: a x = b x = r.
    Eigen::Matrix2d normals;
    normals << a.head<2>().transpose(), b.head<2>().transpose();
    const Eigen::Vector2d centre = solution(normals, Eigen::Vector2d(0.5, 0.5));
    std::vector<Body> bodies{plane(a), plane(b), ball_body(2.0, 0.5, {centre.x(), centre.y(), 0})};
    bodies[2].force = {0, -20, 0};
    ContactConstraints stage({{.body = 0, .shape = collision::Plane{}},
                              {.body = 1, .shape = collision::Plane{}},
                              {.body = 2, .shape = collision::Sphere{0.5}}},
                             {.correction = no_push, .slop = 0.0, .detection = {.margin = 0.01}});
    std::vector<ConstraintRow> rows = pushfactor::tests::rows_of(stage, {bodies, dt});
    REQUIRE(rows.size() == 2);

    // J = [a; b] for the one body that moves and no rotation.
    const Whole whole(bodies, rows);
    const MatrixX J = whole.J.middleCols(12, 3);
    CHECK((J.row(0).transpose() - a).norm() < 1e-15);
    CHECK((J.row(1).transpose() - b).norm() < 1e-15);
    CHECK(whole.J.leftCols(12).isZero(0.0));
    // Normals through the centre do not turn the ball.
    CHECK(whole.J.rightCols(3).norm() < 1e-15);
    // 12.2.1
    const Vector3 v(0.3, -0.7, 1.1);
    CHECK((J * v)[0] == Approx(a.dot(v)));
    CHECK((J * v)[1] == Approx(b.dot(v)));
    // 12.2.2. The text has a_y l1 + b_z l2 for its second entry and no third one.
    const Frozen frozen(bodies, rows, dt);
    Columns lambda(2, 1);
    lambda << 7.0, 11.0;
    std::vector<Vector6> forces;
    constraint_forces(frozen.system, lambda, 0, forces);
    CHECK((forces[2].head<3>() - (7.0 * a + 11.0 * b)).norm() < 1e-14);
    // At rest the two carry the weight: the law of sines in the triangle of forces.
    const VectorX resting = solution(whole.A(), whole.b());
    CHECK(resting[0] == Approx(20.0 * std::sin(angle_b) / std::sin(angle_a + angle_b)));
    CHECK(resting[1] == Approx(20.0 * std::sin(angle_a) / std::sin(angle_a + angle_b)));
}

TEST_CASE("12.2: the products of whole rows are those of whole matrices, for many bodies") {
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
        const HangingBoxes boxes(8, persistent, seed);
        const Whole whole(boxes.bodies, boxes.rows);
        const Frozen frozen(boxes.bodies, boxes.rows, dt);
        const SystemEquation& system = frozen.system;
        // c x 6n; with the 6n x c of 6.1.2 J v would not exist.
        REQUIRE(whole.J.rows() == 7);
        REQUIRE(whole.J.cols() == 48);

        Random random(seed);
        const VectorX lambda = random_numbers(random, 7);
        std::vector<Vector6> forces;
        constraint_forces(system, lambda, 0, forces);
        VectorX by_rows = VectorX::Zero(48);
        for (Eigen::Index i = 0; i < 7; ++i) by_rows += whole.J.row(i).transpose() * lambda[i];  // 12.2.2
        for (Eigen::Index body = 0; body < 8; ++body) {
            const Vector6& force = forces[static_cast<std::size_t>(body)];
            REQUIRE((force - by_rows.segment<6>(6 * body)).norm() < 1e-13);
            REQUIRE((force - (whole.J.transpose() * lambda).segment<6>(6 * body)).norm() < 1e-13);
        }

        const MatrixX A = whole.A();
        CHECK(relative_error(system.diagonal, A.diagonal()) < 1e-14);
        CHECK(relative_error(system.b, whole.b()) < 1e-14);
        // All of A is in the rows of unit length: A_ij = s_i u_i . u_j s_j. Rows without a body in common: zero.
        MatrixX from_rows = MatrixX::Zero(7, 7);
        for (std::size_t i = 0; i < 7; ++i) {
            for (std::size_t j = 0; j < 7; ++j) {
                const auto half = [&](std::size_t row, int body) -> Vector6 {
                    const auto index = static_cast<Eigen::Index>(row);
                    const Jacobian unit = unit_axis(system, system.rows[static_cast<std::size_t>(index)],
                                                    std::sqrt(system.diagonal[index]));
                    if (boxes.rows[row].body_a == body) return unit.a;
                    if (boxes.rows[row].body_b == body) return unit.b;
                    return Vector6::Zero();
                };
                double product = 0.0;
                for (int body = 0; body < 8; ++body) product += half(i, body).dot(half(j, body));
                const auto row = static_cast<Eigen::Index>(i), column = static_cast<Eigen::Index>(j);
                from_rows(row, column) =
                    std::sqrt(system.diagonal[row]) * product * std::sqrt(system.diagonal[column]);
            }
        }
        CHECK(relative_error(from_rows, A) < 1e-14);
        CHECK(A(0, 2) == 0.0);
        CHECK(A(0, 1) != 0.0);
    }
}

namespace {

// The system velocity (6.1.1) after 3.2.1 and 3.2.2 with the constraint forces of `lambda`, from the momenta.
VectorX velocity_after_step(const SystemEquation& system, std::vector<Body> bodies, const VectorX& lambda) {
    std::vector<Vector6> f_c;
    constraint_forces(system, lambda, 0, f_c);
    VectorX v2(6 * bodies.size());
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        Body& body = bodies[i];
        body.linear_momentum = advance_momentum(body.linear_momentum, body.force + f_c[i].head<3>(), dt);
        body.angular_momentum = advance_momentum(body.angular_momentum, body.torque + f_c[i].tail<3>(), dt);
        v2.segment<6>(6 * static_cast<Eigen::Index>(i)) = stacked(velocity(body), angular_velocity(body));
    }
    return v2;
}

}  // namespace

TEST_CASE("12.3: v2 from momenta satisfies 6.2.2, both ways") {
    for (const std::uint64_t seed : {4u, 5u, 6u}) {
        const HangingBoxes boxes(6, no_push, seed);
        const Whole whole(boxes.bodies, boxes.rows);
        const MatrixX& J = whole.J;
        const Frozen frozen(boxes.bodies, boxes.rows, dt);
        const VectorX lambda = solution(whole.A(), whole.b());
        const VectorX v2 = velocity_after_step(frozen.system, boxes.bodies, lambda);
        CHECK((J * v2).norm() < 1e-13);
        CHECK((J * whole.v1).norm() > 0.1);

        // Any multiplier does no work on v2, not only lambda, so that 6.2.2 cannot be solved for it.
        Random random(seed);
        for (const VectorX& any : {lambda, random_numbers(random, lambda.size())}) {
            // 6.2.3, by the transpose
            CHECK((J.transpose() * any).dot(v2) == Approx(0.0).margin(1e-11));
            // 12.3, by sums in either order
            double by_bodies = 0.0, by_rows = 0.0;
            for (Eigen::Index j = 0; j < J.cols(); ++j) {
                for (Eigen::Index i = 0; i < J.rows(); ++i) by_bodies += J(i, j) * any[i] * v2[j];
            }
            for (Eigen::Index i = 0; i < J.rows(); ++i) {
                for (Eigen::Index j = 0; j < J.cols(); ++j) by_rows += J(i, j) * v2[j] * any[i];
            }
            CHECK(by_bodies == Approx(0.0).margin(1e-11));
            CHECK(by_rows == Approx(0.0).margin(1e-11));
        }
        // Work is done on the velocity before the step.
        CHECK(std::abs(lambda.dot(J * whole.v1)) > 1.0);
    }
}

TEST_CASE("12.3: 6.2.2 is for rows without push and not at a bound") {
    // With a push J v2 = v, and the power is lambda^T v.
    const HangingBoxes boxes(6, persistent, 4);
    const Whole whole(boxes.bodies, boxes.rows);
    const Frozen frozen(boxes.bodies, boxes.rows, dt);
    const VectorX lambda = solution(whole.A(), whole.b());
    const VectorX v2 = velocity_after_step(frozen.system, boxes.bodies, lambda);
    CHECK((whole.J.transpose() * lambda).dot(v2) == Approx(lambda.dot(whole.push)));
    CHECK(std::abs(lambda.dot(whole.push)) > 1.0);

    // Friction at its bound takes energy: 1 N against 2 m/s less what it has taken already.
    std::vector<Body> sliding{static_body(Vector3::Zero()), ball_body(0.5, 0.1, {0, 0.1, 0})};
    sliding[1].linear_momentum = {1, 0, 0};
    std::vector<ConstraintRow> rows;
    const PairPoint at_centre({0, 1, sliding[0], sliding[1]}, sliding[1].position);
    write_friction_row(at_centre, Vector3::UnitX(), {.c_min = -1.0, .c_max = 1.0}, 0.0, rows.emplace_back());
    const Frozen slides(sliding, rows, dt);
    Columns bounded = slides.zero();
    solvers::make_solver("pgs")->solve(slides.system, {.iterations = 5}, bounded);
    const Whole clamped(sliding, rows);
    const VectorX after = velocity_after_step(slides.system, sliding, bounded.col(0));
    CHECK((clamped.J.transpose() * bounded).col(0).dot(after) == Approx(-(2.0 - dt / 0.5)));
}

TEST_CASE("12.3.1: the second derivation gives the same lambda") {
    const HangingBoxes boxes(5, persistent, 7);
    const Whole whole(boxes.bodies, boxes.rows);
    const MatrixX &J = whole.J, M = inverse(whole.inverse_mass);
    const Eigen::Index rows = J.rows(), columns = J.cols();
    const VectorX lambda = solution(whole.A(), whole.b());  // 6.2.9

    // 12.3.1 and J v2 = v (12.3.2) together, solved for v2 and lambda at once: no inverse of J is needed.
    MatrixX both = MatrixX::Zero(columns + rows, columns + rows);
    both << M, -dt * J.transpose(), J, MatrixX::Zero(rows, rows);
    VectorX right(columns + rows);
    right << M * whole.v1 + dt * whole.f_ext, whole.push;
    const VectorX solved = solution(both, right);
    CHECK(relative_error(solved.tail(rows), lambda) < 1e-12);
    CHECK(relative_error(solved.head(columns), whole.v2(lambda)) < 1e-12);

    // J has fewer rows than columns, so no inverse, but many K with J K = 1. With any of them in the place of
    // J^-1 the second line of 12.3.2 and all that follows is wrong, up to the multiplication by J in front, which
    // asks of K no more than J K = 1: what it leaves is 6.2.9.
    REQUIRE(rows < columns);
    const MatrixX shortest = product(J.transpose(), inverse(product(J, J.transpose())));
    const MatrixX lightest = product(product(whole.inverse_mass, J.transpose()), inverse(whole.A()));
    CHECK(relative_error(shortest, lightest) > 0.1);
    for (const MatrixX& K : {shortest, lightest}) {
        CHECK(relative_error(product(J, K), MatrixX::Identity(rows, rows)) < 1e-12);
        CHECK(relative_error(product(K, J), MatrixX::Identity(columns, columns)) > 0.1);
        CHECK(relative_error(K * whole.push, whole.v2(lambda)) > 0.1);
        const VectorX acceleration = (K * whole.push - whole.v1) / dt - whole.inverse_mass * whole.f_ext;
        CHECK(relative_error(acceleration, whole.inverse_mass * (J.transpose() * lambda)) > 0.1);
        CHECK(relative_error(J * acceleration, whole.A() * lambda) < 1e-12);
        CHECK(relative_error(J * acceleration, whole.b()) < 1e-12);
    }
}

TEST_CASE("12.3.1: with rows that stand twice there is no K with J K = 1, but the forces are the same") {
    const HangingBoxes boxes(5, persistent, 8);
    std::vector<ConstraintRow> twice = boxes.rows;
    twice.insert(twice.end(), boxes.rows.begin(), boxes.rows.end());
    const Whole once(boxes.bodies, boxes.rows), doubled(boxes.bodies, twice);
    CHECK(doubled.J.rows() == 8);
    CHECK(rank(doubled.J) == 4);

    const VectorX lambda = solution(once.A(), once.b());
    const VectorX shared = pseudo_inverse(doubled.A()) * doubled.b();
    VectorX lopsided = VectorX::Zero(8);
    lopsided << 3.0 * lambda, -2.0 * lambda;
    for (const VectorX& answer : {shared, lopsided}) {
        CHECK(relative_error(doubled.A() * answer, doubled.b()) < 1e-12);
        CHECK(relative_error(doubled.J.transpose() * answer, once.J.transpose() * lambda) < 1e-12);
    }
    CHECK(relative_error(shared, lopsided) > 0.1);
}
