#include "demos/reports/cost/ledger.h"

#include "demos/platform/cpu_clock.h"
#include "demos/reports/cost/allocations.h"
#include "demos/runs/checkpoint.h"
#include "demos/runs/simulation.h"
#include "demos/runs/step_division.h"
#include "engine/collision/broad_phase.h"
#include "engine/solvers/auto.h"

#include <algorithm>

namespace pushfactor::demos::reports::cost {

namespace {

constexpr int steps_before = 30;  // memory has grown as far as it will, and the caches are warm
constexpr int steps_counted = 120;

// Takes the steps of a run and does nothing else.
class Walk {
  public:
    explicit Walk(const MeasuredState& moment)
        : scene_(moment.build()), dt_(moment.settings.dt.value()), division_(division_of(moment.settings)) {}

    BuiltScene& scene() { return scene_; }

    // One step of the run; `seen` is told of each engine step. Returns how many there were.
    template <typename Seen>
    int step(PhaseClock* clock, Seen seen) {
        if (clock) clock->begin();
        const int parts = division_.divide(scene_.world, dt_);
        if (clock) clock->rules_ended();
        for (int i = 0; i < parts; ++i) seen(scene_.world.step(dt_ / parts, clock));
        return parts;
    }

    void go(int steps, PhaseClock* clock = nullptr) {
        for (int i = 0; i < steps; ++i) step(clock, [](const engine::StepCount&) {});
    }

  private:
    StepDivision division_of(const Settings& settings) const {
        if (settings.substeps) return StepDivision(*settings.substeps);
        return StepDivision(step_rules(scene_), scene_.substeps_before.value_or(0.0));
    }

    BuiltScene scene_;
    double dt_;
    StepDivision division_;
};

double pairs_of(const BuiltScene& scene, double margin) {
    if (!scene.contacts) return 0.0;
    std::vector<engine::collision::Pose> poses;
    for (const engine::Body& body : scene.world.bodies) poses.push_back(engine::collision::pose_of(body));
    engine::collision::BroadPhase broad_phase;
    return static_cast<double>(
        broad_phase.find_pairs(scene.contacts->colliders(), scene.world.bodies, poses, margin).size());
}

double touches_of(const BuiltScene& scene) {
    if (!scene.contacts) return 0.0;
    const std::vector<engine::ContactSite> sites = scene.contacts->sites();
    std::vector<std::pair<int, int>> pairs;
    for (const engine::ContactSite& site : sites) pairs.emplace_back(site.body_a, site.body_b);
    std::sort(pairs.begin(), pairs.end());
    return static_cast<double>(std::unique(pairs.begin(), pairs.end()) - pairs.begin());
}

IslandKind kind_of(const engine::Island& island) {
    if (island.movable() == 1) return IslandKind::single;
    std::vector<std::pair<int, int>> pairs;
    for (const engine::RowRun& run : island.runs) pairs.emplace_back(std::minmax(run.a, run.b));
    std::sort(pairs.begin(), pairs.end());
    const auto count = static_cast<double>(std::unique(pairs.begin(), pairs.end()) - pairs.begin());
    return count <= engine::solvers::pairs_of_a_thread * island.movable() ? IslandKind::thread : IslandKind::heap;
}

void add_islands(const engine::World& world, std::array<IslandCounts, island_kinds.size()>& sum) {
    using Method = engine::WarmStart::Method;
    for (const engine::Island& island : world.islands().all()) {
        IslandCounts& counts = sum[static_cast<std::size_t>(kind_of(island))];
        const Method method = world.method_of(island);
        switch (method) {
            case Method::kept:
                counts.kept += 1.0;
                break;
            case Method::swept:
                counts.swept += 1.0;
                break;
            case Method::exact:
                counts.exact += 1.0;
                break;
            case Method::in_small_steps:
                counts.small_steps += 1.0;
        }
    }
}

void add_step(const engine::StepCount& step, Counts& sum) {
    sum.contact_rows += step.rows(engine::RowKind::contact);
    sum.friction_rows += step.rows(engine::RowKind::friction);
    sum.distance_rows += step.rows(engine::RowKind::distance);
    sum.columns += step.columns;
    sum.at_rest += step.at_rest;
    sum.sweeps += step.sweeps;
    sum.row_updates += step.row_updates;
    sum.multiply_adds += step.multiply_adds;
}

// What there is once a step is divided by the engine steps, the rest by the steps of the run.
Counts means_of(Counts sum) {
    for (double* each : {&sum.contact_rows, &sum.friction_rows, &sum.distance_rows, &sum.columns, &sum.at_rest}) {
        *each /= sum.substeps;
    }
    for (double* each : {&sum.substeps, &sum.pairs, &sum.touches, &sum.sweeps, &sum.row_updates, &sum.multiply_adds,
                         &sum.allocations, &sum.allocated_bytes}) {
        *each /= steps_counted;
    }
    for (IslandCounts& counts : sum.islands) {
        for (double* each : {&counts.kept, &counts.swept, &counts.exact, &counts.small_steps})
            *each /= steps_counted;
    }
    return sum;
}

PhaseTimes time_of_phases(const MeasuredState& moment, double cost) {
    Walk walk(moment);
    walk.go(steps_before);
    PhaseClock clock(cost);
    walk.go(steps_counted, &clock);
    return clock.times();
}

}  // namespace

MeasuredState moment_at(const Choices& choices, double seconds, const std::function<void()>& check) {
    Simulation simulation(choices);
    while (simulation.sample().time < seconds) {
        check();
        simulation.advance();
    }
    return {resumed(spelled_out(choices), simulation.scene(), simulation.checkpoint()), choices.settings};
}

Counts count_steps(const MeasuredState& moment) {
    Walk walk(moment);
    walk.go(steps_before);
    Counts sum;
    for (int i = 0; i < steps_counted; ++i) {
        const Allocations before = allocations();
        sum.substeps += walk.step(nullptr, [&sum](const engine::StepCount& step) { add_step(step, sum); });
        const Allocations taken = allocations() - before;
        sum.allocations += static_cast<double>(taken.count);
        sum.allocated_bytes += static_cast<double>(taken.bytes);
        sum.pairs += pairs_of(walk.scene(), moment.settings.margin);
        sum.touches += touches_of(walk.scene());
        add_islands(walk.scene().world, sum.islands);
    }
    return means_of(sum);
}

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

double time_of_step(const MeasuredState& moment) {
    Walk walk(moment);
    walk.go(steps_before);
    const double before = thread_cpu_us();
    walk.go(steps_counted);
    return (thread_cpu_us() - before) / steps_counted;
}

Times time_steps(const MeasuredState& moment, int repeats, const std::function<void()>& check) {
    const double cost = clock_cost();
    std::vector<double> steps;
    std::array<std::vector<double>, phase_names.size()> stages;
    for (int i = 0; i < repeats; ++i) {
        check();
        steps.push_back(time_of_step(moment));
        check();
        const PhaseTimes times = time_of_phases(moment, cost);
        for (std::size_t k = 0; k < times.size(); ++k) stages[k].push_back(times[k] / steps_counted);
    }
    Times result{.step = median(steps)};
    for (std::size_t k = 0; k < stages.size(); ++k) result.stages[k] = std::max(0.0, median(stages[k]));
    return result;
}

}  // namespace pushfactor::demos::reports::cost
