#include "engine/collision/broad_phase.h"

#include "engine/collision/detector.h"
#include "tests/catch.h"
#include "tests/random.h"

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace pushfactor::engine;
using namespace pushfactor::engine::collision;
using pushfactor::tests::Random;

namespace {

struct Crowd {
    std::vector<Body> bodies;
    std::vector<Collider> colliders;
};

Crowd crowd(Random& random, int count, const Vector3& spread) {
    Crowd result;
    result.bodies.push_back(static_body({0, -1, 0}, random.rotation()));
    result.colliders.push_back({.body = 0, .shape = Plane{}});
    for (int i = 1; i <= count; ++i) {
        const Vector3 half = random.vector(0.1, 1.0);
        const Vector3 position = random.vector(-1, 1).cwiseProduct(spread);
        const bool fixed = i % 5 == 0;
        result.bodies.push_back(fixed ? static_body(position, random.rotation())
                                      : box_body(1.0, 2.0 * half, position, random.rotation()));
        result.colliders.push_back({.body = i, .shape = Box{half}});
        if (i % 3 == 0) result.colliders.back().shape = Sphere{half.x()};
        // Sizes over six decades.
        if (i % 7 == 0) result.colliders.back().shape = Sphere{std::pow(10.0, random.in(-3, 3))};
    }
    return result;
}

Vector3 reach_of(const Crowd& crowd, std::size_t k) {
    const Shape& shape = crowd.colliders[k].shape;
    if (const auto* sphere = std::get_if<Sphere>(&shape)) return Vector3::Constant(sphere->radius);
    return pose_of(crowd.bodies[k]).rotation.cwiseAbs() * std::get<Box>(shape).half_size;
}

bool boxes_overlap(const Crowd& crowd, std::size_t i, std::size_t j) {
    const auto reach = [&](std::size_t k) -> Vector3 { return reach_of(crowd, k); };
    const Vector3 distance = (crowd.bodies[i].position - crowd.bodies[j].position).cwiseAbs();
    return (distance.array() < (reach(i) + reach(j)).array()).all();
}

bool reaches_plane(const Crowd& crowd, std::size_t i) {
    const Vector3 up = crowd.bodies[0].orientation * Vector3::UnitY();
    const Vector3 reach = reach_of(crowd, i);
    return up.dot(crowd.bodies[i].position - crowd.bodies[0].position) < up.cwiseAbs().dot(reach);
}

// All pairs.
std::vector<Pair> by_comparing(const Crowd& scene) {
    std::vector<Pair> pairs;
    for (std::size_t i = 0; i < scene.colliders.size(); ++i) {
        for (std::size_t j = i + 1; j < scene.colliders.size(); ++j) {
            if (scene.bodies[i].is_static() && scene.bodies[j].is_static()) continue;
            const bool near = i == 0 ? reaches_plane(scene, j) : boxes_overlap(scene, i, j);
            if (near) pairs.push_back({static_cast<int>(i), static_cast<int>(j)});
        }
    }
    return pairs;
}

std::span<const Pair> pairs_in(BroadPhase& broad_phase, std::span<const Collider> colliders,
                               std::span<const Body> bodies) {
    std::vector<Pose> poses;
    for (const Body& body : bodies) poses.push_back(pose_of(body));
    return broad_phase.find_pairs(colliders, bodies, poses, 0.0);
}

}  // namespace

TEST_CASE("the broad phase finds what comparing all bounding boxes finds, in order") {
    Random random(7);
    for (const Vector3& spread : {Vector3(8, 2, 2), Vector3(1, 30, 1), Vector3(4, 4, 4)}) {
        const Crowd scene = crowd(random, 60, spread);
        const std::vector<Pair> expected = by_comparing(scene);
        BroadPhase broad_phase;
        const auto pairs = pairs_in(broad_phase, scene.colliders, scene.bodies);
        CHECK(!expected.empty());
        CHECK(std::vector<Pair>(pairs.begin(), pairs.end()) == expected);
    }
}

TEST_CASE("two colliders of one body and two static bodies never make a pair") {
    std::vector<Body> bodies{static_body(Vector3::Zero()), static_body(Vector3::Zero()),
                             box_body(1.0, Vector3::Ones(), Vector3::Zero())};
    const std::vector<Collider> colliders{{.body = 0, .shape = Box{}},
                                          {.body = 1, .shape = Box{}},
                                          {.body = 2, .shape = Box{}},
                                          {.body = 2, .shape = Box{}}};
    BroadPhase broad_phase;
    const auto pairs = pairs_in(broad_phase, colliders, bodies);
    const std::vector<Pair> expected{{0, 2}, {0, 3}, {1, 2}, {1, 3}};
    CHECK(std::vector<Pair>(pairs.begin(), pairs.end()) == expected);
}

TEST_CASE("a pair has the size of its smaller movable body and the root of the friction product") {
    const std::vector<Body> bodies{static_body(Vector3::Zero()), box_body(1.0, {4, 4, 4}, {0, 1.9, 0})};
    const std::vector<Collider> colliders{{.body = 0, .shape = Box{Vector3::Constant(0.1)}, .friction = 0.2},
                                          {.body = 1, .shape = Box{Vector3::Constant(2)}, .friction = 0.8}};
    Detector detector;
    const auto touches = detector.detect(colliders, bodies, {});
    REQUIRE(touches.size() == 1);
    CHECK(touches[0].size == 4.0);
    CHECK(touches[0].friction == Approx(0.4));
}

