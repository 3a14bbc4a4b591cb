#include "demos/checks/trajectory.h"

#include <fmt/format.h>

#include <algorithm>

namespace pushfactor::demos::checks {

TrajectoryCheck::TrajectoryCheck(const std::filesystem::path& file, double tolerance)
    : tolerance_(tolerance), reader_(fmt::format("--physics {}: ", tolerance), file), next_(reader_.next()) {}

void TrajectoryCheck::observe(const Simulation& simulation) {
    const double half_step = 0.5 * simulation.settings().dt.value();
    const double now = simulation.sample().time;
    while (next_ && next_->time < now + half_step) {
        compare(simulation);
        next_ = reader_.next();
    }
}

void TrajectoryCheck::compare(const Simulation& simulation) {
    ++lines_;
    const auto& [time, pose] = *next_;
    const auto& bodies = simulation.scene().world.bodies;
    const auto& described = simulation.scene().bodies;
    if (pose.body >= bodies.size()) {
        if (first_.empty()) first_ = fmt::format("there is no body {} any more", pose.body);
        return;
    }
    const engine::Body& body = bodies[pose.body];
    const double away = (body.position - pose.position).norm();
    const double turned = body.orientation.angularDistance(pose.orientation);
    largest_ = std::max({largest_, away, turned});
    if (!first_.empty() || (away <= tolerance_ && turned <= tolerance_)) return;
    const std::string name = pose.body < described.size() ? " (" + described[pose.body].name + ")" : "";
    first_ = fmt::format("body {}{} is {:.3g} m off and turned by {:.3g} rad at {} s", pose.body, name, away,
                         turned, time);
}

RunVerdict TrajectoryCheck::verdict() const {
    if (lines_ == 0) {
        return {.subject = "physics", .text = "trajectory.csv has no line of this run", .compared = false};
    }
    RunVerdict verdict{.subject = "physics", .holds = first_.empty() && !next_, .text = {}};
    if (!first_.empty()) {
        verdict.text = fmt::format("{} ({} allowed), at most {:.3g}", first_, tolerance_, largest_);
    } else if (next_) {
        verdict.text = fmt::format("the run ends before {} s", next_->time);
    }
    return verdict;
}

}  // namespace pushfactor::demos::checks
