// Cache of the connectivity of islands: which bodies rows connect, and the elimination order and fill-in that
// follow. These stay the same from step to step while the same bodies touch, and equally connected islands share
// them. Internal to the solvers.
#pragma once

#include "engine/solvers/exact/elimination.h"
#include "engine/system/islands.h"

#include <cstdint>
#include <list>
#include <unordered_map>
#include <utility>
#include <vector>

namespace pushfactor::engine::solvers {

struct Structure {
    std::uint64_t hash = 0;           // of the next three
    int movable = 0, body_count = 0;  // of the island
    using Pairs = std::vector<std::pair<int, int>>;
    Pairs all_pairs;       // connected bodies, including static ones; ascending, unique
    Pairs movable_pairs;   // those of two movable bodies
    Elimination order;     // computed by Structures::plan()
    double planned = 0.0;  // limit in multiply-adds of the last plan; infinite once found
};

class Structures {
  public:
    Structures() = default;
    Structures(const Structures&) = delete;  // by_hash_ points into kept_
    Structures& operator=(const Structures&) = delete;

    // The structure of `island`; valid until the next call.
    Structure& of(const Island& island);

    // Plans the factorisation of a structure from of(), unless it takes more than `most_work` multiply-adds.
    void plan(Structure& structure, double most_work = infinity);

  private:
    using Kept = std::list<Structure>;

    void find_pairs(const Island& island);
    bool is_at_hand(const Structure& structure, const Island& island) const;
    Structure& make(const Island& island, std::uint64_t hash);
    void forget_some();

    Kept kept_;  // most recently used first
    std::unordered_multimap<std::uint64_t, Kept::iterator> by_hash_;
    std::size_t size_ = 0;           // pairs and planned blocks of all kept structures
    Structure::Pairs pairs_;         // of the current island
    std::vector<int> begin_, next_;  // by body, positions in pairs_ during sorting
};

}  // namespace pushfactor::engine::solvers
