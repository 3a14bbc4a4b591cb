// What an exact solve knows of an island before it sees a number: which bodies rows connect, and from that the
// order of elimination and where the factor fills in. Both stay from step to step while the same bodies touch, and
// islands that are connected alike have them in common, so they are kept. An inner matter of the solvers.
#pragma once

#include "engine/solvers/exact/elimination.h"
#include "engine/system/islands.h"

#include <cstdint>
#include <limits>
#include <list>
#include <unordered_map>
#include <utility>
#include <vector>

namespace pushfactor::engine::solvers {

struct Structure {
    std::uint64_t hash = 0;           // of the next three
    int movable = 0, body_count = 0;  // of the island
    using Pairs = std::vector<std::pair<int, int>>;
    Pairs all_pairs;       // of bodies that rows connect, static ones included; ascending, each once
    Pairs movable_pairs;   // of those the ones of two movable bodies
    Elimination order;     // found once plan() has been called
    double planned = 0.0;  // multiply-adds up to which that was of interest; infinite once it is found
};

class Structures {
  public:
    Structures() = default;
    Structures(const Structures&) = delete;  // by_hash_ points into kept_
    Structures& operator=(const Structures&) = delete;

    // That of `island`; good until the next call.
    Structure& of(const Island& island);

    // Plans the factorisation for what of() has returned, unless it takes more than `most_work` multiply-adds.
    void plan(Structure& structure, double most_work = std::numeric_limits<double>::infinity());

  private:
    using Kept = std::list<Structure>;

    void find_pairs(const Island& island);
    bool is_at_hand(const Structure& structure, const Island& island) const;
    Structure& make(const Island& island, std::uint64_t hash);
    void forget_some();

    Kept kept_;  // the one that was asked for last comes first
    std::unordered_multimap<std::uint64_t, Kept::iterator> by_hash_;
    std::size_t size_ = 0;           // pairs and planned blocks of all that are kept
    Structure::Pairs pairs_;         // of the island at hand
    std::vector<int> begin_, next_;  // by body, places in pairs_ while these are sorted
};

}  // namespace pushfactor::engine::solvers
