#include "demos/reports/cost/cost.h"

#include "demos/base/text/median.h"
#include "demos/runs/checkpoint.h"
#include "engine/collision/broad_phase.h"
#include "engine/forces/poke.h"

#include <fmt/format.h>

namespace pushfactor::demos::reports::cost {

namespace {

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

using Pairs = std::set<std::pair<int, int>>;

void add_pairs(const BuiltScene& scene, double margin, Counts& sum) {
    if (!scene.contacts) return;
    std::vector<engine::collision::Pose> poses;
    for (const engine::Body& body : scene.world.bodies) poses.push_back(engine::collision::pose_of(body));
    engine::collision::BroadPhase broad_phase;
    broad_phase.leave_out(scene.contacts->filter());
    sum.pairs += static_cast<double>(
        broad_phase.find_pairs(scene.contacts->colliders(), scene.world.bodies, poses, margin).size());
    Pairs touching;
    for (const engine::ContactSite& site : scene.contacts->sites()) touching.emplace(site.body_a, site.body_b);
    sum.touches += static_cast<double>(touching.size());
}

// Pairs per movable body, static partners included, up to which an island counts as a thread: 1 for a hanging or
// standing body, 1.6 and more where a body of the pendulum grid lies on others, about 3 for a heap.
constexpr double pairs_of_a_thread = 1.5;

IslandKind kind_of(const engine::Island& island) {
    if (island.movable() == 1) return IslandKind::single;
    Pairs pairs;
    for (const engine::RowRun& run : island.runs) pairs.emplace(std::minmax(run.a, run.b));
    const bool thread = static_cast<double>(pairs.size()) <= pairs_of_a_thread * island.movable();
    return thread ? IslandKind::thread : IslandKind::heap;
}

void add_islands(const engine::World& world, Counts& sum) {
    for (const engine::Island& island : world.islands().all()) {
        IslandCounts& counts = sum.islands[static_cast<std::size_t>(kind_of(island))];
        counts.by_way[static_cast<std::size_t>(world.outcome_of(island).method)] += 1.0;
    }
}

void add_step(const engine::StepCount& step, Counts& sum) {
    using engine::RowKind;
    static_assert(engine::row_kind_count == 7, "each kind is counted below");
    sum.contact_rows += step.rows(RowKind::contact);
    sum.friction_rows += step.rows(RowKind::friction);
    sum.distance_rows += step.rows(RowKind::distance) + step.rows(RowKind::spring);
    sum.joint_rows += step.rows(RowKind::joint) + step.rows(RowKind::motor) + step.rows(RowKind::limit);
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

Walk::Walk(const Choices& moment)
    : scene_(build_scene(moment)),
      dt_(moment.settings.dt.value()),
      division_(division_of(scene_, moment.settings)) {
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
