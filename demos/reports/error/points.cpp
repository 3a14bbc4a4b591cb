#include "demos/reports/error/points.h"

#include "demos/platform/processors.h"
#include "demos/reports/study.h"
#include "demos/runs/measurements.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace pushfactor::demos::reports::error {

namespace {

struct Work {
    double multiply_adds = 0.0;

    void observe(const Simulation& run) { multiply_adds += run.sample().count.multiply_adds; }
};

struct StepTimes {
    std::vector<double> us;

    void observe(const Simulation& run) { us.push_back(*run.sample().cpu_us); }
};

// Sets everything in `point` except the times.
void run_for_errors(const Experiment& sweep, const Choices& choices, const std::function<void()>& check,
                    ErrorPoint& point) {
    Simulation run(choices);
    Measurements measurements(run);
    Work work;
    const auto error = sweep.error(run);
    const bool finite = play_to_end(run, check, work, measurements, *error);
    point.errors = error->result();
    point.multiply_adds = work.multiply_adds / run.sample().time;
    point.outcome = finite ? name_of(measurements.outcome()) : "non-finite";
}

CpuShare time_runs(const Choices& choices, int repeats, const std::function<void()>& check) {
    const double dt = choices.settings.dt.value();
    const auto share = [dt](auto from, auto to) {
        return 1e-6 * std::accumulate(from, to, 0.0) / (dt * static_cast<double>(to - from));
    };
    std::vector<double> all, begin, end;
    for (int i = 0; i < repeats; ++i) {
        Simulation run(choices.on_one_thread(), thread_cpu_us);
        StepTimes steps;
        play_to_end(run, check, steps);
        const std::vector<double>& times = steps.us;
        if (times.empty()) return {};
        const auto second = std::min<long>(std::lround(1.0 / dt), static_cast<long>(times.size()));
        const auto two = std::min<long>(2 * second, static_cast<long>(times.size()));
        all.push_back(share(times.begin(), times.end()));
        begin.push_back(share(times.begin(), times.begin() + two));
        end.push_back(share(times.end() - second, times.end()));
    }
    return {*std::min_element(all.begin(), all.end()), median(all), percentile_95(all), median(begin), median(end)};
}

}  // namespace

bool means_failure(const std::string& outcome) {
    constexpr std::array<std::string_view, 5> failures{"non-finite", "fall", "tunnel", "torn", "fly"};
    return std::find(failures.begin(), failures.end(), outcome) != failures.end();
}

ErrorPoint run_point(const Experiment& sweep, const Method& method, const std::string& value, int repeats,
                     const std::function<void()>& check) {
    Choices choices = run_at(sweep, method, value);
    ErrorPoint point{.scene = sweep.scene,
                     .method = method.name,
                     .differences = differences(sweep, method),
                     .knob = method.knob,
                     .value = value,
                     .moves = method.moves * choices.settings.substeps.value_or(1) / choices.settings.dt.value()};
    run_for_errors(sweep, choices, check, point);
    if (sweep.clock_seconds) choices.settings.seconds = std::min(choices.settings.seconds, *sweep.clock_seconds);
    point.cpu = time_runs(choices, repeats, check);
    point.failed = means_failure(point.outcome) && !(point.outcome == "fly" && method.flies);
    return point;
}

double percentile_95(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const auto count = static_cast<double>(values.size());
    return values[static_cast<std::size_t>(std::ceil(0.95 * count)) - 1];
}

Table table_of(const std::vector<ErrorPoint>& points) {
    Table table{{"scene", "method", "differs_from_preset", "knob", "value", "error_measure", "error",
                 "work_multiply_adds_per_simulated_s", "cpu_s_per_simulated_s_min", "cpu_s_per_simulated_s_median",
                 "cpu_s_per_simulated_s_p95", "cpu_s_per_simulated_s_first_two_s", "cpu_s_per_simulated_s_last_s",
                 "outcome"}};
    for (const ErrorPoint& point : points) {
        const auto& [min, median, p95, first_two_seconds, last_second] = point.cpu;
        for (const auto& [name, value] : point.errors) {
            table.rows.push_back({point.scene, point.method, point.differences, point.knob, point.value, name,
                                  std::isfinite(value) ? Cell(value) : Cell(), point.multiply_adds, min, median,
                                  p95, first_two_seconds, last_second, point.outcome});
        }
    }
    return table;
}

}  // namespace pushfactor::demos::reports::error
