// The tosses as this engine computes them.
#include "demos/reports/reality/sections.h"
#include "demos/scenes/motions/measured_motion.h"

#include <fmt/format.h>

namespace pushfactor::demos::reports::reality {

namespace {

using engine::Vector3;

SceneDescription scene_from(const Restart& start, const Law& law) {
    return one_on_another("toss",
                          {.name = "board",
                           .shape = PlaneShape{},
                           .position = Vector3(0, law.board, 0),
                           .friction = law.friction,
                           .restitution = law.restitution},
                          {.name = "cube",
                           .shape = BoxShape{Vector3::Constant(edge)},
                           .mass = mass,
                           .moments = Vector3::Constant(moment_of_inertia),
                           .position = start.pose.position,
                           .orientation = start.pose.orientation,
                           .velocity = start.velocity,
                           .angular_velocity = start.angular_velocity,
                           .friction = law.friction,
                           .restitution = law.restitution,
                           .colour = "blue"});
}

}  // namespace

std::vector<Pose> computed(const Restart& start, const Law& law, std::size_t frames) {
    Settings settings = preset_settings("default");
    settings.dt = {1, frames_per_second};
    settings.threads = 1;
    settings.start_kick = StartKick::on;  // the measured velocity is that of the first frame
    Simulation run(build_scene(scene_from(start, law), settings), settings);
    std::vector<Pose> poses{start.pose};
    while (poses.size() < frames) {
        run.advance();
        const engine::Body& now = run.scene().world.bodies.at(1);
        poses.push_back({now.position, now.orientation});
    }
    return poses;
}

SceneDescription scene_of(const Toss& toss, const Law& law) {
    SceneDescription scene = scene_from(start_of(toss), law);
    std::vector<PoseLine> measured;
    for (std::size_t i = 0; i < toss.frames.size(); ++i) {
        measured.push_back({static_cast<double>(i) / frames_per_second,
                            {.position = toss.frames[i].position, .orientation = toss.frames[i].orientation}});
    }
    add_measured(scene, 1, measured);
    const Vector3 middle = 0.5 * (toss.frames.front().position + toss.frames.back().position);
    scene.view = {.eye = middle + Vector3(0.35, 0.3, 0.75), .target = middle};
    scene.options = {{"dt", fmt::format("1/{}", frames_per_second)},
                     {"seconds", fmt::format("{}/{}", toss.frames.size() - 1, frames_per_second)},
                     {"start-kick", "on"}};
    return scene;
}

}  // namespace pushfactor::demos::reports::reality
