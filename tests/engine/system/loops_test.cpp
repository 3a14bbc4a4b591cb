// Connections that close a loop.
#include "engine/system/loops.h"

#include "tests/catch.h"

#include <numeric>
#include <random>

using namespace pushfactor::engine;

namespace {

using Edges = std::vector<std::pair<int, int>>;

// Whether the ends of edge `out` stay connected without it.
bool is_bypassed(const Edges& edges, std::size_t out, int nodes) {
    std::vector<int> group(static_cast<std::size_t>(nodes));
    std::iota(group.begin(), group.end(), 0);
    for (int round = 0; round < nodes; ++round) {
        for (std::size_t k = 0; k < edges.size(); ++k) {
            if (k == out) continue;
            int& a = group[static_cast<std::size_t>(edges[k].first)];
            int& b = group[static_cast<std::size_t>(edges[k].second)];
            a = b = std::min(a, b);
        }
    }
    return group[static_cast<std::size_t>(edges[out].first)] == group[static_cast<std::size_t>(edges[out].second)];
}

}  // namespace

TEST_CASE("an edge closes a loop if its ends stay connected without it") {
    CHECK(on_loops({}, 0).empty());
    CHECK(on_loops(Edges{{0, 1}, {1, 2}}, 3) == std::vector<char>{0, 0});
    CHECK(on_loops(Edges{{0, 1}, {1, 0}, {1, 2}}, 3) == std::vector<char>{1, 1, 0});
    std::mt19937 random(1);
    for (int trial = 0; trial < 300; ++trial) {
        const int nodes = 2 + static_cast<int>(random() % 9);
        Edges edges(random() % 14);
        for (auto& [a, b] : edges) {
            a = static_cast<int>(random() % static_cast<unsigned>(nodes));
            b = (a + 1 + static_cast<int>(random() % static_cast<unsigned>(nodes - 1))) % nodes;
        }
        const std::vector<char> loops = on_loops(edges, nodes);
        REQUIRE(loops.size() == edges.size());
        for (std::size_t k = 0; k < edges.size(); ++k) CHECK((loops[k] != 0) == is_bypassed(edges, k, nodes));
    }
}

TEST_CASE("what edges connect has the number of its lowest node") {
    CHECK(connected(Edges{{3, 1}, {4, 3}, {2, 5}}, 6) == std::vector<int>{0, 1, 2, 1, 1, 2});
}
