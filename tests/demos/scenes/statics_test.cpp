// Random members of structures whose limit mechanics gives: they stand on one side of it and fall on the other.
#include "demos/scenes/families/family.h"
#include "engine/bodies/diagnostics.h"
#include "tests/catch.h"
#include "tests/random.h"
#include "tests/scene_fixture.h"
#include "tests/settings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

using namespace pushfactor;
using namespace pushfactor::demos;
using engine::Body;
using engine::Quaternion;
using engine::Vector3;
using tests::Random;

namespace {

constexpr const char* both_presets[] = {"default", "exact"};

SceneDescription on_ground(double friction) {
    SceneDescription scene;
    scene.contacts = true;
    scene.bodies = {{.name = "ground", .shape = PlaneShape{}, .friction = friction}};
    return scene;
}

BodyDescription& add(SceneDescription& scene, const decltype(BodyDescription::shape)& shape,
                     const Vector3& position) {
    BodyDescription body{.name = "body " + std::to_string(scene.bodies.size()), .shape = shape, .mass = 1.0};
    body.position = position;
    body.friction = scene.bodies.front().friction;
    scene.bodies.push_back(body);
    return scene.bodies.back();
}

// After a run: how far the body that moved most has gone [m], and how far the last one has turned [rad].
struct End {
    double moved = 0.0, turned = 0.0;
};

End end_of(const SceneDescription& scene, const char* preset, double seconds) {
    const Settings settings = tests::awake_settings(preset);
    Simulation simulation(build_scene(scene, settings), settings);
    const std::vector<Body> start = simulation.scene().world.bodies;
    tests::advance(simulation, seconds);
    const std::vector<Body>& bodies = simulation.scene().world.bodies;
    End end{.moved = 0.0, .turned = bodies.back().orientation.angularDistance(start.back().orientation)};
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        end.moved = std::max(end.moved, (bodies[i].position - start[i].position).norm());
    }
    return end;
}

// The k-th block from the top is L / (2 k) farther out than the one below, times `share`: all are at their limit
// together at 1.
SceneDescription overhang(int blocks, double share, const Vector3& size, double friction) {
    SceneDescription scene = on_ground(friction);
    double x = 0.0;
    for (int i = 0; i < blocks; ++i) {
        if (i > 0) x += share * size.x() / (2.0 * (blocks - i));
        add(scene, BoxShape{size}, {x, (i + 0.5) * size.y(), 0});
    }
    return scene;
}

// A plank of mass M over a fulcrum of half width c, with loads at distances d and e from its middle. It tips over
// the edge of the fulcrum when m (d - c) exceeds n (e + c) + M c; `ratio` is that of these torques. The plank is
// the last body.
SceneDescription seesaw(Random& random, double ratio) {
    constexpr double length = 4.0, thickness = 0.1, height = 0.5, side = 0.3;  // m
    const double c = random.in(0.05, 0.3), d = random.in(0.6, 1.8), e = random.in(0.4, 1.8);
    const double plank = random.in(1.0, 20.0), other = random.in(0.5, 5.0);
    SceneDescription scene = on_ground(random.in(0.4, 1.0));
    add(scene, BoxShape{{2.0 * c, height, 1.0}}, {0, 0.5 * height, 0}).mass.reset();
    const double top = height + thickness;
    add(scene, BoxShape{Vector3::Constant(side)}, {d, top + 0.5 * side, 0}).mass =
        ratio * (other * (e + c) + plank * c) / (d - c);
    add(scene, BoxShape{Vector3::Constant(side)}, {-e, top + 0.5 * side, 0}).mass = other;
    add(scene, BoxShape{{length, thickness, 0.5}}, {0, height + 0.5 * thickness, 0}).mass = plank;
    return scene;
}

// A tower of layers of three blocks, each across the one below, of which some are missing.
struct Jenga {
    static constexpr double width = 0.25, height = 0.15;  // m

    std::vector<std::array<bool, 3>> layers;

    // Whether, for every layer, the centre of all that is above lies between its outer blocks, by more than a
    // twentieth of a block.
    bool stands() const {
        for (std::size_t k = 0; k + 1 < layers.size(); ++k) {
            double sum = 0.0, count = 0.0;
            for (std::size_t above = k + 1; above < layers.size(); ++above) {
                for (int i = 0; i < 3; ++i) {
                    if (!layers[above][static_cast<std::size_t>(i)]) continue;
                    count += 1.0;
                    if ((above - k) % 2 == 0) sum += i - 1;
                }
            }
            const auto& layer = layers[k];
            const double low = layer[0]   ? -1.5
                               : layer[1] ? -0.5
                                          : 0.5,
                         high = layer[2]   ? 1.5
                                : layer[1] ? 0.5
                                           : -0.5;
            if (sum / count < low + 0.05 || sum / count > high - 0.05) return false;
        }
        return true;
    }

