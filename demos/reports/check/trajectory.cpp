#include "demos/reports/check/trajectory.h"

#include "demos/runs/trajectory.h"
#include "demos/text/errors.h"
#include "demos/text/numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace pushfactor::demos::reports::check {

TrajectoryCheck::TrajectoryCheck(const std::filesystem::path& file, double tolerance)
    : name_(file.string()), tolerance_(tolerance), stream_(file) {
    std::string heading;
    if (!stream_) throw UsageError(fmt::format("{}: cannot be read; --physics {} needs it", name_, tolerance));
    if (!std::getline(stream_, heading) || !heading.starts_with(pose_columns)) {
        throw UsageError(fmt::format("{}: line 1: must begin with {}", name_, pose_columns));
    }
    has_next_ = read_line();
}

bool TrajectoryCheck::read_line() {
    std::string text;
    if (!std::getline(stream_, text)) return false;
    ++lines_;
    std::array<double, 9> values;
    std::string_view rest = text;
    for (double& value : values) {
        const std::size_t comma = rest.find(',');
        const auto number = parse_number(rest.substr(0, comma));
        if (!number || comma == std::string_view::npos) {
            throw UsageError(
                fmt::format("{}: line {}: must be numbers, as `--trajectory` writes them", name_, lines_));
        }
        value = *number;
        rest.remove_prefix(comma + 1);
    }
    next_ = {.time = values[0],
             .body = static_cast<std::size_t>(std::max(values[1], 0.0)),
             .position = {values[2], values[3], values[4]},
             .orientation = {values[5], values[6], values[7], values[8]}};
    return true;
}

void TrajectoryCheck::observe(const Simulation& simulation) {
    const double half_step = 0.5 * simulation.settings().dt.value();
    const double now = simulation.sample().time;
    while (has_next_ && next_.time < now + half_step) {
        compare(simulation);
        has_next_ = read_line();
    }
}

void TrajectoryCheck::compare(const Simulation& simulation) {
    ++compared_;
    const auto& bodies = simulation.scene().world.bodies;
    const auto& described = simulation.scene().bodies;
    if (next_.body >= bodies.size()) {
        if (first_.empty()) first_ = fmt::format("there is no body {} any more", next_.body);
        return;
    }
    const engine::Body& body = bodies[next_.body];
    const double away = (body.position - next_.position).norm();
    const double turned = body.orientation.angularDistance(next_.orientation);
    largest_ = std::max({largest_, away, turned});
    if (!first_.empty() || (away <= tolerance_ && turned <= tolerance_)) return;
    const std::string name = next_.body < described.size() ? " (" + described[next_.body].name + ")" : "";
    first_ = fmt::format("body {}{} is {:.3g} m off and turned by {:.3g} rad at {} s", next_.body, name, away,
                         turned, next_.time);
}

RunVerdict TrajectoryCheck::verdict() const {
    RunVerdict verdict{.subject = "physics", .holds = first_.empty() && !has_next_, .text = {}};
    if (!first_.empty()) {
        verdict.text = fmt::format("{} ({} allowed), at most {:.3g}", first_, tolerance_, largest_);
    } else if (has_next_) {
        verdict.text = fmt::format("the run ends before {} s", next_.time);
    }
    return verdict;
}

}  // namespace pushfactor::demos::reports::check
