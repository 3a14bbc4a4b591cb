#include "demos/runs/trajectory.h"

#include "demos/text/errors.h"
#include "demos/text/numbers.h"

#include <fmt/format.h>

#include <array>

namespace pushfactor::demos {

bool is_recorded(const BuiltScene& scene, std::size_t body) {
    return !scene.world.bodies[body].is_static() || (body < scene.bodies.size() && scene.bodies[body].motion);
}

Trajectory::Trajectory(std::filesystem::path file) : name_(file.string()), stream_(file) {
    if (!stream_) throw UsageError(fmt::format("--from-trajectory {}: cannot be read", name_));
    rewind();
}

void Trajectory::refuse(const std::string& what) const {
    throw UsageError(fmt::format("--from-trajectory {}: {}", name_, what));
}

void Trajectory::rewind() {
    stream_.clear();
    stream_.seekg(0);
    if (!std::getline(stream_, text_) || !text_.starts_with(pose_columns)) {
        refuse(fmt::format("line 1: must begin with {}", pose_columns));
    }
    lines_ = 1;
    placed_ = -1;
    has_next_ = read_line();
}

bool Trajectory::read_line() {
    if (!std::getline(stream_, text_)) return false;
    ++lines_;
    std::array<double, 9> values;
    std::string_view rest = text_;
    for (double& value : values) {
        const std::size_t comma = rest.find(',');
        const auto number = parse_number(rest.substr(0, comma));
        if (!number || comma == std::string_view::npos) {
            refuse(fmt::format("line {}: must be numbers, as `--trajectory` writes them", lines_));
        }
        value = *number;
        rest.remove_prefix(comma + 1);
    }
    next_.time = values[0];
    next_.pose = {.body = static_cast<std::size_t>(std::max(values[1], 0.0)),
                  .position = {values[2], values[3], values[4]},
                  .orientation = {values[5], values[6], values[7], values[8]}};
    return true;
}

// Empty if the file has no such instant.
std::vector<BodyPose> Trajectory::poses_at(double time) {
    while (has_next_ && next_.time < time) has_next_ = read_line();
    std::vector<BodyPose> poses;
    for (; has_next_ && next_.time == time; has_next_ = read_line()) poses.push_back(next_.pose);
    return poses;
}

void Trajectory::place(Simulation& simulation, long step) {
    if (step == placed_) return;
    if (step < placed_) rewind();
    const double time = (simulation.settings().dt * Rational{step, 1}).value();
    const std::vector<BodyPose> poses = poses_at(time);
    const BuiltScene& scene = simulation.scene();
    std::vector<std::size_t> expected;
    for (std::size_t i = 0; i < scene.world.bodies.size(); ++i) {
        if (is_recorded(scene, i)) expected.push_back(i);
    }
    if (poses.empty() && !expected.empty()) {
        refuse(fmt::format(
            "must have the poses at {} s; it was written for fewer seconds, or with another --dt or --fps",
            to_text(time)));
    }
    const auto same_body = [](const BodyPose& pose, std::size_t body) { return pose.body == body; };
    if (!std::ranges::equal(poses, expected, same_body)) {
        refuse(fmt::format("line {}: must have one line for each body that moves, {} at {} s, not {}", lines_,
                           expected.size(), to_text(time), poses.size()));
    }
    for (const BodyPose& pose : poses) {
        const engine::Body& body = scene.world.bodies[pose.body];
        if (step > 0 || (body.position == pose.position && body.orientation.coeffs() == pose.orientation.coeffs()))
            continue;
        refuse(fmt::format("must be of the same scene and options: body {} ({}) starts elsewhere", pose.body,
                           body_name(scene, static_cast<int>(pose.body))));
    }
    simulation.show(step, poses);
    placed_ = step;
}

}  // namespace pushfactor::demos
