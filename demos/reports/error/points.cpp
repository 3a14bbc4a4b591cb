#include "demos/base/platform/processors.h"
#include "demos/base/text/csv.h"
#include "demos/base/text/numbers.h"
#include "demos/reports/error/error.h"
#include "demos/runs/measurements.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace pushfactor::demos::reports::error {

namespace {

struct StepLog {
    double multiply_adds = 0.0;
    std::vector<double> us;  // where there is a clock

    void observe(const Simulation& run) {
        multiply_adds += run.sample().count.multiply_adds;
        if (run.sample().cpu_us) us.push_back(*run.sample().cpu_us);
    }
};

CpuShare time_runs(const Choices& choices, int repeats, const StopCheck& check) {
    const double dt = choices.settings.dt.value();
    const auto share = [dt](auto from, auto to) {
        return 1e-6 * std::accumulate(from, to, 0.0) / (dt * static_cast<double>(to - from));
    };
    std::vector<double> all, begin, end;
    for (int i = 0; i < repeats; ++i) {
        Simulation run(choices.on_one_thread(), thread_cpu_us);
        StepLog steps;
        play_to_end(run, check, steps);
        const std::vector<double>& times = steps.us;
        if (times.empty()) return {};
        const auto second = std::min<long>(std::lround(1.0 / dt), std::ssize(times));
        const auto two = std::min<long>(2 * second, std::ssize(times));
        all.push_back(share(times.begin(), times.end()));
        begin.push_back(share(times.begin(), times.begin() + two));
        end.push_back(share(times.end() - second, times.end()));
    }
    return {std::ranges::min(all), median(all), percentile_95(all), median(begin), median(end)};
}

bool fails(const std::string& outcome, const Method& method) {
    return means_failure(outcome) && !(outcome == "fly" && method.flies);
}

// A line of error.csv; numbers that are missing are NaN.
ErrorPoint point_of(const std::vector<std::string>& cells) {
    const auto number = [&cells](std::size_t i) {
        return parse_number(cells.at(i)).value_or(std::numeric_limits<double>::quiet_NaN());
    };
    return {.scene = cells[0],
            .method = cells[1],
            .differences = cells[2],
            .knob = cells[3],
            .value = cells[4],
            .errors = {{cells[5], number(6)}},
            .multiply_adds = number(7),
            .cpu = {number(8), number(9), number(10), number(11), number(12)},
            .outcome = cells.at(13),
            .failed = !std::isfinite(number(6)) || means_failure(cells[13])};
}

std::string text_of(double seconds) {
    return fmt::format("{:.3g} ms", 1e3 * seconds);
}

}  // namespace

bool means_failure(const std::string& outcome) {
    constexpr std::array<std::string_view, 5> failures{"non-finite", "fall", "tunnel", "torn", "fly"};
    return std::ranges::find(failures, outcome) != failures.end();
}

ErrorPoint run_point(const Experiment& sweep, const Method& method, const std::string& value,
                     const StopCheck& check) {
    Choices choices = run_at(sweep, method, value);
    const bool both = !sweep.common.empty() && !method.differs.empty();
    ErrorPoint point{.scene = sweep.scene,
                     .method = method.name,
                     .differences = sweep.common + (both ? " " : "") + method.differs,
                     .knob = method.knob,
                     .value = value};
    Simulation run(choices.on_one_thread());
    Measurements measurements(run);
    StepLog work;
    TrueError error = sweep.error(run);
    const bool finite = play_to_end(run, check, work, measurements, error);
    point.errors = error.result();
    point.multiply_adds = work.multiply_adds / run.sample().time;
    point.outcome = finite ? name_of(measurements.outcome()) : "non-finite";
    point.failed = fails(point.outcome, method);
    if (sweep.clock_seconds) choices.settings.seconds = std::min(choices.settings.seconds, *sweep.clock_seconds);
    point.cpu = time_runs(choices, sweep.timed_runs, check);
    return point;
}

