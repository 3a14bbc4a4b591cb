#include "engine/step/part_sweeps.h"

#include "engine/base/overloaded.h"
#include "engine/solvers/sweep.h"

#include <algorithm>

namespace pushfactor::engine {

namespace {

std::size_t index(int number) {
    return static_cast<std::size_t>(number);
}

const ConstraintRow& row_of(const SystemEquation& system, int row) {
    return system.rows[index(row)];
}

// Whether the block is a contact with round friction and nothing else.
bool fits_in_four(const PartSweeps::Start& start, const PartSweeps::Block& block) {
    if (block.count != FourContacts::rows || block.disc != 1 || block.of_step < 0) return false;
    if (!(start.system.diagonal.segment<FourContacts::rows>(block.of_step).minCoeff() > 0.0)) return false;
    const Bounds& bounds = row_of(start.system, block.of_step).bounds;
    return bounds.of_row < 0 && bounds.c_min == 0.0 && bounds.c_max == infinity &&
           (start.column == 0 || bounds.in_momenta) &&
           row_of(start.system, block.of_step + 2).bounds.of_row == block.of_step;
}

void put_in_lane(std::size_t k, const Jacobian& unit, FourContacts::Lanes (&axis)[12]) {
    for (int n = 0; n < 6; ++n) {
        axis[n][k] = unit.a[n];
        axis[n + 6][k] = unit.b[n];
    }
}

double largest_change(std::span<const FourContacts> some) {
    double largest = 0.0;
    for (const FourContacts& four : some) {
        for (std::size_t k = 0; k < FourContacts::count; ++k) largest = std::max(largest, four.change[k]);
    }
    return largest;
}

// No contact: it moves nothing, and nothing is divided by zero.
void clear(FourContacts& four) {
    four.row.fill(FourContacts::none);
    four.a = four.b = four.row;
    for (auto& scale : four.scale) scale += 1.0;
    four.acts = four.scale[0] > 0.0;
}

}  // namespace

void PartSweeps::load(const Start& start, solvers::UnitRows& rows, std::span<int> scratch) {
    find_groups(start, scratch);
    blocks_.clear();
    fours_.clear();
    turns_.clear();
    for (const Group& group : groups_) {
        if (group.count > 1) {
            turns_.push_back(-1 - static_cast<int>(fours_.size()));
            put_in_four(start, group, rows.movable, fours_.emplace_back());
        } else {
            turns_.push_back(static_cast<int>(blocks_.size()));
            blocks_.push_back(group.blocks[0]);
        }
    }
    load_blocks(start, rows);
    rows.couple(blocks_);
    Vector6 still = Vector6::Zero();
    in_turn(Overloaded{
        [&](std::span<FourContacts> some) { push(some, rows.velocity); },
        [&](std::span<const Block> some) { rows.add_velocities(some, still); },
    });
}

// Each contact joins the first group with a free place that comes after all with one of its bodies. Where bounds
// follow rows of other bodies, these have to be rows.
void PartSweeps::find_groups(const Start& start, std::span<int> scratch) {
    blocks_.clear();
    groups_.clear();
    for (const RowRun& run : start.runs) solvers::UnitRows::add_blocks(start.system, run, blocks_);
    const auto each_body = [&](const Block& block, const auto& visit) {
        if (index(block.a) < scratch.size()) visit(scratch[index(block.a)]);
        if (index(block.b) < scratch.size()) visit(scratch[index(block.b)]);
    };
    for (const Block& block : blocks_) each_body(block, [](int& next_group) { next_group = 0; });
    for (const Block& block : blocks_) {
        const bool fits = !start.island.follows_others && fits_in_four(start, block);
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
}

void PartSweeps::put_in_four(const Start& start, const Group& group, int movable, FourContacts& four) {
    clear(four);
    const SystemEquation& system = start.system;
    for (std::size_t k = 0; k < group.count; ++k) {
        const Block& block = group.blocks[k];
        four.row[k] = block.of_step;
        four.a[k] = block.a < movable ? block.a : FourContacts::none;
        four.b[k] = block.b < movable ? block.b : FourContacts::none;
        std::array<Jacobian, FourContacts::rows> units;
        for (std::size_t i = 0; i < units.size(); ++i) {
            const int j = block.of_step + static_cast<int>(i);
            const double scale = std::sqrt(system.diagonal[j]);
            units[i] = unit_axis(system, row_of(system, j), scale);
            put_in_lane(k, units[i], four.axis[i]);
            for (std::size_t other = 0; other < i; ++other)
                four.coupling[i + other - 1][k] = solvers::product(units[i], units[other]);
            four.scale[i][k] = scale;
            four.y[i][k] = start.lambda(j, start.column) * (start.h * scale);
            four.t[i][k] = (row_of(system, j).push.lasting + system.carried_by(index(j))) / scale;
        }
        const Bounds& friction = row_of(system, block.of_step + 2).bounds;
        if (start.column == 0 || friction.in_momenta)
            four.radius[k] = friction.c_max * (four.scale[2][k] / four.scale[0][k]);
        four.keeps[k] = 1.0;
        const ConstraintRow& normal = row_of(system, block.of_step);
        if (!holds_a_place(normal)) continue;
        four.holds[k] = -1;
        four.start[k] = four.error[k] = normal.error;
        four.carried[k] = system.carried_by(index(block.of_step));
        four.beta[k] = normal.correction->kind == PushKind::none ? 0.0 : normal.correction->beta;
        four.correcting[k] = normal.push.correcting;
    }
}

// Whole runs of rows: bounds may follow rows of the same run. A block may have rows of several runs.
void PartSweeps::load_blocks(const Start& start, solvers::UnitRows& rows) const {
    const RowRun* loaded = nullptr;
    auto run = start.runs.begin();
    for (const Block& block : blocks_) {
        while (block.begin >= run->first + run->end - run->begin) ++run;
        for (auto own = run; own != start.runs.end() && own->first < block.begin + block.count; ++own) {
            if (&*own == loaded) continue;
            loaded = &*own;
            rows.load_run(start.system, start.island, *own);
            rows.take_run(start.system, *own, start.lambda, start.column, start.h);
        }
    }
}

double PartSweeps::residual(solvers::UnitRows& rows) {
    look(fours_, rows.velocity);
    return std::max(rows.residual(blocks_), largest_change(fours_));
}

double PartSweeps::sweep_some(solvers::UnitRows& rows, std::span<const Block> some) {
    Vector6 still = Vector6::Zero();
    return solvers::sweep<true>(rows, some, [&](const Block& block) { return rows.at_bodies(block, still); });
}

double PartSweeps::sweep_some(solvers::UnitRows& rows, std::span<FourContacts> some) {
    engine::sweep(some, rows.velocity);
    return largest_change(some);
}

double PartSweeps::sweep_turn(solvers::UnitRows& rows, int turn) {
    if (turn < 0) return sweep_some(rows, std::span<FourContacts>(&fours_[index(-1 - turn)], 1));
    return sweep_some(rows, std::span<const Block>(&blocks_[index(turn)], 1));
}

double PartSweeps::sweep(solvers::UnitRows& rows, bool backwards) {
    double largest = 0.0;
    for (std::size_t i = 0; i < turns_.size(); ++i)
        largest = std::max(largest, sweep_turn(rows, turn_at(i, backwards)));
    return largest;
}

double PartSweeps::sweep_restless(solvers::UnitRows& rows, bool backwards, double least, int number, bool all,
                                  Stirred stirred, double& updates) {
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
    for (std::size_t i = 0; i < turns_.size(); ++i) {
        const int turn = turn_at(i, backwards);
        if (turn >= 0) {
            const Block& block = blocks_[index(turn)];
            if (!all && !is_restless(block.a) && !is_restless(block.b)) continue;
            const double change = sweep_turn(rows, turn);
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
        largest = std::max(largest, sweep_turn(rows, turn));
        updates += FourContacts::rows * acting;
        for (std::size_t k = 0; k < FourContacts::count; ++k) stir(four.change[k], four.a[k], four.b[k]);
    }
    return largest;
}

}  // namespace pushfactor::engine
