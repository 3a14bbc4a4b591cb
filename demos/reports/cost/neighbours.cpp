#include "demos/reports/cost/cost.h"
#include "demos/scenes/named/side_by_side.h"
#include "demos/scenes/random.h"
#include "demos/text/median.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pushfactor::demos::reports::cost {

namespace {

using engine::Quaternion;
using engine::Vector3;
using scenes::Random;

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
    const std::string name = parts[0].name + " and " + parts[1].name;
    return {name, parts, {1, 1}, scenes::side_by_side(name, parts), start};
}

// The same scene many times, at different x [m].
Neighbours many(const std::string& name, int count, int of, SceneDescription (*scene)(int of, double x)) {
    std::vector<SceneDescription> parts;
    for (int i = 0; i < count; ++i) parts.push_back(scene(of, 60.0 * i));
    return {name, {parts.front()}, {count}, scenes::side_by_side(name, parts), 1.0};
}

MeasuredState moment_of(const SceneDescription& scene, double start, const StopCheck& check) {
    Choices choices;
    choices.description = scene;
    choices.settings = preset_settings("default");
    choices.settings.rest = false;
    choices.settings.substeps = 1;
    choices.settings.threads = 1;
    return moment_at(choices, start, check);
}

// The largest distance between the movable bodies of the first part alone and the same bodies in the common world.
double distance(const MeasuredState& alone, const MeasuredState& together) {
    const BuiltScene a = alone.build(), b = together.build();
    double largest = 0.0;
    std::size_t other = 0;
    for (const engine::Body& body : a.world.bodies) {
        if (body.is_static()) continue;
        while (b.world.bodies[other].is_static()) ++other;
        largest = std::max(largest, (body.position - b.world.bodies[other++].position).norm());
    }
    return largest;
}

}  // namespace

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

SumOfParts measure(const Neighbours& scenes, int goes, const StopCheck& check) {
    const MeasuredState together = moment_of(scenes.together, scenes.start, check);
    std::vector<MeasuredState> parts;
    for (const SceneDescription& part : scenes.parts) parts.push_back(moment_of(part, scenes.start, check));

    SumOfParts sum{.name = scenes.name, .moved = distance(parts.front(), together)};
    const Counts counts = count_steps(together);
    for (const IslandCounts& kind : counts.islands) sum.islands += kind.all();
    sum.together_multiply_adds = counts.multiply_adds;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        sum.parts_multiply_adds += scenes.times[i] * count_steps(parts[i]).multiply_adds;
    }
    std::vector<double> of_parts, of_all, ratios;
    for (int go = 0; go < goes; ++go) {
        double part_us = 0.0;
        for (std::size_t i = 0; i < parts.size(); ++i) {
            check();
            part_us += scenes.times[i] * time_of_step(parts[i]);
        }
        check();
        of_parts.push_back(part_us);
        of_all.push_back(time_of_step(together));
        ratios.push_back(of_all.back() / part_us);
    }
    sum.parts_us = median(of_parts);
    sum.together_us = median(of_all);
    sum.ratio = median(ratios);
    return sum;
}

}  // namespace pushfactor::demos::reports::cost
