// Threads: every part of the work once, and the bits of one thread, whatever their number.
#include "engine/threads.h"

#include "engine/dissection.h"
#include "engine/solvers/sweep.h"
#include "tests/catch.h"
#include "tests/engine/contact_scene.h"
#include "tests/engine/rows.h"
#include "tests/random.h"

#include <atomic>

using namespace pushfactor::engine;
using namespace pushfactor::engine::solvers;
using pushfactor::tests::ContactScene;
using pushfactor::tests::Frozen;
using pushfactor::tests::Random;

namespace {

// A heap: every body touches some of those just before it, and now and then one far before, at points with friction
// on a disc; some friction follows the force between other bodies.
Frozen heap(std::uint64_t seed) {
    Random random(seed);
    std::vector<Body> bodies{static_body(Vector3::Zero())};
    std::vector<ConstraintRow> rows;
    for (int i = 1; i <= 300; ++i) {
        bodies.push_back(box_body(random.in(0.1, 10), Vector3::Ones(), random.vector(-1, 1), random.rotation()));
        bodies.back().force = Vector3(0, -10, 0) / bodies.back().inverse_mass;
        for (int pair = 0; pair < 4; ++pair) {
            const int below = random.in(0, 1) < 0.05 ? 1 + static_cast<int>(random.in(0, i - 1))
                                                     : i - 1 - static_cast<int>(random.in(0, 12));
            if (below >= i) continue;
            for (int point = static_cast<int>(random.in(1, 3)); point > 0; --point) {
                const int normal = static_cast<int>(rows.size());
                for (int k = 0; k < 3; ++k) {
                    ConstraintRow& row = rows.emplace_back();
                    row.body_a = std::max(0, below);
                    row.body_b = i;
                    row.jacobian.b = stacked(Vector3::Unit((k + 1) % 3), random.vector(-1, 1));
                    row.jacobian.a = -row.jacobian.b;
                    row.bounds.c_min = 0.0;
                    if (k == 0) continue;
                    row.bounds = {.c_min = -0.5, .c_max = 0.5, .of_row = normal};
                    if (normal > 30 && random.in(0, 1) < 0.02) row.bounds.of_row = normal - 30;
                    row.bounds.disc = k == 1 ? Disc::first : Disc::second;
                    if (k == 2) row.bounds.of_row = rows[static_cast<std::size_t>(normal) + 1].bounds.of_row;
                }
            }
        }
    }
    return {bodies, rows, 1.0 / 60.0};
}

// What some rounds of sweeps leave.
std::vector<double> swept(const Frozen& frozen, int sweeps, int threads) {
    Islands islands;
    islands.find(frozen.system);
    REQUIRE(islands.all().size() == 1);
    REQUIRE(frozen.rows.size() > SweepPipeline::least_rows);
    UnitRows<1> rows;
    rows.load(frozen.system, islands.all().front(), frozen.zero());
    Threads some(threads);
    SweepPipeline pipeline;
    if (threads > 0) pipeline.plan(rows);
    for (int round = 0; round < 5; ++round) {
        if (threads > 0) {
            std::atomic<std::size_t> before = 0, after = 0;
            pipeline.sweep(
                rows, sweeps, some, [&](std::size_t begin, std::size_t end) { before += end - begin; },
                [&](std::size_t begin, std::size_t end) { after += end - begin; });
            CHECK(before == rows.rows.size());
            CHECK(after == rows.rows.size());
        } else {
            for (int k = 0; k < sweeps; ++k) sweep(rows);
        }
    }
    std::vector<double> all;
    for (const auto& row : rows.rows) all.push_back(row.y[0]);
    for (int body = 0; body < rows.movable; ++body) {
        all.insert(all.end(), rows.x_of(body).data(), rows.x_of(body).data() + 6);
    }
    return all;
}

// Towers, a wall, a heap and what falls on them.
std::uint64_t hash_with(int threads) {
    ContactScene scene;
    scene.add_ground();
    for (int tower = 0; tower < 20; ++tower) {
        for (int i = 0; i < 10; ++i) scene.add_box(Vector3::Ones(), {3.0 * tower, 0.5 + i, 0.01 * i});
    }
    Random random(3);
    for (int i = 0; i < 500; ++i) {
        scene.add_ball(0.3, {random.in(-6, 6), 0.5 + 0.08 * i, 20 + random.in(-3, 3)});
    }
    scene.build();
    scene.world.small_steps = std::make_unique<SmallSteps>();
    if (threads > 1) scene.world.threads = std::make_unique<Threads>(threads);
    for (int i = 0; i < 90; ++i) scene.world.step(ContactScene::dt);
    return state_hash(scene.world.bodies);
}

}  // namespace

TEST_CASE("shared work is done once, by as many slots as there are threads, each for one at a time") {
    for (const int count : {1, 2, 5}) {
        Threads threads(count);
        CHECK(threads.count() == std::min(count, Threads::all()));
        for (const std::size_t size : {0u, 1u, 7u, 1000u, 100000u}) {
            std::vector<std::atomic<int>> done(size), busy(static_cast<std::size_t>(threads.count()));
            std::atomic<bool> alone = true;
            threads.share(size, 10, [&](std::size_t begin, std::size_t end, int slot) {
                auto& own = busy.at(static_cast<std::size_t>(slot));
                if (own.fetch_add(1) != 0) alone = false;
                for (std::size_t i = begin; i < end; ++i) ++done[i];
                own.fetch_sub(1);
            });
            CHECK(alone);
            CHECK(std::all_of(done.begin(), done.end(), [](const auto& times) { return times == 1; }));
        }
        std::atomic<int> calls = 0;
        threads.together([&] { ++calls; });
        CHECK(calls >= 1);
    }
    CHECK(Threads::all() >= 1);
    CHECK(Threads(0).count() == 1);
}

TEST_CASE("sweeps that follow each other through an island have the bits of one after the other") {
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
        const Frozen frozen = heap(seed);
        for (const int sweeps : {1, 2, 3, 8}) {
            const std::vector<double> one = swept(frozen, sweeps, 0);
            for (const int threads : {1, 2, 3, 8}) {
                INFO("seed " << seed << ", " << sweeps << " sweeps, " << threads << " threads");
                CHECK(swept(frozen, sweeps, threads) == one);
            }
        }
    }
}

TEST_CASE("a world of many islands and a heap has the same bits with any number of threads") {
    const std::uint64_t one = hash_with(1);
    for (const int threads : {2, 3, 8}) CHECK(hash_with(threads) == one);
}
