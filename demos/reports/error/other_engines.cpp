#include "demos/reports/error/other_engines.h"

#include "demos/reports/error/plot_layout.h"
#include "demos/text/csv.h"
#include "demos/text/numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pushfactor::demos::reports::error {

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

double number_in(const std::string& cell) {
    return parse_number(cell).value_or(unknown);
}

WorkPoint point_of(const ErrorPoint& point) {
    return {point.errors.front().value, point.cpu.median, point.value, point.failed};
}

// Whether a point of the line is on the Pareto front of all lines.
std::vector<bool> on_front(std::span<const WorkLine> lines) {
    std::vector<Trade> trades;
    std::vector<std::size_t> owners;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        for (const WorkPoint& point : lines[i].points) {
            if (point.failed || !std::isfinite(point.error)) continue;
            trades.push_back({point.error, point.work});
            owners.push_back(i);
        }
    }
    std::vector<bool> best(lines.size(), false);
    for (const std::size_t trade : pareto_front(trades)) best[owners[trade]] = true;
    return best;
}

// Lines of one engine have the same mark: its name is the first word of the method.
std::string engine_of(const std::string& method) {
    return method.substr(0, method.find(' '));
}

std::string text_of(double seconds) {
    return fmt::format("{:.3g} ms", 1e3 * seconds);
}

}  // namespace

std::vector<ErrorPoint> read_error_points(const std::filesystem::path& file) {
    std::vector<ErrorPoint> points;
    for (const auto& cells : read_csv("--beside", file, table_of(std::vector<ErrorPoint>{}).columns)) {
        const double error = number_in(cells[6]);
        ErrorPoint point{.scene = cells[0],
                         .method = cells[1],
                         .differences = cells[2],
                         .knob = cells[3],
                         .value = cells[4],
                         .errors = {{cells[5], error}},
                         .multiply_adds = number_in(cells[7]),
                         .cpu = {.min = number_in(cells[8]),
                                 .median = number_in(cells[9]),
                                 .p95 = number_in(cells[10]),
                                 .first_two_seconds = number_in(cells[11]),
                                 .last_second = number_in(cells[12])},
                         .outcome = cells[13]};
        point.failed = !std::isfinite(error) || means_failure(point.outcome);
        points.push_back(std::move(point));
    }
    return points;
}

std::vector<ErrorPoint> about(const std::vector<ErrorPoint>& points, const std::string& scene,
                              const std::string& measure) {
    std::vector<ErrorPoint> some;
    std::copy_if(points.begin(), points.end(), std::back_inserter(some), [&](const ErrorPoint& point) {
        return point.scene == scene && point.errors.front().name == measure;
    });
    return some;
}

std::vector<WorkLine> lines_beside(std::span<const WorkLine> ours, std::span<const ErrorPoint> others) {
    constexpr std::array marks{4, 8, 12, 10, 6};  // gnuplot's open square, triangle, diamond, triangle down, circle
    std::vector<WorkLine> lines;
    const std::vector<bool> best = on_front(ours);
    for (std::size_t i = 0; i < ours.size(); ++i) {
        if (best[i]) lines.push_back(ours[i]);
    }
    std::vector<std::string> engines;
    std::vector<int> lines_of_engine;
    const std::size_t own = lines.size();
    for (const ErrorPoint& point : others) {
        if (lines.size() == own || lines.back().name != point.method) {
            const std::string engine = engine_of(point.method);
            const auto found = std::find(engines.begin(), engines.end(), engine);
            const auto place = static_cast<std::size_t>(found - engines.begin());
            if (found == engines.end()) {
                engines.push_back(engine);
                lines_of_engine.push_back(0);
            }
            lines.push_back({.name = point.method,
                             .colour = "grey",
                             .dash = 1 + lines_of_engine[place]++ % 3,
                             .mark = marks[place % marks.size()],
                             .points = {}});
        }
        lines.back().points.push_back(point_of(point));
    }
    return lines;
}

TextTable who_is_faster(std::span<const WorkLine> ours, std::span<const ErrorPoint> others) {
    TextTable table{{"other engine", "its smallest error", "its time", "ours for that error", "by"}};
    for (auto first = others.begin(); first != others.end();) {
        const auto end =
            std::find_if(first, others.end(), [&](const auto& one) { return one.method != first->method; });
        const ErrorPoint* best = nullptr;
        for (auto point = first; point != end; ++point) {
            const double error = point->errors.front().value;
            if (!point->failed && (!best || error < best->errors.front().value)) best = &*point;
        }
        const std::string& method = first->method;
        first = end;
        if (!best) {
            table.push_back({method, "fell or blew up", "", "", ""});
            continue;
        }
        const auto [line, least] = cheapest(ours, best->errors.front().value);
        const std::string by = least ? fmt::format("{}, {}", line->name, least->label) : "";
        table.push_back({fmt::format("{}, {} {}", method, best->knob, best->value),
                         fmt::format("{:.2g}", best->errors.front().value), text_of(best->cpu.median),
                         least ? text_of(least->work) : "not reached", by});
    }
    return table;
}

}  // namespace pushfactor::demos::reports::error
