// The factorisation against a dense one, and its plan against what fill-in must be.
#include "engine/solvers/body_matrix.h"

#include "tests/catch.h"
#include "tests/random.h"

#include <Eigen/Cholesky>

using namespace pushfactor;
using namespace pushfactor::engine;
using solvers::BodyMatrix;
using Pairs = std::vector<std::pair<int, int>>;

namespace {

std::vector<int> first(int count) {
    std::vector<int> bodies(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) bodies[static_cast<std::size_t>(i)] = i;
    return bodies;
}

Vector6 random_axis(tests::Random& random) {
    Vector6 axis;
    axis << random.vector(-1, 1), random.vector(-1, 1);
    return axis;
}

// Solves with random rows on the pairs, and returns the largest difference from a dense solution.
double difference_from_dense(int bodies, const Pairs& pairs, std::uint64_t seed) {
    tests::Random random(seed);
    BodyMatrix matrix;
    const std::vector<int> alone = first(bodies);
    matrix.connect(static_cast<std::size_t>(bodies), pairs, alone);
    matrix.set_identity();
    MatrixX dense = MatrixX::Identity(6 * bodies, 6 * bodies);
    for (int repeat = 0; repeat < 3; ++repeat) {
        for (auto [a, b] : pairs) {
            if (repeat == 1) std::swap(a, b);  // either order of the two bodies
            const Vector6 u_a = random_axis(random), u_b = random_axis(random);
            const double weight = random.in(0.1, 100.0);
            matrix.add(a, u_a, b, u_b, weight);
            VectorX u = VectorX::Zero(6 * bodies);
            u.segment<6>(6 * a) = u_a;
            u.segment<6>(6 * b) = u_b;
            dense += weight * u * u.transpose();
        }
    }
    std::vector<Vector6> x(static_cast<std::size_t>(bodies));
    VectorX right(6 * bodies);
    for (int i = 0; i < bodies; ++i) right.segment<6>(6 * i) = x[static_cast<std::size_t>(i)] = random_axis(random);
    matrix.factor();
    matrix.solve(x);
    const VectorX expected = dense.llt().solve(right);
    double largest = 0.0;
    for (int i = 0; i < bodies; ++i) {
        largest = std::max(largest, (x[static_cast<std::size_t>(i)] - expected.segment<6>(6 * i)).norm());
    }
    return largest;
}

}  // namespace

TEST_CASE("the factor solves what a dense Cholesky solves, whatever the bodies' connections") {
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
        CHECK(difference_from_dense(8, pairs, 11) < 1e-12);
    }
}

TEST_CASE("a thread, a star and any other tree fill nothing in; a ring fills in one block a body at most") {
    const auto work = [](const Pairs& pairs, int bodies) {
        BodyMatrix matrix;
        matrix.connect(static_cast<std::size_t>(bodies), pairs, first(bodies));
        return matrix.factor_work();
    };
    // 56 a diagonal block, 126 a block below and 216 a product: one of each for each connection of a tree.
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
    BodyMatrix matrix;
    const Pairs none;
    const std::vector<int> alone{1};
    matrix.connect(2, none, alone);
    CHECK(!matrix.has(0));
    matrix.set_identity();
    matrix.add(0, Vector6::Zero(), 1, Vector6::Unit(2), 3.0);
    matrix.factor();
    std::vector<Vector6> x(2, Vector6::Ones());
    matrix.solve(x);
    CHECK(x[0] == Vector6::Ones());
    CHECK(x[1][2] == Approx(0.25));
    CHECK(x[1][0] == Approx(1.0));
}
