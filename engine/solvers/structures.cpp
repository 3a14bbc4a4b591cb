#include "engine/solvers/structures.h"

#include <algorithm>
#include <numeric>

namespace pushfactor::engine::solvers {

namespace {

// Connections and blocks that are kept at most, beside those of the island at hand: some 20 MB.
constexpr std::size_t most_kept = 1 << 16;

std::uint64_t hash_of(const Island& island) {
    std::uint64_t hash = static_cast<std::uint64_t>(island.body_count);
    for (const RowRun& run : island.runs) {
        const auto bodies = (static_cast<std::uint64_t>(run.a) << 32) | static_cast<std::uint32_t>(run.b);
        hash = (hash ^ bodies) * 0x9e3779b97f4a7c15u;
        hash ^= hash >> 29;
    }
    return hash;
}

bool is_of(const Structure& structure, const Island& island) {
    return structure.movable == island.movable() && structure.body_count == island.body_count &&
           std::equal(structure.connections.begin(), structure.connections.end(), island.runs.begin(),
                      island.runs.end(), [](const auto& bodies, const RowRun& run) {
                          return bodies == std::pair{run.a, run.b};
                      });
}

std::size_t size_of(const Structure& structure) {
    return structure.connections.size() + structure.matrix.block_count();
}

}  // namespace

Structure& Structures::of(const Island& island) {
    const std::uint64_t hash = hash_of(island);
    const auto [begin, end] = by_hash_.equal_range(hash);
    for (auto entry = begin; entry != end; ++entry) {
        if (!is_of(*entry->second, island)) continue;
        kept_.splice(kept_.begin(), kept_, entry->second);
        return kept_.front();
    }
    return make(island, hash);
}

Structure& Structures::make(const Island& island, std::uint64_t hash) {
    Structure& made = kept_.emplace_front();
    by_hash_.emplace(hash, kept_.begin());
    made.hash = hash;
    made.movable = island.movable();
    made.body_count = island.body_count;
    for (const RowRun& run : island.runs) {
        made.connections.emplace_back(run.a, run.b);
        made.pairs.emplace_back(std::minmax(run.a, run.b));
    }
    std::sort(made.pairs.begin(), made.pairs.end());
    made.pairs.erase(std::unique(made.pairs.begin(), made.pairs.end()), made.pairs.end());
    made.all_pairs = static_cast<int>(made.pairs.size());
    // The static bodies have the highest numbers.
    std::erase_if(made.pairs, [&](const auto& pair) { return pair.second >= made.movable; });
    size_ += size_of(made);
    forget_some();
    return made;
}

void Structures::plan(Structure& structure) {
    if (structure.planned) return;
    std::vector<int> bodies(static_cast<std::size_t>(structure.movable));
    std::iota(bodies.begin(), bodies.end(), 0);
    structure.matrix.connect(static_cast<std::size_t>(structure.body_count), structure.pairs, bodies);
    structure.planned = true;
    size_ += structure.matrix.block_count();
    forget_some();
}

void Structures::forget_some() {
    while (size_ > most_kept && kept_.size() > 1) {
        const auto oldest = std::prev(kept_.end());
        size_ -= size_of(*oldest);
        const auto [begin, end] = by_hash_.equal_range(oldest->hash);
        by_hash_.erase(std::find_if(begin, end, [&](const auto& entry) { return entry.second == oldest; }));
        kept_.erase(oldest);
    }
}

}  // namespace pushfactor::engine::solvers
