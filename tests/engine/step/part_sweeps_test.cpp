// Sweeps of four contacts at once against one block after the other: equal to the last bit.
#include "engine/step/part_sweeps.h"

#include "engine/base/overloaded.h"
#include "engine/solvers/sweep.h"
#include "tests/catch.h"
#include "tests/engine/random_contacts.h"

#include <algorithm>

using namespace pushfactor::engine;
using namespace pushfactor::tests;
using solvers::UnitRows;

namespace {

// One block after the other, as PartSweeps describes its sweeps.
struct OneByOne {
    UnitRows& rows;
    std::vector<int> stirred;
    double updates = 0.0;

    double sweep(const UnitRows::Block& block) {
        return solvers::sweep<true>(rows, {&block, 1}, [&](const UnitRows::Block& b) { return rows.at_bodies(b); });
    }
    std::vector<UnitRows::Block> in_order(bool backwards) const {
        std::vector<UnitRows::Block> blocks = rows.blocks;
        if (backwards) std::reverse(blocks.begin(), blocks.end());
        return blocks;
    }
    double sweep(bool backwards) {
        double largest = 0.0;
        for (const UnitRows::Block& block : in_order(backwards)) largest = std::max(largest, sweep(block));
        return largest;
    }
    double sweep_restless(bool backwards, double least, int number, bool all) {
        double largest = 0.0;
        for (const UnitRows::Block& block : in_order(backwards)) {
            const auto last = [&](int body) {
                return body < rows.movable ? stirred[static_cast<std::size_t>(body)] : PartSweeps::never;
            };
            if (!all && last(block.a) < number - 1 && last(block.b) < number - 1) continue;
            const double change = sweep(block);
            largest = std::max(largest, change);
            updates += block.count;
            for (const int body : {block.a, block.b}) {
                if (change > least && body < rows.movable) stirred[static_cast<std::size_t>(body)] = number;
            }
        }
        return largest;
    }
};

Columns random_guess(const Frozen& frozen, Random& random) {
    Columns guess = frozen.zero();
    for (Eigen::Index j = 0; j < guess.rows(); ++j) guess(j, 0) = random.in(0, 1);
    return guess;
}

void load(const Frozen& frozen, const Island& island, const Columns& guess, UnitRows& rows, Random& random) {
    rows.load(frozen.system, island);
    rows.take(frozen.system, island, guess, 0);
    for (const UnitRows::Block& block : rows.blocks) rows.rows_of(block)->keeps = random.in(0.5, 1);
}

// The first unit row of a contact that is in a four.
int unit_row_of(const FourContacts& four, std::size_t k, const UnitRows& rows) {
    const auto found = std::find_if(rows.blocks.begin(), rows.blocks.end(),
                                    [&](const UnitRows::Block& block) { return block.of_step == four.row[k]; });
    return found->begin;
}

// Calls `visit(numbers in a four, row)` for each row in a four, and `visit(row, row)` for the others.
template <typename InFour, typename InBlock>
void each_row(PartSweeps& sweeps, UnitRows& actual, UnitRows& expected, const InFour& in_four,
              const InBlock& in_block) {
    for (FourContacts& four : sweeps.fours()) {
        for (std::size_t k = 0; k < FourContacts::count; ++k) {
            if (four.row[k] == FourContacts::none) continue;
            const int first = unit_row_of(four, k, expected);
            for (int i = 0; i < FourContacts::rows; ++i)
                in_four(four, i, k, expected.rows[static_cast<std::size_t>(first + i)]);
        }
    }
    for (const UnitRows::Block& block : sweeps.blocks()) {
        for (int i = 0; i < block.count; ++i) in_block(actual.rows_of(block)[i], expected.rows_of(block)[i]);
    }
}

// Targets and shares as in `expected`.
void take_targets(PartSweeps& sweeps, UnitRows& actual, UnitRows& expected) {
    each_row(
        sweeps, actual, expected,
        [](FourContacts& four, int i, std::size_t k, const solvers::UnitRow& row) {
            four.t[i][k] = row.t;
            if (i == 0) four.keeps[k] = row.keeps;
        },
        [](solvers::UnitRow& own, const solvers::UnitRow& row) {
            own.t = row.t;
            own.keeps = row.keeps;
        });
}

bool are_equal(PartSweeps& sweeps, UnitRows& actual, UnitRows& expected) {
    bool equal = actual.velocity == expected.velocity;
    each_row(
        sweeps, actual, expected,
        [&](const FourContacts& four, int i, std::size_t k, const solvers::UnitRow& row) {
            equal = equal && four.y[i][k] == row.y && four.t[i][k] == row.t;
        },
        [&](const solvers::UnitRow& own, const solvers::UnitRow& row) {
            equal = equal && own.y == row.y && own.t == row.t;
        });
    return equal;
}

// What is left to push apart: of contacts by random shares, of all others nothing.
void plan_apart(PartSweeps& sweeps, UnitRows& actual, UnitRows& expected, Random& random) {
    each_row(
        sweeps, actual, expected,
        [&](FourContacts& four, int i, std::size_t k, solvers::UnitRow& row) {
            if (i > 0) return;
            four.t[0][k] = row.t = random.in(-1, 1);
            four.y[0][k] = row.y = 0.0;
            four.holds[k] = -1;
        },
        [](const solvers::UnitRow&, const solvers::UnitRow&) {});
}

}  // namespace

