// The factorisation against a dense one, and its plan against the expected fill-in.
#include "engine/solvers/exact/body_matrix.h"

#include "tests/catch.h"
#include "tests/dense_algebra.h"
#include "tests/random.h"

using namespace pushfactor;
using namespace pushfactor::engine;
using solvers::BodyMatrix;
using solvers::Elimination;
using Pairs = std::vector<std::pair<int, int>>;

namespace {

Vector6 random_axis(tests::Random& random) {
    Vector6 axis;
    axis << random.vector(-1, 1), random.vector(-1, 1);
    return axis;
}

// Solves with random rows on the pairs, a third of them products that are not symmetric if asked, and returns the
// largest difference from a dense solution.
double difference_from_dense(int bodies, const Pairs& pairs, bool symmetric, std::uint64_t seed) {
    tests::Random random(seed);
    Elimination order;
    order.find(bodies, pairs);
    BodyMatrix matrix;
    matrix.begin(order);
    MatrixX dense = MatrixX::Identity(6 * bodies, 6 * bodies);
    const auto stacked_at = [&](int a, const Vector6& u_a, int b, const Vector6& u_b) {
        VectorX u = VectorX::Zero(6 * bodies);
        u.segment<6>(6 * a) = u_a;
        u.segment<6>(6 * b) = u_b;
        return u;
    };
    for (int repeat = 0; repeat < 3; ++repeat) {
        for (auto [a, b] : pairs) {
            if (repeat == 1) std::swap(a, b);  // either order of the two bodies
            const Vector6 u_a = random_axis(random), u_b = random_axis(random);
            const double weight = random.in(0.1, 100.0);
            matrix.add(a, u_a, b, u_b, weight);
            const VectorX u = stacked_at(a, u_a, b, u_b);
            dense += weight * u * u.transpose();
            if (symmetric || repeat == 2) continue;
            const Vector6 v_a = random_axis(random), v_b = random_axis(random);
            matrix.add_product(a, v_a / weight, u_a, b, v_b / weight, u_b, weight);
            dense += stacked_at(a, v_a, b, v_b) * u.transpose();
        }
    }
    std::vector<Vector6> x(static_cast<std::size_t>(bodies));
    VectorX right(6 * bodies);
    for (int i = 0; i < bodies; ++i) right.segment<6>(6 * i) = x[static_cast<std::size_t>(i)] = random_axis(random);
    matrix.factor();
    matrix.solve(x);
    const VectorX expected = tests::solution(dense, right);
    double largest = 0.0;
    for (int i = 0; i < bodies; ++i) {
        largest = std::max(largest, (x[static_cast<std::size_t>(i)] - expected.segment<6>(6 * i)).norm());
    }
    return largest;
}

}  // namespace

TEST_CASE("the factors solve what dense ones solve, symmetric or not, whatever the bodies' connections") {
    Pairs ring, star, all, mixed;
    tests::Random random(3);
    for (int i = 0; i < 8; ++i) {
        ring.push_back({i, (i + 1) % 8});
        if (i > 0) star.push_back({0, i});
        for (int j = 0; j < i; ++j) {
            all.push_back({j, i});
            if (random.in(0, 1) < 0.3) mixed.push_back({j, i});
        }
    }
    for (const Pairs& pairs : {Pairs{}, Pairs{{2, 5}}, ring, star, all, mixed}) {
        CHECK(difference_from_dense(8, pairs, true, 11) < 1e-12);
        CHECK(difference_from_dense(8, pairs, false, 11) < 1e-11);
    }
}

TEST_CASE("a thread, a star and any other tree fill nothing in, a ring fills in one block per body at most") {
    const auto work = [](const Pairs& pairs, int bodies) {
        Elimination order;
        order.find(bodies, pairs);
        return order.symmetric_work();
    };
    // 56 per diagonal block, 126 per block below and 216 per product: one of each for each connection of a tree.
    const auto tree = [](int bodies) { return 56.0 * bodies + (126.0 + 216.0) * (bodies - 1); };
    Pairs thread, star, ring;
    for (int i = 1; i < 30; ++i) {
        thread.push_back({i - 1, i});
        star.push_back({0, i});
    }
    CHECK(work(thread, 30) == tree(30));
    CHECK(work(star, 30) == tree(30));
    ring = thread;
    ring.push_back({0, 29});
    CHECK(work(ring, 30) < 3.0 * tree(30));
}

TEST_CASE("a body that cannot move has no block, and rows on it act on the other body alone") {
    Elimination order;
    order.find(1, {});
    CHECK(order.node_of(0) == 0);
    CHECK(order.node_of(1) == -1);
    BodyMatrix matrix;
    matrix.begin(order);
    matrix.add(1, Vector6::Zero(), 0, Vector6::Unit(2), 3.0);
    matrix.factor();
    std::vector<Vector6> x(2, Vector6::Ones());
    matrix.solve(x);
    CHECK(x[1] == Vector6::Ones());
    CHECK(x[0][2] == Approx(0.25));
    CHECK(x[0][0] == Approx(1.0));
}