    SceneDescription scene(double friction) const {
        SceneDescription scene = on_ground(friction);
        for (std::size_t k = 0; k < layers.size(); ++k) {
            for (int i = 0; i < 3; ++i) {
                if (!layers[k][static_cast<std::size_t>(i)]) continue;
                const double beside = (i - 1) * width, y = (static_cast<double>(k) + 0.5) * height;
                const bool across = k % 2 == 1;
                add(scene,
                    BoxShape{across ? Vector3(width, height, 3.0 * width) : Vector3(3.0 * width, height, width)},
                    across ? Vector3(beside, y, 0) : Vector3(0, y, beside));
            }
        }
        return scene;
    }
};

Jenga random_jenga(Random& random, int layers) {
    constexpr std::array<std::array<bool, 3>, 5> kinds{
        {{true, true, true}, {true, false, true}, {true, true, false}, {false, true, true}, {false, true, false}}};
    Jenga tower;
    do {
        tower.layers.clear();
        for (int k = 0; k < layers; ++k) tower.layers.push_back(kinds[static_cast<std::size_t>(random.in(0, 5))]);
        tower.layers.back() = kinds[0];
    } while (!tower.stands());
    return tower;
}

// A pyramid of touching balls with `side` of them along an edge of its base, which four bars hold together.
SceneDescription ball_pyramid(int side, double radius, double friction) {
    SceneDescription scene = on_ground(friction);
    const double half = side * radius;
    for (const int sign : {-1, 1}) {
        for (const bool along_x : {true, false}) {
            const double out = sign * (half + 0.5 * radius);
            add(scene,
                BoxShape{along_x ? Vector3(radius, 2.0 * radius, 4.0 * half)
                                 : Vector3(4.0 * half, 2.0 * radius, radius)},
                along_x ? Vector3(out, radius, 0) : Vector3(0, radius, out))
                .mass.reset();
        }
    }
    for (int layer = 0; layer < side; ++layer) {
        const double from = -(side - layer - 1) * radius, y = radius + layer * std::numbers::sqrt2 * radius;
        for (int i = 0; i < side - layer; ++i) {
            for (int k = 0; k < side - layer; ++k) {
                add(scene, SphereShape{radius}, {from + 2.0 * radius * i, y, from + 2.0 * radius * k});
            }
        }
    }
    return scene;
}

// A stack of flat boxes on a slope of `share` times the angle at which it begins to slide.
SceneDescription stack_on_slope(Random& random, double share) {
    const double mu = random.in(0.2, 0.8), angle = share * std::atan(mu), side = random.in(0.3, 1.0);
    const Quaternion tilt = Quaternion(Eigen::AngleAxisd(random.in(-3.1, 3.1), Vector3::UnitY())) *
                            Quaternion(Eigen::AngleAxisd(angle, Vector3::UnitZ()));
    SceneDescription scene = on_ground(mu);
    scene.bodies.front().orientation = tilt;
    double height = 0.0;
    for (int i = static_cast<int>(random.in(1, 5)); i > 0; --i) {
        const Vector3 size(side, side * random.in(0.1, 0.2), side);
        add(scene, BoxShape{size}, tilt * Vector3(0, height + 0.5 * size.y(), 0)).orientation = tilt;
        height += size.y();
    }
    return scene;
}

}  // namespace

TEST_CASE("overhangs of blocks stand at 0.9 to 0.99 of the limit and topple from 1.01 of it on") {
    Random random(1);
    for (const int blocks : {4, 8, 14}) {
        const Vector3 size(1.0, random.in(0.1, 0.3), random.in(0.3, 0.8));
        const double friction = random.in(0.4, 1.0), within = random.in(0.9, 0.99), beyond = random.in(1.01, 1.05);
        for (const char* preset : both_presets) {
            INFO(blocks << " blocks under " << preset << " at " << within << " and " << beyond);
            CHECK(end_of(overhang(blocks, within, size, friction), preset, 3.0).moved < 1e-6);
            CHECK(end_of(overhang(blocks, beyond, size, friction), preset, 8.0).turned > 0.2);
        }
    }
}

