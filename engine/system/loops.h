// Which connections between bodies close a loop: those whose removal leaves their bodies connected.
#pragma once

#include <span>
#include <utility>
#include <vector>

namespace pushfactor::engine {

// Per edge of a graph of `nodes` nodes, numbered from 0, whether it is part of a cycle; parallel edges are.
std::vector<char> on_loops(std::span<const std::pair<int, int>> edges, int nodes);

// Per node the lowest one that edges connect it with; itself without any.
std::vector<int> connected(std::span<const std::pair<int, int>> edges, int nodes);

}  // namespace pushfactor::engine
