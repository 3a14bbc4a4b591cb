#include "demos/reports/cost/cost.h"

#include "demos/base/text/median.h"
#include "demos/runs/checkpoint.h"
#include "demos/runs/session.h"
#include "demos/scenes/catalogue.h"
#include "demos/scenes/named/side_by_side.h"
#include "demos/scenes/random.h"
#include "engine/collision/broad_phase.h"
#include "engine/forces/poke.h"

#include <fmt/format.h>

#include <algorithm>
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

Choices moment_of(const SceneDescription& scene, double start, const StopCheck& check) {
    Choices choices;
    choices.description = scene;
    choices.settings = preset_settings("default");
    choices.settings.rest = false;
    choices.settings.substeps = 1;
    choices.settings.threads = 1;
    return moment_at(choices, start, check);
}

// The largest distance between the movable bodies of the first part alone and the same bodies in the common world.
double distance(const Choices& alone, const Choices& together) {
    const BuiltScene a = build_scene(alone), b = build_scene(together);
    double largest = 0.0;
    std::size_t other = 0;
    for (const engine::Body& body : a.world.bodies) {
        if (body.is_static()) continue;
        while (b.world.bodies[other].is_static()) ++other;
        largest = std::max(largest, (body.position - b.world.bodies[other++].position).norm());
    }
    return largest;
}

using Pairs = std::vector<std::pair<int, int>>;

double count_different(Pairs pairs) {
    std::sort(pairs.begin(), pairs.end());
    return static_cast<double>(std::unique(pairs.begin(), pairs.end()) - pairs.begin());
}

void add_pairs(const BuiltScene& scene, double margin, Counts& sum) {
    if (!scene.contacts) return;
    std::vector<engine::collision::Pose> poses;
    for (const engine::Body& body : scene.world.bodies) poses.push_back(engine::collision::pose_of(body));
    engine::collision::BroadPhase broad_phase;
    broad_phase.leave_out(scene.contacts->filter());
    sum.pairs += static_cast<double>(
        broad_phase.find_pairs(scene.contacts->colliders(), scene.world.bodies, poses, margin).size());
    Pairs touching;
    for (const engine::ContactSite& site : scene.contacts->sites()) touching.emplace_back(site.body_a, site.body_b);
    sum.touches += count_different(touching);
}

// Pairs per movable body, static partners included, up to which an island counts as a thread: 1 for a hanging or
// standing body, 1.6 and more where a body of the pendulum grid lies on others, about 3 for a heap.
constexpr double pairs_of_a_thread = 1.5;

IslandKind kind_of(const engine::Island& island) {
    if (island.movable() == 1) return IslandKind::single;
    Pairs pairs;
    for (const engine::RowRun& run : island.runs) pairs.emplace_back(std::minmax(run.a, run.b));
    return count_different(pairs) <= pairs_of_a_thread * island.movable() ? IslandKind::thread : IslandKind::heap;
}

void add_islands(const engine::World& world, Counts& sum) {
    for (const engine::Island& island : world.islands().all()) {
        IslandCounts& counts = sum.islands[static_cast<std::size_t>(kind_of(island))];
        counts.by_way[static_cast<std::size_t>(world.outcome_of(island).method)] += 1.0;
    }
}

double& rows_in(engine::RowKind kind, Counts& counts) {
    switch (kind) {
        case engine::RowKind::friction:
            return counts.friction_rows;
        case engine::RowKind::distance:
        case engine::RowKind::spring:
            return counts.distance_rows;
        case engine::RowKind::joint:
        case engine::RowKind::motor:
        case engine::RowKind::limit:
            return counts.joint_rows;
        case engine::RowKind::contact:
            break;
    }
    return counts.contact_rows;
}

void add_step(const engine::StepCount& step, Counts& sum) {
    for (std::size_t k = 0; k < engine::row_kind_count; ++k) {
        const auto kind = static_cast<engine::RowKind>(k);
        rows_in(kind, sum) += step.rows(kind);
    }
    sum.columns += step.columns;
    sum.at_rest += step.at_rest;
    sum.sweeps += step.sweeps;
    sum.row_updates += step.row_updates;
    sum.multiply_adds += step.multiply_adds;
}

Counts means_of(Counts sum) {
    const double engine_steps = sum.substeps;
    const auto divide = [&](const CountColumn& column) {
        sum.*column.value /= column.of_engine_steps ? engine_steps : Walk::steps_counted;
    };
    std::ranges::for_each(row_columns, divide);
    std::ranges::for_each(work_columns, divide);
    for (IslandCounts& kind : sum.islands) {
        for (double& count : kind.by_way) count /= Walk::steps_counted;
    }
    return sum;
}

