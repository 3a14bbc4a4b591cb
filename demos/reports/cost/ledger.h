// The ledger of a scene: work and time of its steps.
#pragma once

#include "demos/options/choices.h"
#include "demos/reports/cost/scenes.h"
#include "demos/runs/step_division.h"

#include <array>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

namespace pushfactor::demos::reports::cost {

// A scene at the time from which its steps are counted; each build of it takes the same steps.
struct MeasuredState {
    SceneDescription description;
    Settings settings;

    BuiltScene build() const { return build_scene(description, settings); }
};

// Runs up to `seconds`. Calls `check` often, which may throw.
MeasuredState moment_at(const Choices& choices, double seconds, const std::function<void()>& check);

// Stages of a step of the run: the rules for substeps, then engine::Phase.
inline constexpr std::array<std::string_view, 7> phase_names{"rules", "forces",   "rows",     "system",
                                                             "solve", "remember", "integrate"};
using PhaseTimes = std::array<double, phase_names.size()>;  // us

// Time of reading the clock [us], median of many.
double clock_cost();

// CPU time of the stages of steps, without the time of reading the clock.
class PhaseClock : public engine::PhaseObserver {
  public:
    explicit PhaseClock(double cost) : cost_(cost) {}

    void begin();  // right before the rules are evaluated
    void rules_ended() { end(0); }
    void phase_ended(engine::Phase stage) override { end(1 + static_cast<std::size_t>(stage)); }

    const PhaseTimes& times() const { return times_; }  // the sum of all steps

  private:
    void end(std::size_t stage);

    double cost_, last_ = 0.0;
    PhaseTimes times_{};
};

// Takes the steps of a run without measurements.
class Walk {
  public:
    static constexpr int steps_before = 30;  // warm-up: until memory no longer grows and the caches are warm
    static constexpr int steps_counted = 120;

    explicit Walk(const MeasuredState& moment);  // has taken `steps_before`

    BuiltScene& scene() { return scene_; }

    // One step of the run; `seen` is called with the count of each engine step. Returns their number.
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
    BuiltScene scene_;
    double dt_;
    StepDivision division_;
};

// Islands by connectivity: one body, at most 1.5 pairs per body, more.
enum class IslandKind { single, thread, heap };
inline constexpr std::array<std::string_view, 3> island_kinds{"single", "thread", "heap"};

// Islands of a kind by method: last forces kept, solved by sweeps, solved exactly, in small steps.
struct IslandCounts {
    double kept = 0.0, swept = 0.0, exact = 0.0, small_steps = 0.0;

    double all() const { return kept + swept + exact + small_steps; }
};

// Means per step of the run over the counted steps.
struct Counts {
    double substeps = 0.0;
    double pairs = 0.0;    // with overlapping bounding boxes
    double touches = 0.0;  // pairs with contact points
    double contact_rows = 0.0, friction_rows = 0.0, distance_rows = 0.0, columns = 0.0;
    double joint_rows = 0.0;                                  // motors and limits included
    double at_rest = 0.0;                                     // sleeping bodies
    std::array<IslandCounts, island_kinds.size()> islands{};  // of the last engine step in each step of the run
    double sweeps = 0.0;         // iterations of any solver, of the island with the most
    double row_updates = 0.0;    // rows x columns x iterations, sum over islands
    double multiply_adds = 0.0;  // of the solver

    double rows() const { return contact_rows + friction_rows + distance_rows + joint_rows; }
};

struct Times {
    double step = 0.0;              // us, without reading the clock inside
    PhaseTimes stages{};            // us
    std::optional<double> bytes{};  // of the heap, for the world after these steps; none if not known
};

struct Ledger {
    Parts parts;
    int bodies = 0;
    Counts counts;
    Times times;
};

// Counts of the same steps in every call, so that equal programs give equal counts.
Counts count_steps(const MeasuredState& moment);

// CPU time of one pass over those steps, us per step.
double time_of_step(const MeasuredState& moment);

// CPU times of those steps: median over `repeats` passes of the mean per step; and memory of the world.
Times time_steps(const MeasuredState& moment, int repeats, const std::function<void()>& check);

}  // namespace pushfactor::demos::reports::cost
