// What the report on cost measures: scenes, the ledger of each (work and time of its steps), the same scenes with
// every part added, and scenes side by side.
#pragma once

#include "demos/base/platform/processors.h"
#include "demos/reports/study.h"
#include "demos/runs/scene.h"
#include "demos/runs/step_division.h"

#include <array>
#include <numeric>
#include <string_view>

namespace pushfactor::demos::reports::cost {

struct CostCase {
    std::string name;     // "funnel of 200, falling"
    std::string scene;    // of the catalogue
    OptionTexts options;  // of the command line
    double start = 0.0;   // s, simulated, when counting begins
};

std::vector<CostCase> cost_cases(bool quick);  // `quick`: the small ones

// The scene of `description`, whose options are spelled out, with
//
//   a poke beside gravity, a distance, contacts with friction and restitution, sweep and cache,
//   the distances pushed for a single frame, so that there are two columns in every step,
// rules that are evaluated before each step and may divide it.
//
// The additions are negligible: forces of 1e-12 N, friction and restitution of 1e-9. Two things do change: bodies
// that swung through each other now collide, and a length error that is corrected for a single frame leaves no
// velocity.
SceneDescription with_everything(SceneDescription scene);

// The parts of a scene by name, without absent ones.
struct Parts {
    std::vector<std::string> forces;       // "gravity", "poke"
    std::vector<std::string> constraints;  // "50 distances", "contacts"
    std::vector<std::string> contacts;     // of the contact stage: "friction", "restitution", "sweep", "cache"
    std::vector<std::string> step_rules;   // that may divide a step
};

Parts parts_of(const BuiltScene& scene, const Settings& settings);

// The run as it is after `seconds`, from where its steps are counted; each build of its scene takes the same steps.
Choices moment_at(Choices choices, double seconds, const StopCheck& check);

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

    void begin() { last_ = thread_cpu_us(); }  // right before the rules are evaluated
    void rules_ended() { end(0); }
    void phase_ended(engine::Phase stage) override { end(1 + static_cast<std::size_t>(stage)); }

    const PhaseTimes& times() const { return times_; }  // the sum of all steps

  private:
    void end(std::size_t stage) {
        const double now = thread_cpu_us();
        times_[stage] += now - last_ - cost_;
        last_ = now;
    }

    double cost_, last_ = 0.0;
    PhaseTimes times_{};
};

// Takes the steps of a run without measurements.
class Walk {
  public:
    static constexpr int steps_before = 30;  // warm-up: until memory no longer grows and the caches are warm
    static constexpr int steps_counted = 120;

    explicit Walk(const Choices& moment);  // has taken `steps_before`

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

// Islands of a kind by engine::IslandSolver::Method: last forces kept, solved by sweeps, solved exactly, in small
// steps.
inline constexpr std::array<std::string_view, 4> island_ways{"kept", "swept", "exact", "small_steps"};
struct IslandCounts {
    std::array<double, island_ways.size()> by_way{};

    double of(engine::IslandSolver::Method way) const { return by_way[static_cast<std::size_t>(way)]; }
    double all() const { return std::accumulate(by_way.begin(), by_way.end(), 0.0); }
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

// Columns of cost.csv: before those of the islands and after them. Numbers of engine steps are means over these,
// the others over the steps of the run.
struct CountColumn {
    const char* name;
    double Counts::*value;
    bool of_engine_steps = false;
};
inline constexpr std::array row_columns{CountColumn{"pairs", &Counts::pairs},
                                        CountColumn{"touches", &Counts::touches},
                                        CountColumn{"contact_rows", &Counts::contact_rows, true},
                                        CountColumn{"friction_rows", &Counts::friction_rows, true},
                                        CountColumn{"distance_rows", &Counts::distance_rows, true},
                                        CountColumn{"joint_rows", &Counts::joint_rows, true},
                                        CountColumn{"columns", &Counts::columns, true},
                                        CountColumn{"substeps", &Counts::substeps}};
inline constexpr std::array work_columns{
    CountColumn{"bodies_at_rest", &Counts::at_rest, true}, CountColumn{"sweeps", &Counts::sweeps},
    CountColumn{"row_updates", &Counts::row_updates}, CountColumn{"multiply_adds", &Counts::multiply_adds}};

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
    std::string command{};  // that reproduces the steps
};

// Counts of the same steps in every call, so that equal programs give equal counts.
Counts count_steps(const Choices& moment);

// CPU times of those steps: median over `repeats` passes of the mean per step; and memory of the world.
Times time_steps(const Choices& moment, int repeats, const StopCheck& check);

// Scenes side by side, too far apart to touch: a world should cost as much as its parts, and move like them.
struct Neighbours {
    std::vector<SceneDescription> parts;
    std::vector<int> times;  // number of copies of each part in `together`
    SceneDescription together;
    double start = 0.0;  // s, simulated, from when on steps are counted
};

// The list of the report; `quick` takes seconds.
std::vector<Neighbours> neighbours(bool quick);

struct SumOfParts {
    std::string name;
    double islands = 0.0;              // mean per step, together
    double parts_us = 0.0;             // CPU time per step: the sum of all parts alone
    double together_us = 0.0;          // and of the common world
    double ratio = 0.0;                // together / sum: median of several passes, each over all worlds in turn
    double parts_multiply_adds = 0.0;  // of the solver per step
    double together_multiply_adds = 0.0;
    double moved = 0.0;  // m: largest distance of the first part's bodies from where they end alone
};

// Times the same steps of all worlds `goes` times.
SumOfParts measure(const Neighbours& scenes, int goes, const StopCheck& check);

}  // namespace pushfactor::demos::reports::cost
