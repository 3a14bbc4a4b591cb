// Islands: compared with a graph search and with the matrix A, and solved one by one compared with all at once.
#include "engine/system/islands.h"

#include "engine/solvers/solver.h"
#include "tests/catch.h"
#include "tests/engine/contact_scene.h"
#include "tests/engine/random_rows.h"
#include "tests/engine/solvers/problems.h"

#include <map>
#include <set>

using namespace pushfactor;
using namespace pushfactor::engine;
using pushfactor::tests::Frozen;
using pushfactor::tests::Random;

namespace {

constexpr double dt = 1.0 / 60.0;

// Rows between random pairs of `count` bodies, every third of which is static. Some come in runs, some aim at two
// speeds, some are bounded by another row.
Frozen random_graph(std::uint64_t seed, int count, int pairs) {
    Random random(seed);
    std::vector<Body> bodies;
    for (int i = 0; i < count; ++i) {
        bodies.push_back(i % 3 == 0 ? static_body(random.vector(-3, 3))
                                    : box_body(1.0, Vector3::Ones(), random.vector(-3, 3), random.rotation()));
    }
    std::vector<ConstraintRow> rows;
    for (int p = 0; p < pairs; ++p) {
        const int a = static_cast<int>(random.in(0, count)), b = static_cast<int>(random.in(0, count));
        for (int k = static_cast<int>(random.in(1, 4)); k > 0 && a != b; --k) {
            ConstraintRow& row = rows.emplace_back();
            row.body_a = a;
            row.body_b = b;
            for (Vector6* axis : {&row.jacobian.a, &row.jacobian.b}) {
                axis->head<3>() = random.vector(-1, 1);
                axis->tail<3>() = random.vector(-1, 1);
            }
            row.push.lasting = random.in(-1, 1);
            if (random.in(0, 1) < 0.1) row.push.correcting = 0.5;
            if (rows.size() > 1 && random.in(0, 1) < 0.05) {
                row.bounds = {-0.5, 0.5, static_cast<int>(random.in(0, static_cast<double>(rows.size() - 1)))};
            }
        }
    }
    return {bodies, rows, dt};
}

bool moves(const Frozen& frozen, int body) {
    return frozen.system.inverse_mass[static_cast<std::size_t>(body)].linear > 0.0;
}

// The movable bodies of each island, by propagating labels from row to row until nothing changes.
std::set<std::set<int>> by_spreading(const Frozen& frozen) {
    std::map<int, int> number;
    for (const ConstraintRow& row : frozen.rows) {
        for (const int body : {row.body_a, row.body_b}) {
            if (moves(frozen, body)) number[body] = body;
        }
    }
    for (bool changed = true; changed;) {
        changed = false;
        const auto spread = [&](std::initializer_list<int> bodies) {
            int least = std::numeric_limits<int>::max();
            for (const int body : bodies) {
                if (moves(frozen, body)) least = std::min(least, number[body]);
            }
            for (const int body : bodies) {
                if (!moves(frozen, body) || number[body] == least) continue;
                number[body] = least;
                changed = true;
            }
        };
        for (const ConstraintRow& row : frozen.rows) {
            const bool acts = moves(frozen, row.body_a) || moves(frozen, row.body_b);
            spread({row.body_a, row.body_b});
            if (row.bounds.of_row < 0 || !acts) continue;
            const ConstraintRow& leader = frozen.rows[static_cast<std::size_t>(row.bounds.of_row)];
            spread({row.body_a, row.body_b, leader.body_a, leader.body_b});
        }
    }
    std::map<int, std::set<int>> islands;
    for (const auto& [body, island] : number) islands[island].insert(body);
    std::set<std::set<int>> all;
    for (const auto& [first, bodies] : islands) all.insert(bodies);
    return all;
}

// All data of the islands, to compare.
std::string text_of(const Islands& islands) {
    std::string text;
    for (const Island& island : islands.all()) {
        text +=
            "island of " + std::to_string(island.body_count) + ", columns " + std::to_string(island.columns) + ":";
        for (const int body : island.bodies) text += " " + std::to_string(body);
        for (const RowRun& run : island.runs) {
            for (const int number : {run.begin, run.end, run.first, run.a, run.b})
                text += "," + std::to_string(number);
        }
        text += "\n";
    }
    return text;
}

std::string islands_of(const SystemEquation& system) {
    Islands islands;
    islands.find(system);
    return text_of(islands);
}

}  // namespace

