// The ledger of a scene: what its steps do and what they cost.
#pragma once

#include "demos/options/choices.h"
#include "demos/reports/cost/parts.h"
#include "demos/reports/cost/phase_clock.h"

#include <array>
#include <functional>
#include <string_view>
#include <vector>

namespace pushfactor::demos::reports::cost {

// A scene at the moment from which its steps are counted; each build of it takes the same steps.
struct MeasuredState {
    SceneDescription description;
    Settings settings;

    BuiltScene build() const { return build_scene(description, settings); }
};

// Calls `check` now and then, which may throw.
MeasuredState moment_at(const Choices& choices, double seconds, const std::function<void()>& check);

// Islands by how their bodies are connected: one body, at most 1.5 pairs a body, more.
enum class IslandKind { single, thread, heap };
inline constexpr std::array<std::string_view, 3> island_kinds{"single", "thread", "heap"};

// What was done with the islands of a kind: last forces kept, solved by sweeps, solved exactly, in small steps.
struct IslandCounts {
    double kept = 0.0, swept = 0.0, exact = 0.0, small_steps = 0.0;

    double all() const { return kept + swept + exact + small_steps; }
};

// Means over the steps that were counted, each a step of the run.
struct Counts {
    double substeps = 0.0;
    double pairs = 0.0;    // whose bounding boxes meet
    double touches = 0.0;  // pairs with contact points
    double contact_rows = 0.0, friction_rows = 0.0, distance_rows = 0.0;
    double columns = 0.0;
    double at_rest = 0.0;                                     // bodies that rest leaves out
    std::array<IslandCounts, island_kinds.size()> islands{};  // of the last engine step in a step of the run
    double sweeps = 0.0;         // iterations of the solver, of whatever kind, on the island with the most of them
    double row_updates = 0.0;    // rows times columns times iterations, of all islands
    double multiply_adds = 0.0;  // of the solver
    double allocations = 0.0;
    double allocated_bytes = 0.0;

    double rows() const { return contact_rows + friction_rows + distance_rows; }
};

struct Times {
    double step = 0.0;    // us, with no clock inside
    PhaseTimes stages{};  // us
};

struct Ledger {
    Parts parts;
    int bodies = 0;
    Counts counts;
    Times times;
};

// Of the same steps always, so that equal programs give equal counts.
Counts count_steps(const MeasuredState& moment);

// The upper one of the middle two of an even number of values; at least one.
double median(std::vector<double> values);

// CPU time of those steps once, us per step.
double time_of_step(const MeasuredState& moment);

// CPU times of those steps: the median of `repeats` goes of the mean over the steps.
Times time_steps(const MeasuredState& moment, int repeats, const std::function<void()>& check);

}  // namespace pushfactor::demos::reports::cost
