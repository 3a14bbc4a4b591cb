#include "engine/solvers/sweep_pipeline.h"

#include "engine/solvers/sweep.h"

#include <algorithm>

namespace pushfactor::engine::solvers {

namespace {

using Block = UnitRows<1>::Block;

// Looks until the other sweep is there; hands the core over when that takes long, as when there is only one.
template <typename IsThere>
void wait_until(const IsThere& is_there) {
    for (int looks = 0; !is_there(); ++looks) {
        if (looks > 1000) Threads::let_others_run();
    }
}

void sweep_part(UnitRows<1>& rows, std::size_t begin, std::size_t end, UnitRows<1>::BodyVelocity& still) {
    sweep(rows, begin, end, [&](const Block& block, std::size_t c) { return rows.at_bodies(block, c, still); });
}

}  // namespace

void SweepPipeline::plan(UnitRows<1>& rows) {
    rows.couple();
    // Its own, and those of rows that its bounds follow.
    const auto for_bodies = [&](const Block& block, const auto& visit) {
        const auto visit_movable = [&](int a, int b) {
            for (const int body : {a, b}) {
                if (body < rows.movable) visit(static_cast<std::size_t>(body));
            }
        };
        visit_movable(block.a, block.b);
        for (int i = 0; i < block.count; ++i) {
            const int leader = rows.rows_of(block)[i].of_row;
            if (leader < 0) continue;
            const auto& row = rows.rows[static_cast<std::size_t>(leader)];
            visit_movable(row.a, row.b);
        }
    };
    last_block_.assign(static_cast<std::size_t>(rows.movable), 0);
    for (std::size_t k = 0; k < rows.blocks.size(); ++k) {
        for_bodies(rows.blocks[k], [&](std::size_t body) { last_block_[body] = k; });
    }
    needs_.assign((rows.blocks.size() + blocks_of_a_part - 1) / blocks_of_a_part, 0);
    for (std::size_t k = 0; k < rows.blocks.size(); ++k) {
        std::size_t& needs = needs_[k / blocks_of_a_part];
        for_bodies(rows.blocks[k],
                   [&](std::size_t body) { needs = std::max(needs, last_block_[body] / blocks_of_a_part + 1); });
    }
}

void SweepPipeline::sweep(UnitRows<1>& rows, int sweeps, Threads& threads, const Part& before, const Part& after) {
    if (progress_.size() < static_cast<std::size_t>(sweeps)) {
        progress_ = std::vector<Progress>(static_cast<std::size_t>(sweeps));
    }
    for (Progress& progress : progress_) progress.parts.store(0, std::memory_order_relaxed);
    next_.store(0, std::memory_order_relaxed);
    threads.together([&] { work(rows, sweeps, before, after); });
}

// No deadlock: the unfinished sweep with the lowest number has been taken by a thread and waits for no other sweep.
void SweepPipeline::work(UnitRows<1>& rows, int sweeps, const Part& before, const Part& after) {
    UnitRows<1>::BodyVelocity still = UnitRows<1>::BodyVelocity::Zero();
    for (int sweep; (sweep = next_.fetch_add(1, std::memory_order_relaxed)) < sweeps;) {
        auto& own = progress_[static_cast<std::size_t>(sweep)].parts;
        std::size_t passed = sweep == 0 ? needs_.size() : 0;  // parts, by the sweep before
        for (std::size_t part = 0; part < needs_.size(); ++part) {
            if (passed < needs_[part]) {
                wait_until([&] {
                    passed = progress_[static_cast<std::size_t>(sweep) - 1].parts.load(std::memory_order_acquire);
                    return passed >= needs_[part];
                });
            }
            const std::size_t begin = part * blocks_of_a_part;
            const std::size_t end = std::min(begin + blocks_of_a_part, rows.blocks.size());
            const auto first_row = static_cast<std::size_t>(rows.blocks[begin].begin);
            const auto end_row = static_cast<std::size_t>(rows.blocks[end - 1].begin + rows.blocks[end - 1].count);
            if (sweep == 0) before(first_row, end_row);
            sweep_part(rows, begin, end, still);
            if (sweep + 1 == sweeps) after(first_row, end_row);
            own.store(part + 1, std::memory_order_release);
        }
    }
}

}  // namespace pushfactor::engine::solvers
