#include "engine/solvers/exact/structures.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

namespace pushfactor::engine::solvers {

namespace {

// Limit on stored pairs and blocks besides those of the current island: some 20 MB.
constexpr std::size_t most_kept = 1 << 16;

std::uint64_t hash_of(const Island& island, const Structure::Pairs& pairs) {
    auto hash = static_cast<std::uint64_t>(island.body_count);
    for (const auto& [a, b] : pairs) {
        const auto both = (static_cast<std::uint64_t>(a) << 32) | static_cast<std::uint32_t>(b);
        hash = (hash ^ both) * 0x9e3779b97f4a7c15u;
        hash ^= hash >> 29;
    }
    return hash;
}

std::size_t size_of(const Structure& structure) {
    return structure.all_pairs.size() + structure.order.block_count();
}

}  // namespace

// Pairs in an order of their own, because that of the rows changes with heights while the structure does not.
// Bucket sort by the first body, then by the second.
void Structures::find_pairs(const Island& island) {
    begin_.assign(static_cast<std::size_t>(island.body_count) + 1, 0);
    for (const RowRun& run : island.runs) ++begin_[static_cast<std::size_t>(std::min(run.a, run.b)) + 1];
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    pairs_.resize(island.runs.size());
    next_.assign(begin_.begin(), begin_.end());
    for (const RowRun& run : island.runs) {
        const auto [low, high] = std::minmax(run.a, run.b);
        pairs_[static_cast<std::size_t>(next_[static_cast<std::size_t>(low)]++)] = {low, high};
    }
    for (std::size_t body = 0; body + 1 < begin_.size(); ++body) {
        std::sort(pairs_.begin() + begin_[body], pairs_.begin() + begin_[body + 1]);
    }
    pairs_.erase(std::unique(pairs_.begin(), pairs_.end()), pairs_.end());
}

bool Structures::is_at_hand(const Structure& structure, const Island& island) const {
    return structure.movable == island.movable() && structure.body_count == island.body_count &&
           structure.all_pairs == pairs_;
}

Structure& Structures::of(const Island& island) {
    find_pairs(island);
    const std::uint64_t hash = hash_of(island, pairs_);
    const auto [begin, end] = by_hash_.equal_range(hash);
    for (auto entry = begin; entry != end; ++entry) {
        if (!is_at_hand(*entry->second, island)) continue;
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
    made.all_pairs = pairs_;
    // Static bodies have the highest numbers.
    std::copy_if(pairs_.begin(), pairs_.end(), std::back_inserter(made.movable_pairs),
                 [&](const auto& pair) { return pair.second < made.movable; });
    size_ += size_of(made);
    forget_some();
    return made;
}

void Structures::plan(Structure& structure, double most_work) {
    if (structure.planned >= most_work) return;
    // Plan for more than requested, because the next step may need slightly more.
    const double limit = 2.0 * most_work;
    structure.order.find(structure.movable, structure.movable_pairs, limit);
    const bool found = std::isfinite(structure.order.symmetric_work());
    structure.planned = found ? infinity : limit;
    size_ += structure.order.block_count();
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