TEST_CASE("contacts swept four at a time in either direction move as one after the other, to the last bit") {
    std::size_t packed = 0, single = 0, calm = 0;
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        const Frozen frozen = random_contacts(seed, RandomFriction::cone, 1.0);
        Islands islands;
        islands.find(frozen.system);
        for (const Island& island : islands.all()) {
            INFO("seed " << seed << ", island of body " << island.bodies.front());
            UnitRows expected, actual;
            Random random(seed);
            const Columns guess = random_guess(frozen, random);
            load(frozen, island, guess, expected, random);
            OneByOne one{expected, std::vector<int>(static_cast<std::size_t>(island.movable()), PartSweeps::never)};
            std::vector<int> stirred = one.stirred, scratch(stirred.size());
            PartSweeps sweeps;
            actual.begin(island);
            std::fill(actual.velocity.begin(), actual.velocity.end(), Vector6::Zero());
            sweeps.load({frozen.system, island, island.runs, guess, 0, frozen.system.dt}, actual, scratch);
            take_targets(sweeps, actual, expected);
            REQUIRE(are_equal(sweeps, actual, expected));
            for (const FourContacts& four : sweeps.fours()) {
                for (const int row : four.row) packed += row != FourContacts::none ? 1 : 0;
            }
            single += sweeps.blocks().size();

            double largest = 0.0;
            for (int k = 0; k < 3; ++k) {
                largest = one.sweep(k == 1);
                REQUIRE(sweeps.sweep(actual, k == 1) == largest);
            }
            double updates = 0.0;
            for (int k = 3; k < 20; ++k) {
                const double least = 0.05 * largest;
                const bool backwards = k % 3 == 0;
                const double change = one.sweep_restless(backwards, least, k, k == 3);
                REQUIRE(sweeps.sweep_restless(actual, backwards, least, k, k == 3, stirred, updates) == change);
                REQUIRE(stirred == one.stirred);
            }
            calm += updates < 17.0 * island.rows ? 1 : 0;
            REQUIRE(updates == one.updates);
            REQUIRE(are_equal(sweeps, actual, expected));
            REQUIRE(sweeps.residual(actual) == expected.residual());

            plan_apart(sweeps, actual, expected, random);
            sweeps.in_turn(Overloaded{
                [&](std::span<FourContacts> some) { push_apart(some, actual.velocity); },
                [](std::span<const UnitRows::Block>) {},
            });
            for (const UnitRows::Block& block : expected.blocks) {
                const auto is_single = [&](const UnitRows::Block& other) { return other.begin == block.begin; };
                if (std::any_of(sweeps.blocks().begin(), sweeps.blocks().end(), is_single)) continue;
                solvers::UnitRow& row = *expected.rows_of(block);
                expected.set(row, expected.clamped(row, row.y + expected.error(row)));
            }
            REQUIRE(are_equal(sweeps, actual, expected));
        }
    }
    // There is enough of each.
    CHECK(packed > 1000);
    CHECK(single > 1000);
    CHECK(calm > 20);  // islands of which some blocks were left out
}

// A point of contact that a later part of the step adds stands behind the rows of all islands.
TEST_CASE("a block whose rows stand apart in the step is loaded whole") {
    std::vector<Body> bodies{static_body(Vector3::Zero())};
    std::vector<ConstraintRow> rows;
    for (const int body : {1, 2, 1, 2}) {
        if (static_cast<int>(bodies.size()) == body)
            bodies.push_back(box_body(1.0, Vector3::Ones(), {2.0 * body, 0.5, 0}));
        ConstraintRow& row = rows.emplace_back();
        row.body_b = body;
        row.jacobian.b[1] = 1.0;
        row.jacobian.b[5] = rows.size() > 2 ? 0.5 : -0.5;
        row.bounds.c_min = 0.0;
        row.push.lasting = 1.0;
    }
    const Frozen frozen(bodies, rows, 0.01);
    Islands islands;
    islands.find(frozen.system);
    REQUIRE(islands.all().size() == 2);
    for (const Island& island : islands.all()) {
        UnitRows unit;
        unit.begin(island);
        std::fill(unit.velocity.begin(), unit.velocity.end(), Vector6::Zero());
        std::vector<int> scratch(1);
        PartSweeps sweeps;
        sweeps.load({frozen.system, island, island.runs, frozen.zero(), 0, frozen.system.dt}, unit, scratch);
        REQUIRE(sweeps.blocks().size() == 1);
        REQUIRE(sweeps.blocks().front().count == 2);
        for (int k = 0; k < 40; ++k) sweeps.sweep(unit, false);
        CHECK(sweeps.residual(unit) < 1e-9);
        CHECK(unit.velocity.front()[1] == Approx(1.0));  // scaled by the root of 1 kg
    }
}