TEST_CASE("islands are what a search from row to row finds, and static bodies join nothing") {
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        const Frozen frozen = random_graph(seed, 40, static_cast<int>(seed % 40));
        Islands islands;
        islands.find(frozen.system);
        std::set<std::set<int>> found;
        for (const Island& island : islands.all()) found.insert({island.bodies.begin(), island.bodies.end()});
        INFO("seed " << seed);
        CHECK(found.size() == islands.all().size());
        CHECK(found == by_spreading(frozen));
    }
}

TEST_CASE("rows and bodies keep their order in an island, and every row is in the island of its bodies") {
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        INFO("seed " << seed);
        const Frozen frozen = random_graph(seed, 40, static_cast<int>(seed % 60));
        Islands islands;
        islands.find(frozen.system);
        std::set<int> rows;
        for (const Island& island : islands.all()) {
            CHECK(std::is_sorted(island.bodies.begin(), island.bodies.end()));
            std::map<int, int> number;  // in the island, of a body of the world
            for (int k = 0; k < island.movable(); ++k) number[island.bodies[static_cast<std::size_t>(k)]] = k;
            int next = 0;
            for (const RowRun& run : island.runs) {
                CHECK(run.first == next);
                for (int j = run.begin; j < run.end; ++j, ++next) {
                    const ConstraintRow& row = frozen.rows[static_cast<std::size_t>(j)];
                    CHECK((rows.empty() || rows.insert(j).second));
                    rows.insert(j);
                    CHECK(island.number_of(j) == next);
                    for (const auto& [body, said] : {std::pair{row.body_a, run.a}, std::pair{row.body_b, run.b}}) {
                        const auto [known, is_new] = number.try_emplace(body, static_cast<int>(number.size()));
                        CHECK(known->second == said);
                        CHECK((said < island.movable()) == moves(frozen, body));
                    }
                }
            }
            CHECK(next == island.rows);
            CHECK(static_cast<int>(number.size()) == island.body_count);
        }
        for (int j = 0; j < static_cast<int>(frozen.rows.size()); ++j) {
            const ConstraintRow& row = frozen.rows[static_cast<std::size_t>(j)];
            CHECK(rows.contains(j) == (moves(frozen, row.body_a) || moves(frozen, row.body_b)));
        }
        CHECK(islands.hold_all_rows() == (rows.size() == frozen.rows.size()));
    }
}

TEST_CASE("found again they are what they would be if they were new, whether rows come, go or change") {
    Islands islands;
    Random random(3);
    for (int step = 0; step < 300; ++step) {
        // Every other time the same again.
        const Frozen frozen = random_graph(1 + static_cast<std::uint64_t>(step) / 2, 30,
                                           static_cast<int>(random.in(0, step % 2 == 0 ? 30 : 25)));
        islands.find(frozen.system);
        REQUIRE(text_of(islands) == islands_of(frozen.system));
        // And with more rows behind these.
        std::vector<ConstraintRow> more = frozen.rows;
        for (int k = 0; k < 3 && !frozen.rows.empty(); ++k) {
            ConstraintRow& row = more.emplace_back(frozen.rows[static_cast<std::size_t>(k) % frozen.rows.size()]);
            row.body_a = static_cast<int>(random.in(0, 30));
            if (row.body_a == row.body_b) more.pop_back();
        }
        SystemEquation longer = frozen.system;
        extend_system(more, longer);
        if (!frozen.rows.empty()) islands.find(longer);
        if (!frozen.rows.empty()) REQUIRE(text_of(islands) == islands_of(longer));
    }
}

