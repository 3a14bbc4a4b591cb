#include "demos/runs/trajectory.h"

#include "demos/base/text/numbers.h"

#include <fmt/format.h>

#include <algorithm>

namespace pushfactor::demos {

bool is_recorded(const BuiltScene& scene, std::size_t body) {
    return !scene.world.bodies[body].is_static() || (body < scene.bodies.size() && scene.bodies[body].motion);
}

Trajectory::Trajectory(const std::filesystem::path& file, std::uint32_t hash)
    : reader_("--from-trajectory ", file), next_(reader_.next()) {
    if (!next_ || next_->hash.empty() || next_->hash == std::to_string(hash)) return;
    reader_.refuse("must be of the same scene and options, but for its looks, --seconds and --threads");
}

// Empty if the file has no such instant.
std::vector<BodyPose> Trajectory::poses_at(double time) {
    while (next_ && next_->time < time) next_ = reader_.next();
    std::vector<BodyPose> poses;
    for (; next_ && next_->time == time; next_ = reader_.next()) poses.push_back(next_->pose);
    return poses;
}

void Trajectory::place(Simulation& simulation, long step) {
    if (step == placed_) return;
    if (step < placed_) {
        reader_.rewind();
        next_ = reader_.next();
    }
    const double time = (simulation.settings().dt * Rational{step, 1}).value();
    const std::vector<BodyPose> poses = poses_at(time);
    const BuiltScene& scene = simulation.scene();
    std::vector<std::size_t> expected;
    for (std::size_t i = 0; i < scene.world.bodies.size(); ++i) {
        if (is_recorded(scene, i)) expected.push_back(i);
    }
    if (poses.empty() && !expected.empty()) {
        reader_.refuse(fmt::format(
            "must have the poses at {} s; it was written for fewer seconds, or with another --dt or --fps",
            to_text(time)));
    }
    const auto same_body = [](const BodyPose& pose, std::size_t body) { return pose.body == body; };
    if (!std::ranges::equal(poses, expected, same_body)) {
        reader_.refuse(fmt::format("line {}: must have one line for each body that moves, {} at {} s, not {}",
                                   reader_.line(), expected.size(), to_text(time), poses.size()));
    }
    for (const BodyPose& pose : poses) {
        const engine::Body& body = scene.world.bodies[pose.body];
        if (step > 0 || (body.position == pose.position && body.orientation.coeffs() == pose.orientation.coeffs()))
            continue;
        reader_.refuse(fmt::format("must be of the same scene and options: body {} ({}) starts elsewhere",
                                   pose.body, body_name(scene, static_cast<int>(pose.body))));
    }
    simulation.show(step, poses);
    placed_ = step;
}

}  // namespace pushfactor::demos
