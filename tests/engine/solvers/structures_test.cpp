// Cached factorisation plans, shared by islands.
#include "engine/solvers/exact/structures.h"

#include "tests/catch.h"

using namespace pushfactor::engine;
using namespace pushfactor::engine::solvers;

namespace {

// An island: a chain of bodies that hangs from a static one.
struct String {
    explicit String(int count) {
        island.body_count = count + 1;
        for (int i = 0; i < count; ++i) {
            bodies.push_back(i);
            runs.push_back({.begin = i, .end = i + 1, .first = i, .a = i == 0 ? count : i - 1, .b = i});
        }
        island.bodies = bodies;
        island.runs = runs;
        island.rows = count;
    }
    std::vector<int> bodies;
    std::vector<RowRun> runs;
    Island island;
};

}  // namespace

TEST_CASE("islands that are connected alike share their structure, others have their own") {
    Structures structures;
    const String five(5), same(5), six(6);
    Structure* const first = &structures.of(five.island);
    CHECK(first->all_pairs.size() == 5);
    CHECK(first->movable_pairs.size() == 4);
    structures.plan(*first);
    const double work = first->order.symmetric_work();
    CHECK(&structures.of(six.island) != first);
    CHECK(&structures.of(same.island) == first);
    CHECK(structures.of(same.island).order.symmetric_work() == work);

    // The order of rows is not part of the structure.
    String reversed(5);
    std::reverse(reversed.runs.begin(), reversed.runs.end());
    CHECK(&structures.of(reversed.island) == first);

    String circle(5);
    circle.runs.push_back({.begin = 5, .end = 6, .first = 5, .a = 0, .b = 4});
    circle.island.runs = circle.runs;
    CHECK(&structures.of(circle.island) != first);
    CHECK(structures.of(circle.island).all_pairs.size() == 6);
}

TEST_CASE("the oldest plans are forgotten when there are very many, and made again when they are wanted") {
    Structures structures;
    const String last(2000);
    for (int count = 1; count <= 400; ++count) {
        const String string(count);
        Structure& own = structures.of(string.island);
        structures.plan(own);
        REQUIRE(own.planned);
        REQUIRE(own.order.block_count() == static_cast<std::size_t>(2 * count - 1));
    }
    CHECK_FALSE(structures.of(String(3).island).planned);  // 240,000 connections and blocks since then
    CHECK(structures.of(String(399).island).planned);
    structures.plan(structures.of(last.island));
    CHECK(structures.of(last.island).planned);
}