TEST_CASE("a body that is made static, or movable again, parts and joins islands") {
    Frozen frozen = random_graph(11, 30, 25);
    Islands islands;
    for (std::size_t body = 0; body < 30; ++body) {
        const InverseMass before = frozen.system.inverse_mass[body];
        for (const InverseMass& inverse_mass : {InverseMass{}, InverseMass{.linear = 1.0}, before}) {
            frozen.system.inverse_mass[body] = inverse_mass;
            islands.find(frozen.system);
            REQUIRE(text_of(islands) == islands_of(frozen.system));
        }
    }
}

TEST_CASE("ordered by island, A is block diagonal: outside of the blocks all is zero") {
    const Frozen frozen = random_graph(7, 40, 25);
    const MatrixX A = tests::dense_matrix(frozen.system);
    Islands islands;
    islands.find(frozen.system);
    REQUIRE(islands.all().size() > 3);
    std::vector<int> island_of_row(frozen.rows.size(), -1);
    for (std::size_t k = 0; k < islands.all().size(); ++k) {
        for (const RowRun& run : islands.all()[k].runs) {
            for (int j = run.begin; j < run.end; ++j)
                island_of_row[static_cast<std::size_t>(j)] = static_cast<int>(k);
        }
    }
    int outside = 0;
    for (Eigen::Index i = 0; i < A.rows(); ++i) {
        for (Eigen::Index j = 0; j < A.cols(); ++j) {
            if (island_of_row[static_cast<std::size_t>(i)] == island_of_row[static_cast<std::size_t>(j)]) continue;
            CHECK(A(i, j) == 0.0);
            ++outside;
        }
    }
    CHECK(outside > 100);
}

TEST_CASE("the residual of the system is the largest of its islands, and so are forces the same, part by part") {
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
        const Frozen frozen = random_graph(seed, 30, 20);
        Columns lambda = frozen.zero();
        Random random(seed);
        for (Eigen::Index j = 0; j < lambda.rows(); ++j) {
            for (Eigen::Index c = 0; c < lambda.cols(); ++c) lambda(j, c) = random.in(-10, 10);
        }
        Islands islands;
        islands.find(frozen.system);
        double largest = 0.0;
        for (const Island& island : islands.all()) {
            // Both columns count in an island with one.
            if (island.columns < lambda.cols()) {
                for (const RowRun& run : island.runs) {
                    for (int j = run.begin; j < run.end; ++j) lambda(j, 1) = lambda(j, 0);
                }
            }
        }
        for (const Island& island : islands.all()) {
            largest = std::max(largest, island_residual(frozen.system, island, lambda));
        }
        CHECK(natural_residual(frozen.system, lambda) == largest);
        std::vector<Vector6> whole, parts;
        constraint_forces(frozen.system, lambda, 0, whole);
        parts.assign(whole.size(), Vector6::Constant(1e9));
        for (const Island& island : islands.all()) constraint_forces(frozen.system, island, lambda, 0, parts);
        for (const Island& island : islands.all()) {
            for (const int body : island.bodies) {
                CHECK(whole[static_cast<std::size_t>(body)] == parts[static_cast<std::size_t>(body)]);
            }
        }
    }
}

