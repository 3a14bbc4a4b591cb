#include "tests/peers/sweeps.h"

#include "tests/peers/exact.h"
#include "tests/peers/measures.h"
#include "tests/peers/mechanics.h"
#include "tests/peers/overlap.h"
#include "tests/peers/run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <numeric>

namespace pushfactor::tests::peers {

namespace {

constexpr std::size_t second = 60;  // steps

// A scene of the report, and its plotted error from the states of a run.
struct ErrorCase {
    std::string scene;      // its name there
    std::string arguments;  // of `pushfactor scene`
    std::size_t steps = 0;
    std::string measure;
    double (*error)(const Scene&, const Run&) = nullptr;
};

double root_mean(double squares, std::size_t count) {
    return std::sqrt(squares / static_cast<double>(count));
}

// Over the last second and all bodies: distance from `place` of a body.
template <typename Place>
double away(const Scene& scene, const Run& run, const Place& place) {
    double squares = 0.0;
    for (std::size_t n = run.states.size() - second; n < run.states.size(); ++n) {
        for (std::size_t i = 0; i < scene.movable.size(); ++i)
            squares += (run.states[n][i].position - place(i)).squaredNorm();
    }
    return root_mean(squares, second * scene.movable.size());
}

double from_rest(const Scene& scene, const Run& run) {
    return away(scene, run, [&](std::size_t i) {
        const Body& cube = scene.movable[i];
        return Vector3(cube.start.position.x(), (static_cast<double>(i) + 0.5) * cube.size.y(),
                       cube.start.position.z());
    });
}

double from_start(const Scene& scene, const Run& run) {
    return away(scene, run, [&](std::size_t i) { return scene.movable[i].start.position; });
}

double deepest_overlap(const Scene& scene, const Run& run) {
    std::vector<double> depths;
    for (std::size_t n = 1; n < run.states.size(); ++n) depths.push_back(overlap(scene, run.states[n]).deepest);
    std::nth_element(depths.begin(), depths.begin() + static_cast<long>(depths.size() / 2), depths.end());
    return depths[depths.size() / 2];
}

double angle_error(const Scene& scene, const Run& run) {
    for (const Value& value : wave(scene, run)) {
        if (value.name == "angle error, rms, degrees") return value.number;
    }
    return std::numeric_limits<double>::quiet_NaN();
}

double chain_error(const Scene& scene, const Run& run) {
    const auto exact = exact_chain(scene, run.joint, run.states.size() - 1);
    double squares = 0.0;
    for (std::size_t n = 1; n < run.states.size(); ++n) {
        for (std::size_t i = 0; i < scene.movable.size(); ++i)
            squares += (run.states[n][i].position - exact[n][i]).squaredNorm();
    }
    return root_mean(squares, (run.states.size() - 1) * scene.movable.size());
}

const std::vector<ErrorCase>& error_cases() {
    // The options are those of demos/reports/error/experiments.cpp.
    static const std::vector<ErrorCase> cases{
        {"stack", "stack --jitter 0.01 --seed 1", 10 * second, "rest_position_rms_m", from_rest},
        {"brick_wall", "assets/scenes/brick_wall.json", 2 * second, "moved_rms_m", from_start},
        {"pile_of_cubes", "assets/scenes/pile_of_cubes.json", 3 * second, "deepest_overlap_median_m",
         deepest_overlap},
        {"pendulum-wave", "pendulum-wave", 60 * second, "angle_error_rms_deg", angle_error},
        {"chain", "chain --end-mass 1000", 2 * second, "position_rms_m", chain_error},
    };
    return cases;
}

bool fell(const Scene& scene, const Run& run) {
    return std::any_of(run.states.begin(), run.states.end(), [&](const std::vector<State>& states) {
        for (std::size_t i = 0; i < states.size(); ++i) {
            const double half = 0.5 * scene.movable[i].size.y();
            const double rest = (2.0 * static_cast<double>(i) + 1.0) * half;
            if (states[i].position.y() < std::min(rest, scene.movable[i].start.position.y()) - half) return true;
        }
        return false;
    });
}

// CPU seconds a simulated second of the steps from `begin` on.
double share(const Run& run, std::size_t begin, std::size_t end) {
    const auto from = run.step_us.begin();
    return 1e-6 * static_cast<double>(second) *
           std::accumulate(from + static_cast<long>(begin), from + static_cast<long>(end), 0.0) /
           static_cast<double>(end - begin);
}

// The smallest, the median and the largest of all runs, the median of their first two seconds and of their last.
std::string times(const std::vector<Run>& runs) {
    const std::size_t steps = runs.front().step_us.size();
    const auto over = [&](std::size_t begin, std::size_t end) {
        std::vector<double> shares;
        for (const Run& run : runs) shares.push_back(share(run, begin, end));
        std::sort(shares.begin(), shares.end());
        return shares;
    };
    const auto median = [](const std::vector<double>& sorted) { return sorted[sorted.size() / 2]; };
    const std::vector<double> all = over(0, steps);
    return fmt::format("{},{},{},{},{}", all.front(), median(all), all.back(),
                       median(over(0, std::min(2 * second, steps))),
                       median(over(steps - std::min(second, steps), steps)));
}

void write_point(const ErrorCase& of, const Scene& scene, const Series& series, int value, std::ostream& csv) {
    const Setting setting = series.at(value);
    const std::vector<Run> runs = repeated([&] { return run_peer(setting, scene, of.steps); });
    const Run& run = runs.front();
    const bool whole = finite(run);
    const bool down = whole && of.scene == "stack" && fell(scene, run);
    csv << fmt::format("{},\"{}\",{},{},{},{},{},,{},{}\n", of.scene, series.name, setting.engine, series.knob,
                       value, of.measure, whole ? fmt::format("{}", of.error(scene, run)) : "", times(runs),
                       !whole ? "non-finite"
                       : down ? "fall"
                              : "finite");
    csv.flush();
}

}  // namespace

void write_sweeps(const Program& program, std::ostream& csv) {
    csv << "scene,method,differs_from_preset,knob,value,error_measure,error,work_multiply_adds_per_simulated_s,"
           "cpu_s_per_simulated_s_min,cpu_s_per_simulated_s_median,cpu_s_per_simulated_s_p95,"
           "cpu_s_per_simulated_s_first_two_s,cpu_s_per_simulated_s_last_s,outcome\n";
    std::vector<Series> all = bullet_series();
    for (auto more : {ode_series(), mujoco_series(), box3d_series(), jolt_series()})
        all.insert(all.end(), more.begin(), more.end());
    for (const ErrorCase& of : error_cases()) {
        const Scene scene = scene_of(program, of.arguments);
        for (const Series& series : all) {
            if (std::count(series.cases.begin(), series.cases.end(), of.scene) == 0) continue;
            std::cerr << of.scene << ": " << series.name << '\n';
            for (const int value : series.values) write_point(of, scene, series, value, csv);
        }
    }
}

}  // namespace pushfactor::tests::peers
