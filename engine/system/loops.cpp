#include "engine/system/loops.h"

#include "engine/base/index.h"

namespace pushfactor::engine {

namespace {

// A forest that spans the graph, as it grows breadth first.
struct Forest {
    std::vector<int> parent, edge, depth;  // by node; the edge to its parent
    std::vector<int> root;                 // by node, the lowest of its tree; -1 while it has none
};

Forest spanning(std::span<const std::pair<int, int>> edges, int nodes) {
    std::vector<std::vector<int>> edges_of(at(nodes));
    for (std::size_t k = 0; k < edges.size(); ++k) {
        edges_of[at(edges[k].first)].push_back(static_cast<int>(k));
        edges_of[at(edges[k].second)].push_back(static_cast<int>(k));
    }
    Forest forest{std::vector<int>(at(nodes), -1), std::vector<int>(at(nodes), -1), std::vector<int>(at(nodes), 0),
                  std::vector<int>(at(nodes), -1)};
    std::vector<int> found;
    for (int root = 0; root < nodes; ++root) {
        if (forest.root[at(root)] >= 0) continue;
        forest.root[at(root)] = root;
        found.assign(1, root);
        for (std::size_t next = 0; next < found.size(); ++next) {
            const int node = found[next];
            for (const int k : edges_of[at(node)]) {
                const auto [a, b] = edges[at(k)];
                const int other = a == node ? b : a;
                if (forest.root[at(other)] >= 0) continue;
                forest.root[at(other)] = root;
                forest.parent[at(other)] = node;
                forest.edge[at(other)] = k;
                forest.depth[at(other)] = forest.depth[at(node)] + 1;
                found.push_back(other);
            }
        }
    }
    return forest;
}

}  // namespace

// Every other edge closes the loop of the paths from its ends to where these meet.
std::vector<char> on_loops(std::span<const std::pair<int, int>> edges, int nodes) {
    const Forest forest = spanning(edges, nodes);
    std::vector<char> loops(edges.size(), 0);
    for (std::size_t k = 0; k < edges.size(); ++k) {
        auto [a, b] = edges[k];
        if (forest.edge[at(a)] == static_cast<int>(k) || forest.edge[at(b)] == static_cast<int>(k)) continue;
        loops[k] = 1;
        while (a != b) {
            int& lower = forest.depth[at(a)] > forest.depth[at(b)] ? a : b;
            loops[at(forest.edge[at(lower)])] = 1;
            lower = forest.parent[at(lower)];
        }
    }
    return loops;
}

std::vector<int> connected(std::span<const std::pair<int, int>> edges, int nodes) {
    return spanning(edges, nodes).root;
}

}  // namespace pushfactor::engine
