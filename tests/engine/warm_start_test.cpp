// What an island remembers from step to step, and what it makes of it.
#include "engine/warm_start.h"

#include "tests/catch.h"
#include "tests/engine/solvers/problems.h"

using namespace pushfactor;
using namespace pushfactor::engine;
using Memory = WarmStart::Memory;
using Method = WarmStart::Method;

namespace {

constexpr solvers::SolveCount kept{};
constexpr solvers::SolveCount swept{.iterations = 5};
constexpr solvers::SolveCount exact{.iterations = 1, .exact = true};
constexpr solvers::SolveCount contradicting{.iterations = 9, .exact = true, .residual = 1.0};
constexpr solvers::Termination usual{.iterations = 25, .tolerance_high = 1e-6, .tolerance_low = 1e-8};

// Islands by their bodies alone.
struct Group {
    explicit Group(std::vector<int> some) : bodies(std::move(some)) { island.bodies = bodies; }
    std::vector<int> bodies;
    Island island;
};

void step(WarmStart& warm_start, std::initializer_list<std::pair<const Group*, solvers::SolveCount>> solves) {
    warm_start.begin(6);
    for (const auto& [group, count] : solves) {
        warm_start.solved(group->island, warm_start.memory_of(group->island), count);
    }
    warm_start.end();
}

double share(WarmStart& warm_start, const Group& group, const solvers::SolveCount& count) {
    warm_start.begin(6);
    warm_start.solved(group.island, warm_start.memory_of(group.island), count);
    return warm_start.next(group.island)({.first = 0.0, .last = 0.0}, {.first = 1.0, .last = 1.0}).last;
}

}  // namespace

TEST_CASE("after k steps with kept forces a sweep's answer counts for 1 / (k + 1), an exact one whole") {
    const Group group({1, 2});
    for (const int k : {0, 1, 4, 99}) {
        WarmStart warm_start;
        for (int i = 0; i < k; ++i) step(warm_start, {{&group, kept}});
        CHECK(share(warm_start, group, swept) == Approx(1.0 / (k + 1)));
        CHECK(share(warm_start, group, exact) == 1.0);
        CHECK(share(warm_start, group, kept) == 1.0);
    }
}

TEST_CASE("after an exact solve the guess has to be better than an answer, in the step after and no longer") {
    const Group group({1, 2});
    WarmStart warm_start;
    step(warm_start, {{&group, exact}});
    const solvers::Termination strict = WarmStart::termination(warm_start.memory_of(group.island), usual);
    CHECK(strict.tolerance_high == 0.1 * usual.tolerance_low);
    CHECK(strict.tolerance_low == 0.1 * usual.tolerance_low);
    CHECK(strict.iterations == usual.iterations);
    step(warm_start, {{&group, kept}});
    CHECK(WarmStart::termination(warm_start.memory_of(group.island), usual).tolerance_high == usual.tolerance_high);
}

TEST_CASE("what one island does is not remembered by another") {
    const Group left({0, 1}), right({3, 4, 5});
    WarmStart warm_start;
    for (int i = 0; i < 10; ++i) step(warm_start, {{&left, kept}, {&right, exact}});
    CHECK(warm_start.memory_of(left.island).kept == 10);
    CHECK_FALSE(warm_start.memory_of(left.island).exact);
    CHECK(warm_start.memory_of(right.island).kept == 0);
    CHECK(warm_start.memory_of(right.island).exact);
}

TEST_CASE("islands that meet take the newest solve and the stricter rule, parts keep what they had") {
    const Group tower({0, 1, 2}), ball({4}), together({0, 1, 2, 4});
    WarmStart warm_start;
    for (int i = 0; i < 10; ++i) step(warm_start, {{&tower, kept}, {&ball, i < 8 ? exact : kept}});
    CHECK(warm_start.memory_of(together.island).kept == 2);
    step(warm_start, {{&tower, kept}, {&ball, exact}});
    CHECK(warm_start.memory_of(together.island).exact);
    CHECK(warm_start.memory_of(together.island).kept == 0);
    step(warm_start, {{&together, kept}});
    step(warm_start, {{&together, kept}});
    CHECK(warm_start.memory_of(tower.island).kept == 2);
    CHECK(warm_start.memory_of(ball.island).kept == 2);
}

TEST_CASE("a body without rows forgets, and within a step the larger island counts with all that was done") {
    const Group first({1}), larger({1, 2});
    WarmStart warm_start;
    for (int i = 0; i < 5; ++i) step(warm_start, {{&first, kept}});
    step(warm_start, {});
    CHECK(warm_start.memory_of(first.island).kept == 0);
    step(warm_start, {{&first, exact}, {&larger, kept}});
    CHECK(warm_start.memory_of(larger.island).exact);
    CHECK(warm_start.method_of(larger.island) == Method::exact);
}

TEST_CASE("nothing is taken over from rows that contradict each other") {
    const Group group({1, 2});
    WarmStart warm_start;
    CHECK(share(warm_start, group, contradicting) == 0.0);
    CHECK(share(warm_start, group, exact) == 1.0);
}
