#include "demos/pictures/checks/trajectory.h"

#include "demos/runs/trajectory.h"

#include <fmt/format.h>

#include <algorithm>

namespace pushfactor::demos::checks {

TrajectoryCheck::TrajectoryCheck(const std::filesystem::path& file, double tolerance)
    : tolerance_(tolerance), reader_(fmt::format("--physics {}: ", tolerance), file), next_(reader_.next()) {}

void TrajectoryCheck::observe(const Simulation& simulation) {
    const double half_step = 0.5 * simulation.settings().dt.value();
    const double now = simulation.sample().time;
    end_ = now;
    while (next_ && next_->time < now + half_step) {
        if (lines_ == 0 || next_->time != last_) {
            spacing_ = lines_ == 0 ? half_step : next_->time - last_;
            ++instants_;
        }
        last_ = next_->time;
        compare(simulation);
        next_ = reader_.next();
    }
    const BuiltScene& scene = simulation.scene();
    movable_ = 0;
    for (std::size_t body = 0; body < scene.world.bodies.size(); ++body)
        movable_ += is_recorded(scene, body) ? 1 : 0;
}

void TrajectoryCheck::compare(const Simulation& simulation) {
    ++lines_;
    const auto& [time, pose, hash] = *next_;
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
    RunVerdict verdict{.subject = "physics", .holds = false, .text = {}};
    if (!first_.empty()) {
        verdict.text = fmt::format("{} ({} allowed), at most {:.3g}", first_, tolerance_, largest_);
    } else if (next_) {
        verdict.text = fmt::format("the run ends before {} s", next_->time);
    } else if (lines_ != instants_ * movable_) {
        verdict.text = fmt::format("trajectory.csv has {} lines instead of {} for {} moving bodies at {} times",
                                   lines_, instants_ * movable_, movable_, instants_);
    } else if (last_ + 1.5 * spacing_ < end_) {
        verdict.text = fmt::format("trajectory.csv ends at {} s, the run at {} s", last_, end_);
    } else {
        verdict.holds = true;
    }
    return verdict;
}

}  // namespace pushfactor::demos::checks
