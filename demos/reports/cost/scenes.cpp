// The scenes that are measured: the list of cases, every part in one scene, scenes side by side.
#include "demos/reports/cost/cost.h"
#include "demos/scenes/catalogue.h"
#include "demos/scenes/named/side_by_side.h"
#include "demos/scenes/random.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace pushfactor::demos::reports::cost {

namespace {

using engine::Quaternion;
using engine::Vector3;
using scenes::Random;

constexpr double settled = 10.0, falling = 1.0;  // s
constexpr double no_force = 1e-12;               // N
constexpr double next_to_nothing = 1e-9;

struct Size {
    const char *name, *scene;
    OptionTexts options;
    bool large = false;
};

const std::vector<Size> sizes{
    {"stack of 20, touching", "stack", {{"count", "20"}, {"gap", "0"}}},
    {"stack of 40, touching, jittered", "stack", {{"count", "40"}, {"gap", "0"}, {"jitter", "0.01"}}, true},
    {"funnel of 200", "funnel", {{"count", "200"}}},
    {"funnel of 2000", "funnel", {{"count", "2000"}}, true},
};

SceneDescription on_the_ground(std::string name) {
    SceneDescription scene;
    scene.name = std::move(name);
    scene.contacts = true;
    scene.bodies.push_back({.name = "ground", .shape = PlaneShape{}});
    return scene;
}

void add_cube(SceneDescription& scene, const Vector3& position, double side = 1.0) {
    scene.bodies.push_back({.name = fmt::format("cube {}", scene.bodies.size()),
                            .shape = BoxShape{Vector3::Constant(side)},
                            .mass = 1.0,
                            .position = position});
}

SceneDescription tower(int count, double x) {
    SceneDescription scene = on_the_ground(fmt::format("tower of {}", count));
    for (int i = 0; i < count; ++i) add_cube(scene, {x, i + 0.5, 0});
    return scene;
}

SceneDescription loose_cubes(int count, double x) {
    SceneDescription scene = on_the_ground(fmt::format("{} loose cubes", count));
    const int side = static_cast<int>(std::ceil(std::sqrt(count)));
    for (int i = 0; i < count; ++i) add_cube(scene, {x + 2.0 * (i % side), 0.5, 2.0 * std::floor(i / side)});
    return scene;
}

// Balls that fall in layers between four walls, 4 m apart.
SceneDescription pit(int count) {
    constexpr double half = 2.0, radius = 0.3, spacing = 0.63;
    SceneDescription scene = on_the_ground(fmt::format("pit of {} balls", count));
    for (int k = 0; k < 4; ++k) {
        const double angle = 0.5 * std::numbers::pi * k;
        const Vector3 out(std::round(std::cos(angle)), 0, std::round(std::sin(angle)));
        const Vector3 across(std::abs(out.z()), 0, std::abs(out.x()));
        scene.bodies.push_back({.name = fmt::format("wall {}", k + 1),
                                .shape = BoxShape{0.5 * out.cwiseAbs() + 5.0 * across + Vector3(0, 4, 0)},
                                .position = (half + 0.25) * out + Vector3(0, 2, 0)});
    }
    Random random(1);
    const int side = static_cast<int>((2.0 * half - 2.0 * radius) / spacing);
    for (int i = 0; i < count; ++i) {
        const int layer = i / (side * side), place = i % (side * side);
        const double x = random.in(0.0, 0.02), z = random.in(0.0, 0.02);
        scene.bodies.push_back(
            {.name = fmt::format("ball {}", i + 1),
             .shape = SphereShape{radius},
             .mass = 1.0,
             .position = {x + radius + 0.05 - half + spacing * (place % side), radius + 0.05 + spacing * layer,
                          z + radius + 0.05 - half + spacing * std::floor(place / side)},
             .friction = 0.3});
    }
    return scene;
}

// Cubes of 0.4 m, turned at random, that fall in layers.
SceneDescription falling_pile(int count) {
    constexpr int side = 5;
    SceneDescription scene = on_the_ground(fmt::format("falling pile of {} cubes", count));
    Random random(2);
    for (int i = 0; i < count; ++i) {
        const int layer = i / (side * side), place = i % (side * side);
        Quaternion turn;
        for (double& part : turn.coeffs()) part = random.in(-1.0, 1.0);
        add_cube(scene, {0.75 * (place % side), 0.5 + 0.75 * layer, 0.75 * std::floor(place / side)}, 0.4);
        scene.bodies.back().orientation = turn.normalized();
    }
    return scene;
}

Neighbours beside(const std::vector<SceneDescription>& parts, double start) {
    return {parts, {1, 1}, scenes::side_by_side(parts[0].name + " and " + parts[1].name, parts), start};
}

// The same scene many times, at different x [m].
Neighbours many(const std::string& name, int count, int of, SceneDescription (*scene)(int of, double x)) {
    std::vector<SceneDescription> parts;
    for (int i = 0; i < count; ++i) parts.push_back(scene(of, 60.0 * i));
    return {{parts.front()}, {count}, scenes::side_by_side(name, parts), 1.0};
}

}  // namespace

std::vector<CostCase> cost_cases(bool quick) {
    std::vector<CostCase> cases;
    const auto add = [&cases](const std::string& name, const std::string& scene, const OptionTexts& options) {
        cases.push_back({name, scene, options, settled});
        if (scene == "funnel") cases.push_back({name + ", falling", scene, options, falling});
    };
    for (const SceneEntry& scene : catalogue()) {
        add(std::string(scene.name), std::string(scene.name), {});
        for (const Size& size : sizes) {
            if (scene.name == size.scene && !(quick && size.large)) add(size.name, size.scene, size.options);
        }
    }
    return cases;
}

SceneDescription with_everything(SceneDescription scene) {
    const auto body = std::ranges::find_if(scene.bodies, &std::optional<double>::has_value, &BodyDescription::mass);
    if (body == scene.bodies.end()) throw std::logic_error("a scene in which nothing moves");
    scene.forces.push_back({.body = body->name, .force = Vector3(0, -no_force, 0)});
    // A bar that yields at once: it never has its length, and so needs a correction in every step.
    const Vector3 above = body->position + Vector3(0, 2, 0);
    if (scene.distances.empty()) {
        scene.distances.push_back(
            {.a = {.point = above}, .b = {.body = body->name}, .length = 1.0, .max_force = no_force});
    }
    scene.contacts = true;
    for (BodyDescription& each : scene.bodies) {
        each.friction = std::max(each.friction, next_to_nothing);
        each.restitution = std::max(each.restitution, next_to_nothing);
    }
    for (const char* const push : {"push", "distance-push"}) scene.options[push] = "single-frame";
    scene.options["substeps"] = "auto";
    return scene;
}

std::vector<Neighbours> neighbours(bool quick) {
    const SceneDescription high = tower(20, -60.0);
    std::vector<Neighbours> all{beside({high, pit(40)}, 2.0), many("20 towers of 10", 20, 10, tower),
                                beside({high, falling_pile(50)}, 0.3)};
    if (quick) return all;
    all.push_back(beside({high, pit(200)}, 3.0));
    all.push_back(beside({high, falling_pile(200)}, 0.3));
    all.push_back(beside({pit(200), loose_cubes(600, 50.0)}, 3.0));
    all.push_back(many("4 fields of 500 loose cubes", 4, 500, loose_cubes));
    return all;
}

}  // namespace pushfactor::demos::reports::cost
