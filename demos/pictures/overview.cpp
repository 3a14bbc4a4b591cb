#include "demos/pictures/overview.h"

#include "demos/pictures/movable_balls.h"
#include "demos/pictures/survey.h"
#include "demos/runs/scene.h"

namespace pushfactor::demos::pictures {

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
