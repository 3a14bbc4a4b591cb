#include "engine/constraints/contact_cache.h"

#include "tests/catch.h"
#include "tests/random.h"

#include <deque>
#include <vector>

using namespace pushfactor::engine;
using namespace pushfactor::engine::collision;
using pushfactor::tests::Random;

namespace {

Touch touch(Pair pair, const std::vector<std::pair<std::uint32_t, Vector3>>& points) {
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

void store(ContactCache& cache, std::span<const Touch> touches, std::span<const ContactForce> forces) {
    cache.clear();
    for (const Touch& touch : touches) {
        cache.store(touch, forces.first(touch.points.size()));
        forces = forces.subspan(touch.points.size());
    }
}

}  // namespace

TEST_CASE("a force is found again by pair and feature, even when the point has moved") {
    ContactCache cache;
    const std::vector<Touch> before{touch({0, 1}, {{7, {0, 0, 0}}, {8, {1, 0, 0}}}),
                                    touch({1, 2}, {{7, {0, 1, 0}}})};
    store(cache, before, std::vector<ContactForce>{force(1), force(2), force(3)});

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
    store(cache, std::vector<Touch>{touch({0, 1}, {{7, {0, 0, 0}}, {8, {1, 0, 0}}})},
          std::vector<ContactForce>{force(1), force(2)});
    std::vector<ContactForce> forces;
    forces.clear();
    cache.recall(std::vector<Touch>{touch({0, 1}, {{30, {0.99, 0, 0}}, {31, {0.97, 0, 0}}})}, forces);
    CHECK(forces[0].normal.first == 2.0);
    CHECK(forces[1].normal.first == 0.0);
}

TEST_CASE("another pair finds nothing, and a pair that was away is forgotten") {
    ContactCache cache;
    store(cache, std::vector<Touch>{touch({0, 1}, {{7, {0, 0, 0}}})}, std::vector<ContactForce>{force(1)});
    std::vector<ContactForce> forces;
    forces.clear();
    cache.recall(std::vector<Touch>{touch({0, 2}, {{7, {0, 0, 0}}})}, forces);
    CHECK(forces[0].normal.first == 0.0);
    store(cache, std::vector<Touch>{}, std::vector<ContactForce>{});
    forces.clear();
    cache.recall(std::vector<Touch>{touch({0, 1}, {{7, {0, 0, 0}}})}, forces);
    CHECK(forces[0].normal.first == 0.0);
}

TEST_CASE("a corner that is clipped into two hands its force on once, to the point that is nearer") {
    ContactCache cache;
    store(cache, std::vector<Touch>{touch({0, 1}, {{7, {0, 0, 0}}, {8, {1, 0, 0}}})},
          std::vector<ContactForce>{force(1), force(2)});
    std::vector<ContactForce> forces;
    cache.recall(std::vector<Touch>{touch({0, 1}, {{30, {0.985, 0, 0}}, {31, {1, 0, 0.01}}, {7, {0, 0, 0}}})},
                 forces);
    REQUIRE(forces.size() == 3);
    CHECK(forces[0].normal.first == 0.0);
    CHECK(forces[1].normal.first == 2.0);
    CHECK(forces[2].normal.first == 1.0);
}

TEST_CASE("a force goes to its feature first, and what is near a point takes one that is left") {
    ContactCache cache;
    store(cache, std::vector<Touch>{touch({0, 1}, {{7, {0, 0, 0}}, {8, {0.01, 0, 0}}})},
          std::vector<ContactForce>{force(1), force(2)});
    std::vector<ContactForce> forces;
    // Nearer to the old point 7, which has moved on.
    cache.recall(std::vector<Touch>{touch({0, 1}, {{30, {0, 0, 0}}, {7, {0.005, 0, 0}}})}, forces);
    CHECK(forces[0].normal.first == 2.0);
    CHECK(forces[1].normal.first == 1.0);
}

TEST_CASE("whatever points come and go, no force is handed out twice, and each that can be given is given") {
    Random random(73);
    for (int i = 0; i < 2000; ++i) {
        const auto points = [&](int most) {
            std::vector<std::pair<std::uint32_t, Vector3>> some;
            const int count = static_cast<int>(random.in(0, most + 1));
            for (int p = 0; p < count; ++p) {
                // Features may occur twice in a manifold; points are spread over a few reaches.
                some.emplace_back(static_cast<std::uint32_t>(random.in(0, 6)), random.vector(0, 0.05));
            }
            return some;
        };
        const auto before = points(8), now = points(8);
        std::vector<ContactForce> given;
        for (std::size_t k = 0; k < before.size(); ++k) given.push_back(force(static_cast<double>(1 << k)));
        ContactCache cache;
        store(cache, std::vector<Touch>{touch({0, 1}, before)}, given);
        std::vector<ContactForce> forces;
        cache.recall(std::vector<Touch>{touch({0, 1}, now)}, forces);
        REQUIRE(forces.size() == now.size());
        // The forces are powers of two: bits of the set of forces that were used.
        unsigned handed_out = 0;
        for (const ContactForce& one : forces) {
            const auto bit = static_cast<unsigned>(one.normal.first);
            REQUIRE((handed_out & bit) == 0);
            handed_out |= bit;
        }
        for (std::size_t p = 0; p < now.size(); ++p) {
            if (forces[p].normal.first > 0.0) continue;
            for (std::size_t k = 0; k < before.size(); ++k) {
                const bool left = (handed_out & (1u << k)) == 0;
                const bool fits =
                    before[k].first == now[p].first || (before[k].second - now[p].second).norm() < 0.02;
                REQUIRE_FALSE((left && fits));
            }
        }
    }
}
