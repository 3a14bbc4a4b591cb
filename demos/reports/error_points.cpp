#include "demos/reports/error_points.h"

#include "demos/errors.h"
#include "demos/measurements.h"
#include "demos/observed_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pushfactor::demos::reports {

namespace {

// Fills in all but the times. False when the run became non-finite.
bool run_for_errors(const Sweep& sweep, const Choices& choices, const std::function<void()>& check,
                    ErrorPoint& point) {
    Simulation run(choices.build(), choices.settings);
    Measurements measurements(run);
    const auto error = sweep.error(run);
    bool finite = true;
    try {
        while (run.sample().step < whole_steps(choices.settings)) {
            check();
            run.advance();
            point.multiply_adds += run.sample().count.multiply_adds;
            measurements.observe(run);
            error->observe(run);
        }
    } catch (const NonFiniteError&) {
        finite = false;
    }
    point.errors = error->result();
    point.multiply_adds /= run.sample().time;
    point.outcome = finite ? name_of(measurements.outcome()) : "non-finite";
    return finite;
}

CpuShare time_runs(const Choices& choices, int repeats, const std::function<void()>& check) {
    std::vector<double> shares;
    for (int i = 0; i < repeats; ++i) {
        Simulation run(choices.build(), choices.settings, thread_cpu_us);
        double us = 0.0;
        while (run.sample().step < whole_steps(choices.settings)) {
            check();
            us += *run.advance().cpu_us;
        }
        shares.push_back(1e-6 * us / run.sample().time);
    }
    return {*std::min_element(shares.begin(), shares.end()), median(shares), percentile_95(shares)};
}

}  // namespace

ErrorPoint run_point(const Sweep& sweep, const Method& method, const std::string& value, int repeats,
                     const std::function<void()>& check) {
    const Choices choices = run_at(sweep, method, value);
    ErrorPoint point{.scene = sweep.scene,
                     .method = method.name,
                     .differences = differences(sweep, method),
                     .knob = method.knob,
                     .value = value};
    if (run_for_errors(sweep, choices, check, point)) point.cpu = time_runs(choices, repeats, check);
    point.failed = point.outcome == "non-finite" || point.outcome == "fall" || point.outcome == "tunnel" ||
                   (point.outcome == "fly" && !method.flies);
    return point;
}

double percentile_95(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const auto count = static_cast<double>(values.size());
    return values[static_cast<std::size_t>(std::ceil(0.95 * count)) - 1];
}

std::string csv_text(const std::vector<ErrorPoint>& points) {
    std::string text =
        "scene,method,differs_from_preset,knob,value,error_measure,error,work_multiply_adds_per_simulated_s,"
        "cpu_s_per_simulated_s_min,cpu_s_per_simulated_s_median,cpu_s_per_simulated_s_p95,outcome\n";
    for (const ErrorPoint& point : points) {
        const std::string cpu = point.cpu
                                    ? fmt::format("{},{},{}", point.cpu->min, point.cpu->median, point.cpu->p95)
                                    : std::string(",,");
        for (const NamedError& error : point.errors) {
            text += fmt::format("{},\"{}\",{},{},{},{},{},{},{},{}\n", point.scene, point.method, point.differences,
                                point.knob, point.value, error.name,
                                std::isfinite(error.value) ? fmt::format("{}", error.value) : std::string(),
                                point.multiply_adds, cpu, point.outcome);
        }
    }
    return text;
}

}  // namespace pushfactor::demos::reports