TEST_CASE("pairs do not depend on where the scene is, up to a million metres away") {
    Random random(8);
    const Crowd here = crowd(random, 60, {4, 4, 4});
    Crowd there = here;
    for (Body& body : there.bodies) body.position += Vector3(-1048576, 524288, 262144);
    BroadPhase one, other;
    const auto pairs = pairs_in(one, here.colliders, here.bodies);
    const auto moved = pairs_in(other, there.colliders, there.bodies);
    CHECK(std::vector<Pair>(pairs.begin(), pairs.end()) == std::vector<Pair>(moved.begin(), moved.end()));
}

TEST_CASE("pairs of a crowd that moves, some of it or all, are those of a search that begins anew in each step") {
    for (const int count : {40, 300}) {
        for (const double share : {0.02, 0.3, 1.0}) {
            Random random(9);
            Crowd scene = crowd(random, count, {8, 3, 8});
            BroadPhase broad_phase;
            for (int step = 0; step < 40; ++step) {
                for (std::size_t i = 1; i < scene.bodies.size(); ++i) {
                    Body& body = scene.bodies[i];
                    if (body.is_static() || random.in(0, 1) > share) continue;
                    body.position += random.vector(-0.5, 0.5) * std::pow(10.0, random.in(-3, 0.5));
                    body.orientation = random.rotation();
                }
                // A body that has become non-finite has no pairs, and the pairs of others are as before.
                if (step == 20) scene.bodies[1].position.x() = std::numeric_limits<double>::quiet_NaN();
                BroadPhase new_one;
                const auto expected = pairs_in(new_one, scene.colliders, scene.bodies);
                const auto pairs = pairs_in(broad_phase, scene.colliders, scene.bodies);
                INFO(count << " bodies, " << share << " of them move, step " << step);
                REQUIRE(std::vector<Pair>(pairs.begin(), pairs.end()) ==
                        std::vector<Pair>(expected.begin(), expected.end()));
            }
        }
    }
}

TEST_CASE("pairs of a crowd that trembles within the room of its boxes are those of a search that begins anew") {
    Random random(10);
    Crowd scene = crowd(random, 300, {8, 3, 8});
    BroadPhase broad_phase;
    Awake awake(scene.colliders.size());
    std::vector<int> all(scene.colliders.size());
    std::iota(all.begin(), all.end(), 0);
    std::vector<char> sleeps(scene.colliders.size(), 0);
    for (int step = 0; step < 200; ++step) {
        std::vector<int> changed;  // fall asleep or wake
        if (step % 40 == 25) changed = {1 + step % 100};
        if (step == 100 || step == 102 || step == 150) changed = all;  // all rest; half of them
        for (const int i : changed) sleeps[static_cast<std::size_t>(i)] = step == 100 || i % 2 == 0;
        if (step == 101) changed = {2}, sleeps[2] = 0;
        awake.update(changed, [&](int i) { return sleeps[static_cast<std::size_t>(i)] == 0; });
        std::vector<int> moved = step == 0 ? all : changed;
        for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
            Body& body = scene.bodies[i];
            const double way = std::pow(10.0, random.in(-6, -3));
            if (body.is_static() || awake.has(static_cast<int>(i))) moved.push_back(static_cast<int>(i));
            if (!body.is_static() && awake.has(static_cast<int>(i))) body.position += random.vector(-way, way);
        }
        // One leaves its room, in each direction in turn.
        const auto leaver = static_cast<std::size_t>(1 + step);
        if (step % 4 == 3 && awake.has(1 + step)) scene.bodies[leaver].position[step % 3] += step % 8 - 5.0;
        if (step % 30 == 15) scene.bodies[0].position.y() += 0.1;  // the plane
        std::sort(moved.begin(), moved.end());
        moved.erase(std::unique(moved.begin(), moved.end()), moved.end());
        std::vector<Pose> poses;
        for (const Body& body : scene.bodies) poses.push_back(pose_of(body));
        const auto found_by = [&](BroadPhase& search, const std::vector<int>& updated) {
            const auto pairs =
                search.find_pairs(scene.colliders, scene.bodies, poses, 0.0, nullptr, awake, updated);
            return std::vector<Pair>(pairs.begin(), pairs.end());
        };
        BroadPhase new_one;
        INFO("step " << step);
        REQUIRE(found_by(broad_phase, moved) == found_by(new_one, all));
    }
}

TEST_CASE("many boxes in a grid make the pairs that comparing all of them makes") {
    Random random(12);
    for (const Vector3& spread : {Vector3(20, 4, 4), Vector3(6, 6, 6)}) {
        const Crowd scene = crowd(random, 400, spread);
        const std::vector<Pair> expected = by_comparing(scene);
        BroadPhase broad_phase;
        const auto pairs = pairs_in(broad_phase, scene.colliders, scene.bodies);
        CHECK(std::vector<Pair>(pairs.begin(), pairs.end()) == expected);
    }
}
