#include "engine/contact_cache.h"

#include "tests/catch.h"

#include <deque>
#include <vector>

using namespace pushfactor::engine;
using namespace pushfactor::engine::collision;

namespace {

Touch touch(Pair pair, std::initializer_list<std::pair<std::uint32_t, Vector3>> points) {
    static std::deque<std::vector<ContactPoint>> of_all;  // a touch does not own its points
    std::vector<ContactPoint>& made = of_all.emplace_back();
    for (const auto& [feature, position] : points) made.push_back({position, -0.001, feature});
    Touch result;
    result.pair = pair;
    result.size = 1.0;
    result.points = made;
    return result;
}

ContactForce force(double newton) {
    return {.normal = {newton, newton + 0.5}};
}

}  // namespace

TEST_CASE("a force is found again by pair and feature, even when the point has moved") {
    ContactCache cache;
    const std::vector<Touch> before{touch({0, 1}, {{7, {0, 0, 0}}, {8, {1, 0, 0}}}),
                                    touch({1, 2}, {{7, {0, 1, 0}}})};
    cache.store(before, std::vector<ContactForce>{force(1), force(2), force(3)});

    const std::vector<Touch> now{touch({0, 1}, {{8, {0.5, 0, 0}}}), touch({1, 2}, {{7, {0, 1, 0}}})};
    std::vector<ContactForce> forces;
    forces.clear();
    cache.recall(now, forces);
    REQUIRE(forces.size() == 2);
    CHECK(forces[0].normal.first == 2.0);
    CHECK(forces[0].normal.last == 2.5);
    CHECK(forces[1].normal.first == 3.0);
}

TEST_CASE(
    "a new feature takes the force of the nearest point within 2 % of the size, a farther one starts from zero") {
    ContactCache cache;
    cache.store(std::vector<Touch>{touch({0, 1}, {{7, {0, 0, 0}}, {8, {1, 0, 0}}})},
                std::vector<ContactForce>{force(1), force(2)});
    std::vector<ContactForce> forces;
    forces.clear();
    cache.recall(std::vector<Touch>{touch({0, 1}, {{30, {0.99, 0, 0}}, {31, {0.97, 0, 0}}})}, forces);
    CHECK(forces[0].normal.first == 2.0);
    CHECK(forces[1].normal.first == 0.0);
}

TEST_CASE("another pair finds nothing, and a pair that was away is forgotten") {
    ContactCache cache;
    cache.store(std::vector<Touch>{touch({0, 1}, {{7, {0, 0, 0}}})}, std::vector<ContactForce>{force(1)});
    std::vector<ContactForce> forces;
    forces.clear();
    cache.recall(std::vector<Touch>{touch({0, 2}, {{7, {0, 0, 0}}})}, forces);
    CHECK(forces[0].normal.first == 0.0);
    cache.store(std::vector<Touch>{}, std::vector<ContactForce>{});
    forces.clear();
    cache.recall(std::vector<Touch>{touch({0, 1}, {{7, {0, 0, 0}}})}, forces);
    CHECK(forces[0].normal.first == 0.0);
}