Piece piece_of(const Experiment& sweep, const Method& method, const std::string& value) {
    return {fmt::format("error: {}, {}: {}; timed {} times{}", sweep.name, method.name,
                        run_key(sweep.scene, options_at(sweep, method, value)), sweep.timed_runs,
                        sweep.clock_seconds ? fmt::format(" over {} s", *sweep.clock_seconds) : ""),
            [sweep, method, value](const StopCheck& check) {
                return Json(exact_rows(table_of({run_point(sweep, method, value, check)})));
            }};
}

ErrorPoint point_in(const Json& result, const Method& method) {
    ErrorPoint point = point_of(result.at(0));
    for (std::size_t i = 1; i < result.size(); ++i) point.errors.push_back(point_of(result[i]).errors.front());
    point.failed = fails(point.outcome, method);
    return point;
}

double percentile_95(std::vector<double> values) {
    std::ranges::sort(values);
    return values[static_cast<std::size_t>(std::ceil(0.95 * static_cast<double>(values.size()))) - 1];
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

std::vector<ErrorPoint> read_error_points(const std::filesystem::path& file) {
    std::vector<ErrorPoint> points;
    for (const auto& cells : read_csv("--beside", file, table_of({}).columns)) points.push_back(point_of(cells));
    return points;
}

std::vector<ErrorPoint> about(std::vector<ErrorPoint> points, const std::string& scene,
                              const std::string& measure) {
    std::erase_if(points, [&](const ErrorPoint& point) {
        return point.scene != scene || point.errors.front().name != measure;
    });
    return points;
}

std::vector<WorkLine> lines_beside(std::span<const WorkLine> ours, std::span<const ErrorPoint> others) {
    constexpr std::array marks{4, 8, 12, 10, 6};  // gnuplot's open square, triangle, diamond, triangle down, circle
    std::vector<WorkPoint> points;
    std::vector<const WorkLine*> owners;
    for (const WorkLine& line : ours) {
        for (const WorkPoint& point : line.points) {
            if (point.failed || !std::isfinite(point.error)) continue;
            points.push_back(point);
            owners.push_back(&line);
        }
    }
    std::set<const WorkLine*> best;  // in the order of `ours`
    for (const std::size_t i : pareto_front(points)) best.insert(owners[i]);
    std::vector<WorkLine> lines;
    for (const WorkLine* const line : best) lines.push_back(*line);
    struct Engine {
        int mark = 0, lines = 0;
    };
    std::map<std::string, Engine> engines;
    const std::size_t own = lines.size();
    for (const ErrorPoint& point : others) {
        if (lines.size() == own || lines.back().name != point.method) {
            // Lines of one engine have the same mark: its name is the first word of the method.
            const auto [engine, is_new] = engines.try_emplace(point.method.substr(0, point.method.find(' ')));
            if (is_new) engine->second.mark = marks[(engines.size() - 1) % marks.size()];
            lines.push_back({.name = point.method,
                             .colour = "grey",
                             .dash = 1 + engine->second.lines++ % 3,
                             .mark = engine->second.mark});
        }
        lines.back().points.push_back({point.error(), point.cpu.median, point.value, point.failed});
    }
    return lines;
}

TextTable who_is_faster(std::span<const WorkLine> ours, std::span<const ErrorPoint> others) {
    TextTable table{{"other engine", "its smallest error", "its time", "ours for that error", "by"}};
    while (!others.empty()) {
        const std::string& method = others.front().method;
        const ErrorPoint* best = nullptr;
        for (; !others.empty() && others.front().method == method; others = others.subspan(1)) {
            const ErrorPoint& point = others.front();
            if (!point.failed && (!best || point.error() < best->error())) best = &point;
        }
        if (!best) {
            table.push_back({method, "fell or blew up", "", "", ""});
            continue;
        }
        const auto [line, least] = cheapest(ours, best->error());
        table.push_back({fmt::format("{}, {} {}", method, best->knob, best->value),
                         fmt::format("{:.2g}", best->error()), text_of(best->cpu.median),
                         least ? text_of(least->work) : "not reached",
                         least ? fmt::format("{}, {}", line->name, least->label) : ""});
    }
    return table;
}

}  // namespace pushfactor::demos::reports::error
