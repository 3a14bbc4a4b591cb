// The exact solvers over families of random problems: how many are solved and at what cost, and that failures are
// reported.
#include "engine/solvers/solver.h"
#include "tests/catch.h"
#include "tests/engine/random_contacts.h"

#include <algorithm>
#include <cstdlib>

using namespace pushfactor;
using namespace pushfactor::engine;
using pushfactor::tests::Frozen;
using pushfactor::tests::RandomFriction;

namespace {

constexpr solvers::Termination to_1e10{.iterations = 1000, .tolerance_high = 1e-10, .tolerance_low = 1e-10};

// Problems per family. More with PUSHFACTOR_RANDOM_PROBLEMS=1000, as in the README.
int family_size() {
    const char* const asked = std::getenv("PUSHFACTOR_RANDOM_PROBLEMS");
    return asked ? std::max(1, std::atoi(asked)) : 150;
}

struct Answer {
    Columns lambda;
    double residual = 0.0;  // m/s
    solvers::SolveCount count;
};

Answer solve(const char* solver, const Frozen& frozen, const solvers::Termination& termination) {
    Answer answer{.lambda = frozen.zero(), .residual = 0.0, .count = {}};
    answer.count = solvers::make_solver(solver)->solve(frozen.system, termination, answer.lambda);
    answer.residual = natural_residual(frozen.system, answer.lambda);
    return answer;
}

}  // namespace

TEST_CASE("every random problem with fixed bounds is solved to 1e-10 m/s within 40 factorisations") {
    // Mass ratios to 1e6, redundant points, bounds narrower than rounding.
    int most = 0;
    double worst = 0.0;
    for (int seed = 1; seed <= family_size(); ++seed) {
        const Frozen frozen = tests::random_contacts(static_cast<std::uint64_t>(seed), RandomFriction::box, 3.0);
        const Answer answer = solve("direct", frozen, to_1e10);
        INFO("seed " << seed << ", " << frozen.rows.size() << " rows");
        CHECK(answer.residual <= 1e-10);
        CHECK(answer.count.exact);
        CHECK(answer.count.iterations <= 40);
        most = std::max(most, answer.count.iterations);
        worst = std::max(worst, answer.residual);
    }
    WARN(family_size() << " problems: at most " << most << " factorisations, residual at most " << worst << " m/s");
}

TEST_CASE("a direct solution takes the work that it is worth at most, unless it may go on once it is begun") {
    double most = 0.0, most_of_begun = 0.0;
    for (int seed = 1; seed <= 30; ++seed) {
        const Frozen frozen = tests::random_contacts(static_cast<std::uint64_t>(seed), RandomFriction::cone, 1.5);
        solvers::Termination termination = to_1e10;
        termination.iterations = 0;
        termination.worth = 3e6;
        termination.factorisations = 2.0;
        most = std::max(most, solve("auto", frozen, termination).count.multiply_adds);
        termination.at_least = 200.0;
        most_of_begun = std::max(most_of_begun, solve("auto", frozen, termination).count.multiply_adds);
    }
    CHECK(most > 3e6);
    CHECK(most < 7e6);  // seed 8 has two islands
    CHECK(most_of_begun > 1e8);
}

TEST_CASE(
    "of problems with Coulomb friction four in five are solved on the square, nine in ten on the cone, and the "
    "others are reported") {
    const RandomFriction friction = GENERATE(RandomFriction::coulomb, RandomFriction::cone);
    const bool cone = friction == RandomFriction::cone;
    int solved = 0;
    for (int seed = 1; seed <= family_size(); ++seed) {
        const Frozen frozen = tests::random_contacts(static_cast<std::uint64_t>(seed), friction, 1.5);
        const Answer answer = solve("direct", frozen, to_1e10);
        INFO("seed " << seed << ", " << frozen.rows.size() << " rows");
        if (answer.residual <= 1e-8) {
            ++solved;
            continue;
        }
        CHECK_FALSE(answer.count.exact);
        CHECK(answer.residual <= natural_residual(frozen.system, frozen.zero()));
        CHECK(answer.residual <= solve("pgs", frozen, {.iterations = 200}).residual);
    }
    CHECK(solved >= (cone ? 0.9 : 0.8) * family_size());
    WARN((cone ? "cone: " : "square: ") << solved << " of " << family_size() << " solved to 1e-8 m/s");
}