TEST_CASE("see-saws stay with 0.95 to 0.99 of the torque that tips them, and tip with 1.01 of it or more") {
    Random random(2);
    for (int i = 0; i < 6; ++i) {
        const SceneDescription stays = seesaw(random, random.in(0.95, 0.99));
        const SceneDescription tips = seesaw(random, random.in(1.01, 1.05));
        for (const char* preset : both_presets) {
            INFO("case " << i << " under " << preset);
            CHECK(end_of(stays, preset, 3.0).moved < 1e-6);
            CHECK(end_of(tips, preset, 6.0).turned > 0.05);
        }
    }
}

TEST_CASE("towers with blocks missing stand while the centre of what is above a layer lies between its blocks") {
    Random random(3);
    for (const int layers : {6, 12, 18}) {
        Jenga tower = random_jenga(random, layers);
        for (const char* preset : both_presets) {
            INFO(layers << " layers under " << preset);
            CHECK(end_of(tower.scene(0.6), preset, 2.0).moved < 1e-6);
        }
        // One side block cannot hold what is above it.
        tower.layers[static_cast<std::size_t>(layers / 3)] = {true, false, false};
        CHECK(!tower.stands());
        CHECK(end_of(tower.scene(0.6), "default", 2.0).moved > Jenga::height);
    }
}

TEST_CASE("pyramids of balls in a frame stand") {
    Random random(4);
    for (const int side : {2, 3, 4}) {
        const double radius = random.in(0.1, 0.5), friction = random.in(0.3, 0.8);
        for (const char* preset : both_presets) {
            INFO(side << " balls a side under " << preset);
            CHECK(end_of(ball_pyramid(side, radius, friction), preset, 2.0).moved < 1e-5);
        }
    }
}

TEST_CASE("stacks on slopes stick up to 0.97 of the angle of friction and slide beyond 1.03 of it") {
    Random random(5);
    for (int i = 0; i < 6; ++i) {
        const SceneDescription sticks = stack_on_slope(random, random.in(0.8, 0.97));
        const SceneDescription slides = stack_on_slope(random, random.in(1.03, 1.2));
        for (const char* preset : both_presets) {
            INFO("case " << i << " under " << preset);
            CHECK(end_of(sticks, preset, 3.0).moved < 1e-6);
            CHECK(end_of(slides, preset, 3.0).moved > 0.02);
        }
    }
}

// What a direct solution may cost grows with the structure: with a constant limit, or if only the first step may
// take one, these sag by centimetres.
TEST_CASE("towers of 800 planks and walls of 900 bricks do not move") {
    const families::Member tower = families::draw_member(*families::find_family("round-tower"),
                                                         {.given = {{"planks", "20"}, {"rings", "40"}}});
    const families::Member wall = families::draw_member(
        *families::find_family("wall"), {.given = {{"rows", "30"}, {"columns", "30"}, {"gap", "0"}}});
    for (const char* preset : both_presets) {
        INFO(preset);
        CHECK(end_of(tower.prospect.scene, preset, 0.5).moved < 1e-9);
        CHECK(end_of(wall.prospect.scene, preset, 0.2).moved < 1e-9);
    }
}

// With another number of small steps for what moves, the stiffness changed in the middle of each sway, which drove
// it like a swing: the column of 15 went from 0.07 to 0.35 m/s.
TEST_CASE("a column of bricks that sways calms down from second to second") {
    for (const auto& [count, sway] : {std::pair{10, 0.1}, {15, 0.05}, {15, 0.08}}) {
        INFO(count << " bricks, " << sway << " rad/s");
        SceneDescription scene;
        scene.name = "column";
        scene.contacts = true;
        scene.gravity = {0, -10, 0};
        scene.bodies.push_back({.name = "ground", .shape = PlaneShape{}, .friction = 0.7});
        for (int i = 0; i < count; ++i) {
            const double height = 0.25 * (i + 0.5);
            scene.bodies.push_back({.name = "brick " + std::to_string(i),
                                    .shape = BoxShape{{0.5, 0.25, 0.26}},
                                    .mass = 1.0,
                                    .position = {0, height, 0},
                                    .friction = 0.7});
            scene.bodies.back().velocity = {0, 0, sway * height};
        }
        const Settings settings = tests::awake_settings("default");
        Simulation simulation(build_scene(scene, settings), settings);
        double before = 1.0;
        for (int second = 0; second < 7; ++second) {
            double fastest = 0.0;
            for (int i = 0; i < 60; ++i) fastest = std::max(fastest, simulation.advance().max_speed);
            CHECK(fastest < std::max(0.8 * before, 1e-3));
            before = fastest;
        }
    }
}
