// Sweeps of four contacts at once against one block after the other: equal to the last bit.
#include "engine/step/part_sweeps.h"

#include "engine/solvers/sweep.h"
#include "tests/catch.h"
#include "tests/engine/random_contacts.h"

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
    double sweep() {
        double largest = 0.0;
        for (const UnitRows::Block& block : rows.blocks) largest = std::max(largest, sweep(block));
        return largest;
    }
    double sweep_restless(double least, int number, bool all) {
        double largest = 0.0;
        for (const UnitRows::Block& block : rows.blocks) {
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

void load(const Frozen& frozen, const Island& island, UnitRows& rows, Random& random) {
    rows.load(frozen.system, island);
    Columns guess = frozen.zero();
    for (Eigen::Index j = 0; j < guess.rows(); ++j) guess(j, 0) = random.in(0, 1);
    rows.take(frozen.system, island, guess, 0);
    for (const UnitRows::Block& block : rows.blocks) rows.rows_of(block)->keeps = random.in(0.5, 1);
}

bool are_equal(const UnitRows& a, const UnitRows& b) {
    const auto same_force = [](const solvers::UnitRow& x, const solvers::UnitRow& y) {
        return x.y == y.y && x.t == y.t;
    };
    return a.velocity == b.velocity &&
           std::equal(a.rows.begin(), a.rows.end(), b.rows.begin(), b.rows.end(), same_force);
}

}  // namespace

TEST_CASE("contacts swept four at a time move as one after the other, to the last bit") {
    std::size_t packed = 0, single = 0, calm = 0;
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        const Frozen frozen = random_contacts(seed, RandomFriction::cone, 1.0);
        Islands islands;
        islands.find(frozen.system);
        for (const Island& island : islands.all()) {
            INFO("seed " << seed << ", island of body " << island.bodies.front());
            UnitRows expected, actual;
            Random random(seed), again(seed);
            load(frozen, island, expected, random);
            load(frozen, island, actual, again);
            OneByOne one{expected, std::vector<int>(static_cast<std::size_t>(island.movable()), PartSweeps::never)};
            std::vector<int> stirred = one.stirred, scratch(stirred.size());
            PartSweeps sweeps;
            sweeps.load(actual, 0, island.rows);
            actual.couple(sweeps.blocks());
            sweeps.pack(actual, scratch);
            for (const FourContacts& four : sweeps.fours()) {
                for (const int row : four.row) packed += row != FourContacts::none ? 1 : 0;
            }
            single += sweeps.blocks().size();

            double largest = 0.0;
            for (int k = 0; k < 3; ++k) {
                largest = one.sweep();
                REQUIRE(sweeps.sweep(actual) == largest);
            }
            double updates = 0.0;
            for (int k = 3; k < 20; ++k) {
                const double least = 0.05 * largest;
                const double change = one.sweep_restless(least, k, k == 3);
                REQUIRE(sweeps.sweep_restless(actual, least, k, k == 3, stirred, updates) == change);
                REQUIRE(stirred == one.stirred);
            }
            calm += updates < 17.0 * island.rows ? 1 : 0;
            REQUIRE(updates == one.updates);
            sweeps.unpack(actual);
            REQUIRE(are_equal(actual, expected));
            REQUIRE(sweeps.residual(actual) == expected.residual());
        }
    }
    // There is enough of each.
    CHECK(packed > 1000);
    CHECK(single > 1000);
    CHECK(calm > 20);  // islands of which some blocks were left out
}