// Several problems merged into one, with interleaved rows.
TEST_CASE("every solver gives each of several problems in one system the answer that it has alone, bit for bit") {
    std::vector<tests::Problem> parts;
    parts.push_back(tests::column_problem(5));
    parts.push_back(tests::chain_problem(6));
    parts.push_back(tests::tower_problem("towers", 3, 0.2, tests::weight_friction(), tests::single_frame));
    parts.push_back(
        tests::tower_problem("persistent", 2, 0.0, pushfactor::engine::coulomb_friction, tests::persistent));
    parts.push_back(tests::gutter_problem(pushfactor::engine::coulomb_friction));

    std::vector<Body> bodies;
    std::vector<ConstraintRow> rows;
    std::vector<std::vector<int>> places(parts.size());  // of each part's rows
    std::vector<int> first_body;
    for (const tests::Problem& part : parts) {
        first_body.push_back(static_cast<int>(bodies.size()));
        bodies.insert(bodies.end(), part.bodies.begin(), part.bodies.end());
    }
    // Row by row from each in turn.
    for (std::size_t j = 0, left = parts.size(); left > 0; ++j) {
        left = 0;
        for (std::size_t p = 0; p < parts.size(); ++p) {
            if (j >= parts[p].rows.size()) continue;
            ++left;
            ConstraintRow row = parts[p].rows[j];
            row.body_a += first_body[p];
            row.body_b += first_body[p];
            if (row.bounds.of_row >= 0) row.bounds.of_row = places[p][static_cast<std::size_t>(row.bounds.of_row)];
            places[p].push_back(static_cast<int>(rows.size()));
            rows.push_back(row);
        }
    }
    const Frozen together(bodies, rows, tests::problem_dt);
    REQUIRE(together.system.column_count() == 2);
    for (const solvers::SolverEntry& entry : solvers::solver_table()) {
        for (const double tolerance : {0.0, 1e-9}) {
            const solvers::Termination termination{
                .iterations = 30, .tolerance_high = tolerance, .tolerance_low = tolerance};
            const Columns all = tests::solve(entry.name.data(), together.system, together.zero(), termination);
            for (std::size_t p = 0; p < parts.size(); ++p) {
                const Frozen frozen = parts[p].frozen();
                const Columns own = tests::solve(entry.name.data(), frozen.system, frozen.zero(), termination);
                INFO(entry.name << ", " << parts[p].name << ", tolerance " << tolerance);
                bool equal = true;
                for (std::size_t j = 0; j < places[p].size(); ++j) {
                    for (Eigen::Index c = 0; c < 2; ++c) {
                        const Eigen::Index own_column = std::min(c, own.cols() - 1);
                        equal = equal && all(places[p][j], c) == own(static_cast<Eigen::Index>(j), own_column);
                    }
                }
                CHECK(equal);
            }
        }
    }
}

namespace {

// Records what it is asked to solve.
class Spy : public solvers::Solver {
  public:
    struct Call {
        std::vector<int> bodies;
        int rows = 0;
        Columns before, after;
    };
    explicit Spy(std::vector<Call>& calls) : calls_(calls) {}

    using Solver::solve;
    solvers::SolveCount solve(const SystemEquation& system, const Island& island,
                              const solvers::Termination& termination, Columns& lambda) override {
        Call call{{island.bodies.begin(), island.bodies.end()}, island.rows, lambda, {}};
        const solvers::SolveCount count = solver_->solve(system, island, termination, lambda);
        call.after = lambda;
        calls_.push_back(call);
        return count;
    }

  private:
    std::unique_ptr<solvers::Solver> solver_ = solvers::make_solver("auto");
    std::vector<Call>& calls_;
};

}  // namespace

TEST_CASE("looking again solves only the islands it concerns, from the answer just found") {
    tests::ContactScene scene;
    scene.add_ground();
    // A tower, and far from it three balls of which the first flies into the second, which then hits the third.
    for (int i = 0; i < 3; ++i) scene.add_box(Vector3::Ones(), {-50, 0.5 + i, 0}, Vector3::Zero());
    const tests::Surface smooth{.friction = 0.0};
    scene.add_ball(0.5, {0, 5, 0}, {90, 0, 0}, smooth);
    scene.add_ball(0.5, {1.5, 5, 0}, Vector3::Zero(), smooth);
    scene.add_ball(0.5, {2.6, 5, 0}, Vector3::Zero(), smooth);
    scene.build();
    std::vector<Spy::Call> calls;
    scene.world.solver = std::make_unique<Spy>(calls);
    scene.world.step(dt);
    REQUIRE(calls.size() >= 3);
    // First the tower and the pair that meets, then the three balls, and never the tower again.
    const std::vector<int> tower{1, 2, 3}, pair{4, 5}, three{4, 5, 6};
    CHECK(calls[0].bodies == tower);
    CHECK(calls[1].bodies == pair);
    for (std::size_t k = 2; k < calls.size(); ++k) CHECK(calls[k].bodies == three);
    // The rows of the first round start from its results.
    const Eigen::Index known = calls[1].after.rows();
    CHECK(calls[2].before.rows() > known);
    CHECK(calls[2].before.topRows(known) == calls[1].after);
    CHECK(calls[1].after.cwiseAbs().maxCoeff() > 1.0);
    CHECK(velocity(scene.world.bodies[6]).x() > 10.0);
}
