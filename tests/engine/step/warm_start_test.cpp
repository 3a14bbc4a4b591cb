// The warm start of an island: what it keeps from step to step, and the resulting guess.
#include "engine/step/warm_start.h"

#include "tests/catch.h"
#include "tests/engine/solvers/problems.h"

#include <array>

using namespace pushfactor;
using namespace pushfactor::engine;
using Memory = WarmStart::Memory;
using Method = WarmStart::Method;

namespace {

constexpr solvers::SolveCount kept{};
constexpr solvers::SolveCount swept{.iterations = 5};
constexpr solvers::SolveCount exact{.iterations = 1, .exact = true};
constexpr solvers::SolveCount contradicting{.iterations = 9, .gave_up = true, .contradicts = true};
constexpr solvers::Termination usual{.iterations = 25, .tolerance_high = 1e-6, .tolerance_low = 1e-8};

constexpr std::array everybody{0, 1, 2, 3, 4, 5};

// Islands by their bodies alone.
struct Group {
    explicit Group(std::vector<int> some) : bodies(std::move(some)) { island.bodies = bodies; }
    std::vector<int> bodies;
    Island island;
};

void step(WarmStart& warm_start, std::initializer_list<std::pair<const Group*, solvers::SolveCount>> solves) {
    warm_start.begin(6, everybody);
    for (const auto& [group, count] : solves) {
        warm_start.solved(group->island, count);
    }
    warm_start.end(everybody);
}

const Memory& memory_of(const WarmStart& warm_start, int body) {
    return warm_start.memory()[static_cast<std::size_t>(body)];
}

// Whether the next step would require a better guess than usual.
bool is_strict(const WarmStart& warm_start, const Group& group) {
    return warm_start.tolerance_high(group.island, usual) < usual.tolerance_high;
}

// The share of a solution's change of 1 N that enters the guess, for a row between two bodies.
double share(WarmStart& warm_start, const Group& group, const solvers::SolveCount& count, int a, int b) {
    warm_start.begin(6, everybody);
    warm_start.solved(group.island, count);
    return warm_start.next(a, b)({.first = 0.0, .last = 0.0}, {.first = 1.0, .last = 1.0}).last;
}

}  // namespace

TEST_CASE("after k steps with kept forces a sweep's answer counts for 1 / (k + 1), an exact one whole") {
    const Group group({1, 2});
    for (const int k : {0, 1, 4, 99}) {
        WarmStart warm_start;
        for (int i = 0; i < k; ++i) step(warm_start, {{&group, kept}});
        for (const auto& [a, b] : {std::pair{1, 2}, std::pair{0, 1}, std::pair{2, 0}}) {  // 0 is static
            CHECK(share(warm_start, group, swept, a, b) == Approx(1.0 / (k + 1)));
            CHECK(share(warm_start, group, exact, a, b) == 1.0);
            CHECK(share(warm_start, group, kept, a, b) == 1.0);
        }
    }
}

TEST_CASE(
    "where a new force has made a kept guess wrong the answer counts whole, also when more rows come in the step") {
    const Group group({1, 2}), larger({1, 2, 3});
    WarmStart warm_start;
    for (int i = 0; i < 600; ++i) step(warm_start, {{&group, kept}});
    warm_start.begin(6, everybody);
    CHECK(warm_start.begins_with_kept(group.island));
    warm_start.solved(group.island, swept, true);
    CHECK_FALSE(warm_start.begins_with_kept(group.island));
    CHECK(warm_start.next(1, 2).share == 1.0);
    warm_start.solved(larger.island, swept);
    CHECK(warm_start.next(1, 2).share == 1.0);
}

TEST_CASE("after an exact solve the guess has to be better than an answer, in the step after and no longer") {
    const Group group({1, 2});
    WarmStart warm_start;
    step(warm_start, {{&group, exact}});
    const double strict = warm_start.tolerance_high(group.island, usual);
    CHECK(strict == 0.1 * usual.tolerance_low);
    step(warm_start, {{&group, kept}});
    CHECK_FALSE(is_strict(warm_start, group));
}

TEST_CASE("what one island does is not remembered by another") {
    const Group left({0, 1}), right({3, 4, 5});
    WarmStart warm_start;
    for (int i = 0; i < 10; ++i) step(warm_start, {{&left, kept}, {&right, exact}});
    CHECK_FALSE(is_strict(warm_start, left));
    CHECK(is_strict(warm_start, right));
    for (const int body : {0, 1}) CHECK(memory_of(warm_start, body).kept == 10);
    for (const int body : {3, 4, 5}) CHECK(memory_of(warm_start, body).kept == 0);
}

TEST_CASE(
    "where islands meet each row goes on from what its bodies have, and one that comes does not change the rest") {
    const Group tower({0, 1, 2}), ball({4}), together({0, 1, 2, 4});
    WarmStart warm_start;
    for (int i = 0; i < 9; ++i) step(warm_start, {{&tower, kept}, {&ball, i < 7 ? exact : kept}});
    CHECK(share(warm_start, together, swept, 1, 2) == Approx(0.1));
    CHECK(share(warm_start, together, swept, 2, 4) == Approx(1.0 / 3.0));
    // Strict only where all were solved exactly.
    step(warm_start, {{&tower, kept}, {&ball, exact}});
    CHECK(is_strict(warm_start, ball));
    CHECK_FALSE(is_strict(warm_start, together));
    step(warm_start, {{&together, exact}});
    CHECK(is_strict(warm_start, tower));
}

TEST_CASE("a body without rows forgets, and within a step the larger island counts with all that was done") {
    const Group first({1}), larger({1, 2});
    WarmStart warm_start;
    for (int i = 0; i < 5; ++i) step(warm_start, {{&first, kept}});
    CHECK(memory_of(warm_start, 1).kept == 5);
    step(warm_start, {});
    CHECK(memory_of(warm_start, 1).kept == 0);
    step(warm_start, {{&first, exact}, {&larger, kept}});
    CHECK(is_strict(warm_start, larger));
    CHECK(warm_start.method_of(larger.island) == Method::exact);
}

TEST_CASE("nothing is taken over from rows that contradict each other") {
    const Group group({1, 2});
    WarmStart warm_start;
    CHECK(share(warm_start, group, contradicting, 1, 2) == 0.0);
    CHECK(share(warm_start, group, exact, 1, 2) == 1.0);
}