// CPU time of one pass over the steps of count_steps(), us per step.
double time_of_step(const Choices& moment) {
    Walk walk(moment);
    const double before = thread_cpu_us();
    walk.go(Walk::steps_counted);
    return (thread_cpu_us() - before) / Walk::steps_counted;
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

Parts parts_of(const BuiltScene& scene, const Settings& settings) {
    Parts parts;
    for (const auto& source : scene.world.forces) {
        parts.forces.emplace_back(dynamic_cast<const engine::PokeForce*>(source.get()) ? "poke" : "gravity");
    }
    if (scene.distances)
        parts.constraints.push_back(fmt::format("{} distances", scene.distances->distances().size()));
    if (scene.joints) parts.constraints.push_back(fmt::format("{} joints", scene.joints->joints().size()));
    if (scene.contacts) {
        parts.constraints.emplace_back("contacts");
        if (scene.contacts->friction()) parts.contacts.emplace_back("friction");
        if (scene.contacts->restitution() || scene.world.impacts) parts.contacts.emplace_back("restitution");
        if (scene.contacts->materials()) parts.contacts.emplace_back("materials");
        if (scene.contacts->filter()) parts.contacts.emplace_back("pairs left out");
        if (scene.contacts->continuous_collision()) parts.contacts.emplace_back("sweep");
        if (scene.contacts->cache()) parts.contacts.emplace_back("cache");
    }
    if (settings.substeps) return parts;
    for (const StepRule& rule : step_rules(scene)) parts.step_rules.emplace_back(rule.name);
    return parts;
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

SumOfParts measure(const Neighbours& scenes, int goes, const StopCheck& check) {
    const Choices together = moment_of(scenes.together, scenes.start, check);
    std::vector<Choices> parts;
    for (const SceneDescription& part : scenes.parts) parts.push_back(moment_of(part, scenes.start, check));

    SumOfParts sum{.name = scenes.together.name, .moved = distance(parts.front(), together)};
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

Choices moment_at(Choices choices, double seconds, const StopCheck& check) {
    Simulation simulation(choices);
    play(simulation, [&](const Simulation& run) {
        check();
        return run.sample().time < seconds;
    });
    choices.description = resumed(spelled_out(choices), simulation.scene(), simulation.checkpoint());
    return choices;
}

double clock_cost() {
    std::vector<double> costs(10001);
    double before = thread_cpu_us();
    for (double& cost : costs) {
        const double now = thread_cpu_us();
        cost = now - before;
        before = now;
    }
    return median(costs);
}

void PhaseClock::end(std::size_t stage) {
    const double now = thread_cpu_us();
    times_[stage] += now - last_ - cost_;
    last_ = now;
}

Walk::Walk(const Choices& moment)
    : scene_(build_scene(moment)),
      dt_(moment.settings.dt.value()),
      division_(moment.settings.substeps ? StepDivision(*moment.settings.substeps)
                                         : StepDivision(step_rules(scene_), scene_.parts_before.value_or(0.0))) {
    go(steps_before);
}

Counts count_steps(const Choices& moment) {
    Walk walk(moment);
    Counts sum;
    for (int i = 0; i < Walk::steps_counted; ++i) {
        sum.substeps += walk.step(nullptr, [&sum](const engine::StepCount& step) { add_step(step, sum); });
        add_pairs(walk.scene(), moment.settings.margin, sum);
        add_islands(walk.scene().world, sum);
    }
    return means_of(sum);
}

Times time_steps(const Choices& moment, int repeats, const StopCheck& check) {
    const double cost = clock_cost();
    std::vector<double> steps;
    std::array<std::vector<double>, phase_names.size()> stages;
    Times result;
    for (int i = 0; i < repeats; ++i) {
        check();
        steps.push_back(time_of_step(moment));
        check();
        const std::optional<double> before = heap_bytes();
        Walk walk(moment);
        PhaseClock clock(cost);
        walk.go(Walk::steps_counted, &clock);
        if (before) result.bytes = heap_bytes().value() - *before;
        for (std::size_t k = 0; k < stages.size(); ++k) stages[k].push_back(clock.times()[k] / Walk::steps_counted);
    }
    result.step = median(steps);
    for (std::size_t k = 0; k < stages.size(); ++k) result.stages[k] = std::max(0.0, median(stages[k]));
    return result;
}

}  // namespace pushfactor::demos::reports::cost
