// What an exact solve knows of an island before it sees a number: which bodies rows connect, and from that the
// order of elimination and where the factor fills in. Both stay from step to step while the same bodies touch, and
// islands that are connected alike have them in common, so they are kept. An inner matter of the solvers.
#pragma once

#include "engine/islands.h"
#include "engine/solvers/body_matrix.h"

#include <cstdint>
#include <list>
#include <unordered_map>
#include <utility>
#include <vector>

namespace pushfactor::engine::solvers {

struct Structure {
    std::uint64_t hash = 0;                        // of what follows
    std::vector<std::pair<int, int>> connections;  // bodies of the island's runs, in their order
    int movable = 0, body_count = 0;               // of the island
    std::vector<std::pair<int, int>> pairs;        // of movable bodies, ascending, each once
    int all_pairs = 0;                             // static partners included
    BodyMatrix matrix;                             // connected once plan() has been called
    bool planned = false;
};

class Structures {
  public:
    Structures() = default;
    Structures(const Structures&) = delete;  // by_hash_ points into kept_
    Structures& operator=(const Structures&) = delete;

    // That of `island`; good until the next call.
    Structure& of(const Island& island);

    // Plans the factorisation for what of() has returned. Costs more where there are many pairs.
    void plan(Structure& structure);

  private:
    using Kept = std::list<Structure>;

    Structure& make(const Island& island, std::uint64_t hash);
    void forget_some();

    Kept kept_;  // the one that was asked for last comes first
    std::unordered_multimap<std::uint64_t, Kept::iterator> by_hash_;
    std::size_t size_ = 0;  // connections and planned blocks of all that are kept
};

}  // namespace pushfactor::engine::solvers
