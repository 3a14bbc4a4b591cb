// Other engines beside our methods.
#include "demos/reports/error/points.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace pushfactor::demos::reports::error {

namespace {

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

std::string text_of(double seconds) {
    return fmt::format("{:.3g} ms", 1e3 * seconds);
}

}  // namespace

std::vector<WorkLine> lines_beside(std::span<const WorkLine> ours, std::span<const ErrorPoint> others) {
    constexpr std::array marks{4, 8, 12, 10, 6};  // gnuplot's open square, triangle, diamond, triangle down, circle
    std::vector<WorkLine> lines;
    const std::vector<bool> best = on_front(ours);
    for (std::size_t i = 0; i < ours.size(); ++i) {
        if (best[i]) lines.push_back(ours[i]);
    }
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
