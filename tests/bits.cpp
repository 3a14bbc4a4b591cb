// Prints what has to be the same on every compiler and in every build type: state hashes after runs, and residuals
// and work of all solvers on systems of one step. tests/same_bits compares the lines of four builds.
#include "demos/options/named_run.h"
#include "demos/runs/simulation.h"
#include "engine/bodies/diagnostics.h"
#include "engine/solvers/solver.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <vector>

using namespace pushfactor;
using namespace pushfactor::demos;

namespace {

struct Run {
    const char* scene;
    OptionTexts options;
};

const std::vector<Run> runs{
    {"stack", {{"seconds", "20"}, {"jitter", "0.01"}, {"seed", "3"}}},
    {"stack", {{"seconds", "20"}, {"preset", "paper"}}},
    {"stack", {{"seconds", "5"}, {"rotation", "exponential"}, {"friction-model", "coulomb"}}},
    {"intersecting-stack", {{"seconds", "2"}}},
    {"intersecting-stack", {{"seconds", "2"}, {"preset", "paper"}}},
    {"funnel", {{"seconds", "3"}}},
    {"funnel", {{"count", "400"}, {"seconds", "2"}, {"threads", "2"}}},
    {"pendulum-grid", {{"seconds", "2"}, {"poke", "60"}, {"poke-at", "0.5"}}},
    {"pendulum-wave", {{"seconds", "2"}}},
    {"chain", {{"seconds", "2"}, {"substeps", "4"}}},
    {"chain", {{"seconds", "8"}, {"end-mass", "1000"}, {"substeps", "auto"}}},
    {"bridge", {{"seconds", "1"}}},
    {"restitution", {{"seconds", "2"}}},
    {"polyhedra", {{"seconds", "3"}}},
};

// Solvers get the system of a whole step; the paper's bound of friction makes the problem convex.
const std::vector<Run> moments{
    {"stack",
     {{"gap", "0.1"}, {"jitter", "0.01"}, {"seconds", "0.32"}, {"friction-model", "paper"}, {"scheme", "whole"}}},
    {"funnel", {{"count", "20"}, {"seconds", "5"}, {"friction-model", "paper"}, {"scheme", "whole"}}},
    {"pendulum-grid", {{"seconds", "1"}, {"friction-model", "paper"}, {"scheme", "whole"}}},
    {"chain", {{"end-mass", "1000"}, {"substeps", "32"}, {"seconds", "1"}, {"scheme", "whole"}}},
    {"sphere_column", {{"seconds", "0.02"}, {"scheme", "whole"}}},
};

Simulation played(const Run& run) {
    Simulation simulation(run_of(run.scene, run.options));
    const long steps = std::max(1L, whole_steps(simulation.settings()));
    for (long step = 0; step < steps; ++step) simulation.advance();
    return simulation;
}

void print_hash(const Run& run) {
    fmt::print("{:016x}  {}\n", engine::state_hash(played(run).scene().world.bodies),
               command_text("run", run.scene, run.options));
}

void print_solutions(const Run& run) {
    const Simulation simulation = played(run);
    const engine::SystemEquation& system = simulation.scene().world.system();
    for (const engine::solvers::SolverEntry& entry : engine::solvers::solver_table()) {
        for (const int iterations : {1, 5, 25, 100}) {
            engine::Columns lambda = engine::Columns::Zero(system.row_count(), system.column_count());
            const auto count = entry.make()->solve(
                system, {.iterations = iterations, .tolerance_high = 0.0, .tolerance_low = 0.0}, lambda);
            fmt::print("{:a} {:a}  {}, {} iterations of {}\n", natural_residual(system, lambda),
                       count.multiply_adds, run.scene, iterations, entry.name);
        }
    }
}

}  // namespace

int main() {
    try {
        std::for_each(runs.begin(), runs.end(), print_hash);
        std::for_each(moments.begin(), moments.end(), print_solutions);
    } catch (const std::exception& error) {
        fmt::print(stderr, "bits: {}\n", error.what());
        return 1;
    }
}
