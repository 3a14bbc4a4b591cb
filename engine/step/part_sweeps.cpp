#include "engine/step/part_sweeps.h"

#include "engine/solvers/sweep.h"

#include <algorithm>

namespace pushfactor::engine {

namespace {

std::size_t index(int number) {
    return static_cast<std::size_t>(number);
}

// Whether the block is a contact with round friction and nothing else.
bool fits_in_four(const solvers::UnitRows& rows, const solvers::UnitRows::Block& block) {
    if (block.count != FourContacts::rows || block.disc != 1) return false;
    const solvers::UnitRow* const row = &rows.rows[index(block.begin)];
    return row[0].scale > 0.0 && row[1].scale > 0.0 && row[2].scale > 0.0 && row[0].leader < 0 &&
           row[0].low == 0.0 && row[0].high == infinity && row[2].leader == block.begin;
}

}  // namespace

void PartSweeps::load(const solvers::UnitRows& rows, int begin_row, int end_row) {
    blocks_.clear();
    rows.add_blocks(begin_row, end_row, blocks_);
}

// Each contact joins the first group with a free place that comes after all with one of its bodies.
void PartSweeps::pack(solvers::UnitRows& rows, std::span<int> scratch) {
    fours_.clear();
    packed_.clear();
    turns_.clear();
    groups_.clear();
    const auto each_body = [&](const Block& block, const auto& visit) {
        if (block.a < rows.movable) visit(scratch[index(block.a)]);
        if (block.b < rows.movable) visit(scratch[index(block.b)]);
    };
    for (const Block& block : blocks_) each_body(block, [](int& next_group) { next_group = 0; });
    for (const Block& block : blocks_) {
        const bool fits = fits_in_four(rows, block);
        std::size_t number = groups_.size();
        if (fits) {
            number -= std::min(number, open_groups);
            each_body(block, [&](int least) { number = std::max(number, index(least)); });
            while (number < groups_.size() && groups_[number].is_full) ++number;
        }
        if (number == groups_.size()) groups_.emplace_back();
        Group& group = groups_[number];
        group.blocks[group.count++] = block;
        group.is_full = !fits || group.count == FourContacts::count;
        each_body(block, [&](int& next_group) { next_group = static_cast<int>(number) + 1; });
    }
    blocks_.clear();
    for (const Group& group : groups_) {
        if (group.count > 1) {
            turns_.push_back(-1 - static_cast<int>(fours_.size()));
            put_in_four(rows, group);
        } else {
            turns_.push_back(static_cast<int>(blocks_.size()));
            blocks_.push_back(group.blocks[0]);
        }
    }
}

void PartSweeps::put_in_four(const solvers::UnitRows& rows, const Group& group) {
    FourContacts& four = fours_.emplace_back();
    four.row.fill(FourContacts::none);
    four.a = four.b = four.row;
    for (auto& scale : four.scale) scale += 1.0;
    four.acts = four.scale[0] > 0.0;
    for (std::size_t k = 0; k < group.count; ++k) {
        const Block& block = group.blocks[k];
        four.row[k] = block.begin;
        four.a[k] = block.a < rows.movable ? block.a : FourContacts::none;
        four.b[k] = block.b < rows.movable ? block.b : FourContacts::none;
        for (int i = 0; i < FourContacts::rows; ++i) {
            const solvers::UnitRow& row = rows.rows[index(block.begin + i)];
            for (int n = 0; n < 6; ++n) {
                four.axis[i][n][k] = row.unit->a[n];
                four.axis[i][n + 6][k] = row.unit->b[n];
            }
            four.coupling[i][k] = block.couplings[index(i)];
            four.y[i][k] = row.y;
            four.t[i][k] = row.t;
            four.scale[i][k] = row.scale;
        }
        four.keeps[k] = rows.rows[index(block.begin)].keeps;
        four.radius[k] = rows.rows[index(block.begin + 2)].high;
        packed_.push_back(block);
    }
}

void PartSweeps::unpack(solvers::UnitRows& rows) const {
    for (const FourContacts& four : fours_) {
        for (std::size_t k = 0; k < FourContacts::count; ++k) {
            if (four.row[k] == FourContacts::none) continue;
            for (int i = 0; i < FourContacts::rows; ++i) {
                solvers::UnitRow& row = rows.rows[index(four.row[k] + i)];
                row.y = four.y[i][k];
                row.t = four.t[i][k];
            }
        }
    }
}

double PartSweeps::residual(solvers::UnitRows& rows) const {
    return std::max(rows.residual(blocks_), rows.residual(packed_));
}

double PartSweeps::sweep_blocks(solvers::UnitRows& rows, std::span<const Block> some) {
    Vector6 still = Vector6::Zero();
    return solvers::sweep<true>(rows, some, [&](const Block& block) { return rows.at_bodies(block, still); });
}

double PartSweeps::sweep_fours(solvers::UnitRows& rows, std::span<FourContacts> some) {
    engine::sweep(some, rows.velocity);
    double largest = 0.0;
    for (const FourContacts& four : some) {
        for (std::size_t k = 0; k < FourContacts::count; ++k) largest = std::max(largest, four.change[k]);
    }
    return largest;
}

// Runs of blocks and runs of fours at once.
double PartSweeps::sweep(solvers::UnitRows& rows) {
    double largest = 0.0;
    for (std::size_t begin = 0, end = 0; begin < turns_.size(); begin = end) {
        const int first = turns_[begin];
        while (end < turns_.size() && (turns_[end] < 0) == (first < 0)) ++end;
        const double change = first < 0 ? sweep_fours(rows, fours().subspan(index(-1 - first), end - begin))
                                        : sweep_blocks(rows, blocks().subspan(index(first), end - begin));
        largest = std::max(largest, change);
    }
    return largest;
}

double PartSweeps::sweep_restless(solvers::UnitRows& rows, double least, int number, bool all, Stirred stirred,
                                  double& updates) {
    const auto is_restless = [&](int body) {
        return index(body) < stirred.size() && stirred[index(body)] >= number - 1;
    };
    const auto stir = [&](double change, int a, int b) {
        if (change <= least) return;
        for (const int body : {a, b}) {
            if (index(body) < stirred.size()) stirred[index(body)] = number;
        }
    };
    double largest = 0.0;
    for (const int turn : turns_) {
        if (turn >= 0) {
            const Block& block = blocks_[index(turn)];
            if (!all && !is_restless(block.a) && !is_restless(block.b)) continue;
            const double change = sweep_blocks(rows, {&block, 1});
            largest = std::max(largest, change);
            updates += block.count;
            stir(change, block.a, block.b);
            continue;
        }
        FourContacts& four = fours_[index(-1 - turn)];
        int acting = 0;
        for (std::size_t k = 0; k < FourContacts::count; ++k) {
            const bool acts =
                four.row[k] != FourContacts::none && (all || is_restless(four.a[k]) || is_restless(four.b[k]));
            four.acts[k] = acts ? -1 : 0;
            acting += acts ? 1 : 0;
        }
        if (acting == 0) continue;
        largest = std::max(largest, sweep_fours(rows, {&four, 1}));
        updates += FourContacts::rows * acting;
        for (std::size_t k = 0; k < FourContacts::count; ++k) stir(four.change[k], four.a[k], four.b[k]);
    }
    return largest;
}

}  // namespace pushfactor::engine
