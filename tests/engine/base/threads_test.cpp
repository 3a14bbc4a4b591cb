// Threads: every part of the work is done once, and the bits do not depend on their number.
#include "engine/base/threads.h"

#include "engine/step/small_steps.h"
#include "engine/system/dissection.h"
#include "tests/catch.h"
#include "tests/engine/contact_scene.h"
#include "tests/engine/rows.h"
#include "tests/random.h"
#include "tests/skip.h"

#include <atomic>
#include <chrono>
#include <ctime>
#include <functional>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <thread>

using namespace pushfactor::engine;
using pushfactor::tests::ContactScene;
using pushfactor::tests::Frozen;
using pushfactor::tests::Random;

namespace {

struct Heap {
    std::vector<Body> bodies;
    Frozen frozen;
};

// Bodies in a square grid, four high. Each touches those beside, behind and below it, and a few of them one far
// away, at points with friction on a disc. With `follows_others` some friction follows the force between other
// bodies.
Heap heap(std::uint64_t seed, int width, int length, bool follows_others = false) {
    Random random(seed);
    std::vector<Body> bodies{static_body(Vector3::Zero())};
    std::vector<ConstraintRow> rows;
    const auto add_point = [&](int a, int b) {
        const int normal = static_cast<int>(rows.size());
        for (int k = 0; k < 3; ++k) {
            ConstraintRow& row = rows.emplace_back();
            row.body_a = a;
            row.body_b = b;
            row.jacobian.b = stacked(Vector3::Unit((k + 1) % 3), random.vector(-1, 1));
            if (a > 0) row.jacobian.a = -row.jacobian.b;
            row.bounds.c_min = 0.0;
            if (k == 0) continue;
            const int leader = k == 2 ? rows[static_cast<std::size_t>(normal) + 1].bounds.of_row : normal;
            const bool other = follows_others && k == 1 && normal > 30 && random.in(0, 1) < 0.02;
            row.bounds = {.c_min = -0.5, .c_max = 0.5, .of_row = other ? normal - 30 : leader};
            row.bounds.disc = k == 1 ? Disc::first : Disc::second;
        }
    };
    const auto number = [&](int x, int y, int z) { return 1 + (y * length + z) * width + x; };
    for (int y = 0; y < 4; ++y) {
        for (int z = 0; z < length; ++z) {
            for (int x = 0; x < width; ++x) {
                const Vector3 position = Vector3(x, y, z) + random.vector(-0.2, 0.2);
                bodies.push_back(box_body(random.in(0.1, 10), Vector3::Ones(), position, random.rotation()));
                bodies.back().force = Vector3(0, -10, 0) / bodies.back().inverse_mass;
                const int own = number(x, y, z);
                const auto touch = [&](int other) {
                    for (int point = static_cast<int>(random.in(1, 3)); point > 0; --point) add_point(other, own);
                };
                touch(y == 0 ? 0 : number(x, y - 1, z));
                if (x > 0) touch(number(x - 1, y, z));
                if (z > 0) touch(number(x, y, z - 1));
                if (random.in(0, 1) < 0.03) touch(1 + static_cast<int>(random.in(0, own - 1)));
            }
        }
    }
    return {bodies, Frozen(bodies, rows, 1.0 / 60.0)};
}

// The result of some small steps of the heap: forces and impulses.
struct Answer {
    Columns lambda;
    std::vector<double> moving;
    friend bool operator==(const Answer&, const Answer&) = default;
};

Answer in_small_steps(const Heap& heap, int threads) {
    const Frozen& frozen = heap.frozen;
    Islands islands;
    islands.find(frozen.system);
    REQUIRE(islands.all().size() == 1);
    SmallSteps small_steps;
    Answer answer{frozen.zero(), {}};
    ConstraintForces forces;
    forces.moving.assign(heap.bodies.size(), Vector6::Zero());
    forces.lasting = forces.moving;
    std::vector<Lambda> ending(frozen.rows.size());
    const auto solve = [&](Threads* some) {
        small_steps.solve(frozen.system, heap.bodies, islands.all().front(), {.steps = 3, .sweeps = 2}, {}, some,
                          answer.lambda, forces, ending);
    };
    if (threads > 0) {
        Threads some(threads);
        some.keep_at_hand([&] { solve(&some); });
    } else {
        solve(nullptr);
    }
    for (const Vector6& force : forces.moving) {
        answer.moving.insert(answer.moving.end(), force.data(), force.data() + 6);
    }
    return answer;
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

TEST_CASE("shared work is done once, by as many slots as there are threads, each for one at a time", "[threads]") {
    for (const int count : {1, 2, 5}) {
        Threads threads(count);
        CHECK(threads.count() == std::min(count, Threads::all()));
        const auto check = [&](std::size_t size) {
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
        };
        const auto check_all = [&] {
            for (const std::size_t size : {0u, 1u, 7u, 1000u, 100000u}) check(size);
        };
        check_all();
        for (int round = 0; round < 50; ++round) threads.keep_at_hand(check_all);
    }
    CHECK(Threads::all() >= 1);
    CHECK(Threads(0).count() == 1);
}

TEST_CASE("a team meets after each round of its work, outside of keep_at_hand() it is the caller alone",
          "[threads]") {
    Threads threads(2);
    const auto count_rounds = [&] {
        std::vector<int> rounds(static_cast<std::size_t>(threads.count()), 0);
        std::atomic<int> members = 0;
        std::atomic<bool> together = true;
        threads.as_team([&](Team& team) {
            ++members;
            for (int round = 1; round <= 100; ++round) {
                rounds[static_cast<std::size_t>(team.member())] = round;
                team.wait_for_all();
                for (int k = 0; k < team.size(); ++k) {
                    if (rounds[static_cast<std::size_t>(k)] != round) together = false;
                }
                team.wait_for_all();
            }
        });
        CHECK(together);
        return members.load();
    };
    CHECK(count_rounds() == 1);
    for (int k = 0; k < 20; ++k) {
        threads.keep_at_hand([&] {
            for (int job = 0; job < 50; ++job) count_rounds();
        });
    }
}

TEST_CASE("what is thrown in shared work reaches the caller, and the threads go on", "[threads]") {
    Threads threads(2);
    const auto throw_at = [&](std::size_t bad) {
        threads.share(1000, 10, [bad](std::size_t begin, std::size_t end, int) {
            if (begin <= bad && bad < end) throw std::runtime_error("here");
        });
    };
    threads.keep_at_hand([&] {
        for (const std::size_t bad : {0u, 500u, 999u}) CHECK_THROWS_AS(throw_at(bad), std::runtime_error);
        throw_at(1000);
    });
    CHECK_THROWS_AS(threads.keep_at_hand([&] { throw_at(3); }), std::runtime_error);
    threads.keep_at_hand([&] { throw_at(1000); });
}

TEST_CASE("a search finds in order, whatever the number of threads", "[threads]") {
    std::vector<int> numbers(30000);
    std::iota(numbers.begin(), numbers.end(), 0);
    Threads threads(2);
    threads.keep_at_hand([&] {
        Search<int> search;
        for (Threads* some : {static_cast<Threads*>(nullptr), &threads}) {
            std::vector<int> found{-3};
            search.append_to(found, some, numbers.size(), 100, [&](std::size_t begin, std::size_t end, auto& own) {
                for (std::size_t i = begin; i < end; ++i) {
                    if (numbers[i] % 3 == 0) own.push_back(numbers[i]);
                }
            });
            REQUIRE(found.size() == 10001);
            for (std::size_t k = 0; k < found.size(); ++k) REQUIRE(found[k] == 3 * (static_cast<int>(k) - 1));
        }
    });
}

TEST_CASE("the parts of a dissected island hold every row and body once, and those of a round share no body") {
    for (const std::uint64_t seed : {1u, 2u}) {
        const Heap scene = heap(seed, 14, 14);
        Islands islands;
        islands.find(scene.frozen.system);
        const Island& island = islands.all().front();
        Dissection dissection;
        dissection.cut(scene.bodies, island);
        REQUIRE(dissection.leaves().size() >= 4);
        std::vector<int> rows_seen(scene.frozen.rows.size(), 0), bodies_seen(scene.bodies.size(), 0);
        int next_row = 0, next_body = 0, crossing = 0;
        for (std::size_t k = 0; k < dissection.rounds().size(); ++k) {
            std::vector<int> part_of(scene.bodies.size(), -1);
            for (std::size_t p = 0; p < dissection.rounds()[k].size(); ++p) {
                const Dissection::Part& part = dissection.rounds()[k][p];
                int last = -1;
                for (const RowRun& run : part.runs) {
                    REQUIRE(run.first == next_row);
                    REQUIRE(run.begin > last);
                    last = run.begin;
                    for (int j = run.begin; j < run.end; ++j) ++rows_seen[static_cast<std::size_t>(j)];
                    next_row += run.end - run.begin;
                    if (k > 0) crossing += run.end - run.begin;
                    const ConstraintRow& row = scene.frozen.rows[static_cast<std::size_t>(run.begin)];
                    for (const auto& [number, body] :
                         {std::pair{run.a, row.body_a}, std::pair{run.b, row.body_b}}) {
                        if (number >= island.movable()) continue;
                        REQUIRE(dissection.island().bodies[static_cast<std::size_t>(number)] == body);
                        int& part_of_body = part_of[static_cast<std::size_t>(body)];
                        REQUIRE((part_of_body < 0 || part_of_body == static_cast<int>(p)));
                        part_of_body = static_cast<int>(p);
                    }
                }
            }
        }
        for (const Dissection::Leaf& leaf : dissection.leaves()) {
            REQUIRE(leaf.begin == next_body);
            next_body = leaf.end;
        }
        for (const int body : dissection.island().bodies) ++bodies_seen[static_cast<std::size_t>(body)];
        CHECK(next_row == island.rows);
        CHECK(next_body == island.movable());
        CHECK(std::all_of(rows_seen.begin(), rows_seen.end(), [](int times) { return times == 1; }));
        CHECK(std::all_of(bodies_seen.begin() + 1, bodies_seen.end(), [](int times) { return times == 1; }));
        CHECK(crossing > 0);
        CHECK(crossing <= island.rows / 5);
    }
}

TEST_CASE("what is narrow, small, or has rows that follow those of other bodies is left whole, in its own order") {
    for (const Heap& scene : {heap(1, 1, 100, true), heap(1, 14, 14, true), heap(2, 5, 5)}) {
        Islands islands;
        islands.find(scene.frozen.system);
        const Island& island = islands.all().front();
        Dissection dissection;
        dissection.cut(scene.bodies, island);
        CHECK(dissection.part_count() == 1);
        CHECK(dissection.island().runs.data() == island.runs.data());
        CHECK(dissection.island().bodies.data() == island.bodies.data());
    }
    // All in one vertical line: a plane between two of them would be horizontal.
    Heap tower = heap(3, 14, 14);
    for (Body& body : tower.bodies) body.position.x() = body.position.z() = 0.0;
    Islands islands;
    islands.find(tower.frozen.system);
    Dissection dissection;
    dissection.cut(tower.bodies, islands.all().front());
    CHECK(dissection.part_count() == 1);
}

namespace {

// The bodies of each part, in order.
std::vector<std::vector<int>> leaves_of(const Heap& heap) {
    Islands islands;
    islands.find(heap.frozen.system);
    Dissection dissection;
    dissection.cut(heap.bodies, islands.all().front());
    std::vector<std::vector<int>> leaves;
    for (const Dissection::Leaf& leaf : dissection.leaves()) {
        const auto bodies = dissection.island().bodies.subspan(static_cast<std::size_t>(leaf.begin),
                                                               static_cast<std::size_t>(leaf.end - leaf.begin));
        leaves.emplace_back(bodies.begin(), bodies.end());
    }
    return leaves;
}

Heap turned(Heap heap, const Quaternion& turn, const Vector3& shift, double force) {
    for (Body& body : heap.bodies) {
        body.position = turn * body.position + shift;
        body.force = force * (turn * body.force);
    }
    return heap;
}

}  // namespace

TEST_CASE("the cuts of an island turn with it and with its forces, also where it is regular, and without forces") {
    Random random(12);
    for (const bool regular : {false, true}) {
        for (const double force : {1.0, 0.0}) {
            Heap scene = heap(5, 14, 14);
            if (regular) {  // columns of four in a square
                for (std::size_t i = 1; i < scene.bodies.size(); ++i) {
                    scene.bodies[i].position = scene.bodies[i].position.array().round();
                }
            }
            const auto expected = leaves_of(turned(scene, Quaternion::Identity(), {0, 0, 0}, force));
            REQUIRE(expected.size() >= 4);
            for (int i = 0; i < 10; ++i) {
                INFO("regular " << regular << ", force " << force << ", turn " << i);
                CHECK(leaves_of(turned(scene, random.rotation(), random.vector(-5, 5), force)) == expected);
            }
        }
    }
}

TEST_CASE("small steps of a heap have the bits of one thread on any number of them", "[threads]") {
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
        for (const bool follows_others : {false, true}) {
            const Heap scene = heap(seed, 14, 14, follows_others);
            REQUIRE(scene.frozen.rows.size() > Dissection::least_rows);
            const Answer one = in_small_steps(scene, 0);
            for (const int threads : {1, 2, 3, 8}) {
                INFO("seed " << seed << ", " << threads << " threads");
                CHECK(in_small_steps(scene, threads) == one);
            }
        }
    }
}

TEST_CASE("a world of many islands and a heap has the same bits with any number of threads", "[threads]") {
    const std::uint64_t one = hash_with(1);
    for (const int threads : {2, 3, 8}) CHECK(hash_with(threads) == one);
}

TEST_CASE(
    "after one of its threads was kept from running the caller works alone for some calls, not after long work",
    "[threads]") {
    Threads threads(2);
    if (threads.count() < 2) return pushfactor::tests::skip("this machine has one core");
    constexpr auto long_time = std::chrono::milliseconds(50);
    enum class Helper { in_time, sleeps, works };
    std::atomic<bool> had_cores = true;
    // Calls `work`, which does not sleep, and notes if other programs took the core for a twentieth of the time.
    const auto awake = [&](const auto& work) {
        const auto seconds = [](clockid_t clock) {
            std::timespec now{};
            clock_gettime(clock, &now);
            return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
        };
        const double begun = seconds(CLOCK_MONOTONIC), ran = seconds(CLOCK_THREAD_CPUTIME_ID);
        work();
        const double all = seconds(CLOCK_MONOTONIC) - begun;
        if (seconds(CLOCK_THREAD_CPUTIME_ID) - ran < 0.95 * all) had_cores = false;
    };
    // The largest team of some jobs; stops at a team of two, whose helper then is late at their meeting if asked
    // to.
    const auto largest_team = [&](Helper helper) {
        const auto be_late = [&] {
            if (helper == Helper::sleeps) std::this_thread::sleep_for(long_time);
            if (helper != Helper::works) return;
            awake([end = std::chrono::steady_clock::now() + long_time] {
                while (std::chrono::steady_clock::now() < end) {
                }
            });
        };
        int largest = 0;
        threads.keep_at_hand([&] {
            for (int job = 0; job < (helper == Helper::in_time ? 100'000 : 10'000'000) && largest < 2; ++job) {
                threads.as_team([&](Team& team) {
                    if (team.member() == 0) largest = team.size();
                    if (team.member() > 0) be_late();
                    team.wait_for_all();
                });
            }
        });
        return largest;
    };
    // How many calls the caller then works alone; none if there was no team, whose helper could be late.
    const auto alone_after = [&](Helper helper) -> std::optional<int> {
        if (largest_team(helper) < 2) return {};
        int alone = 0;
        while (alone < 1000 && largest_team(Helper::in_time) == 1) ++alone;
        return alone;
    };
    std::optional<int> after_sleep, after_work;
    for (int attempt = 0; attempt < 10 && !(after_sleep && after_work); ++attempt) {
        if (!after_sleep) after_sleep = alone_after(Helper::sleeps);
        had_cores = true;
        std::optional<int> alone;
        awake([&] { alone = alone_after(Helper::works); });
        if (!after_work && had_cores) after_work = alone;
    }
    if (!after_sleep || !after_work) return pushfactor::tests::skip("no other core was free");
    CHECK(*after_sleep >= 8);
    CHECK(*after_sleep < 1000);
    CHECK(*after_work < 8);
}
