#include "demos/pictures/camera/survey.h"

#include "demos/pictures/camera/balls.h"
#include "demos/pictures/camera/overview.h"
#include "demos/pictures/overlays/overlay.h"
#include "demos/platform/progress.h"
#include "demos/runs/measurements.h"
#include "demos/runs/simulation.h"
#include "demos/text/errors.h"

#include <algorithm>

namespace pushfactor::demos::pictures {

namespace {

// Advances to a step and shows each to `visit`. False if the run becomes non-finite before it; the run that is
// drawn reports that.
template <typename Visit>
bool reaches(Simulation& simulation, long step, const GoTo& go_to, const Visit& visit) {
    if (go_to) {
        go_to(simulation, step);
        visit();
        return true;
    }
    try {
        while (simulation.sample().step < step) {
            stop_if_interrupted("nothing was drawn yet");
            simulation.advance();
            visit();
        }
    } catch (const NonFiniteError&) {
        return false;
    }
    return true;
}

}  // namespace

void add_places(const BuiltScene& scene, std::vector<Eigen::AlignedBox3d>& places) {
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (goes_about(scene.bodies[i])) places[i].extend(scene.world.bodies[i].position);
    }
}

void add_corners(const std::vector<Eigen::AlignedBox3d>& boxes, const BuiltScene& scene, std::vector<Ball>& balls) {
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        if (boxes[i].isEmpty()) continue;
        for (int corner = 0; corner < 8; ++corner) {
            balls.push_back({.centre = boxes[i].corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner)),
                             .radius = bounding_radius(scene.bodies[i])});
        }
    }
}

Survey survey(const std::vector<ComparedRun>& panels, const std::vector<Frames>& frames, const GoTo& go_to) {
    Survey found;
    std::map<OverlayKind, std::vector<double>> maxima;
    Outline outline;
    for (std::size_t p = 0; p < panels.size(); ++p) {
        const Choices& choices = panels[p].choices;
        Simulation simulation(choices);
        const BuiltScene& scene = simulation.scene();
        std::vector<Eigen::AlignedBox3d> places(scene.bodies.size());
        const Eigen::AlignedBox3d near = surroundings(movable_balls(scene));
        const std::vector<long> ghosts = plan_ghosts(choices.frames, choices.settings.dt);
        const double dt = choices.settings.dt.value();
        const auto is_shown = [&](double frame_time) {
            return std::ranges::binary_search(ghosts, simulation.sample().step) ||
                   simulation.sample().time > frame_time - choices.frames.trail_seconds() - 0.5 * dt;
        };
        for (std::size_t f = 0; f < frames[p].size(); ++f) {
            const double time = dt * static_cast<double>(frames[p][f].step);
            const auto add_shown = [&] {
                if (choices.frames.camera.fit && is_shown(time)) add_moving(scene, near, outline);
            };
            if (f == 0) add_shown();
            if (!reaches(simulation, frames[p][f].step, go_to, add_shown)) break;
            add_places(scene, places);
            for (const OverlayItem& item : choices.frames.overlay) {
                double most = 0.0;
                for (const Quantity& quantity : quantities(scene, item.kind)) {
                    const double size = quantity.value.norm();
                    most = std::max(most, size);
                    if (size > 0.0 || !has_arrows(item.kind)) {
                        found.shown.insert({item.kind, quantity.kind});
                    }
                }
                auto& at_frame = maxima[item.kind];
                at_frame.resize(frames[p].size(), 0.0);
                at_frame[f] = std::max(at_frame[f], most);
            }
        }
        add_corners(places, scene, found.reached);
        if (choices.frames.camera.fit) add_support(scene, outline);
        if (p + 1 == panels.size()) found.subject = subject_of(scene, outline);
    }
    for (auto& [kind, values] : maxima) {
        std::erase(values, 0.0);
        if (!values.empty()) found.typical[kind] = median(values);
    }
    return found;
}

double least_aspect(const FrameChoices& frames, std::size_t panels) {
    return static_cast<double>(frames.width) / static_cast<double>(panels) / frames.height;
}

void add_overview(std::vector<ComparedRun>& panels, SurveyOnce& survey) {
    const Choices& first = panels.front().choices;
    if (first.description.has_camera || first.frames.camera.view) return;
    const std::vector<Ball> start = movable_balls(build_scene(first));
    if (start.empty()) return;
    const View view = overview(first.description.view, start, survey.of(panels).reached,
                               least_aspect(first.frames, panels.size()));
    for (ComparedRun& panel : panels) panel.choices.description.view = view;
}

}  // namespace pushfactor::demos::pictures
