#include "demos/pictures/overview.h"

#include "demos/pictures/framing.h"
#include "demos/pictures/survey.h"
#include "demos/runs/scene.h"

#include <algorithm>

namespace pushfactor::demos::pictures {

namespace {

// From this many radii away a body is a pixel or two in a picture 720 pixels high.
constexpr double visible = 300.0;

// Region within which moving bodies are kept in view.
Eigen::AlignedBox3d surroundings(const std::vector<Ball>& start) {
    Eigen::AlignedBox3d box;
    double radius = 0.0;
    for (const Ball& ball : start) {
        box.extend(ball.centre);
        radius = std::max(radius, ball.radius);
    }
    const double reach = std::max(visible * radius, 10.0 * box.diagonal().norm());
    return {box.min() - engine::Vector3::Constant(reach), box.max() + engine::Vector3::Constant(reach)};
}

}  // namespace

View overview(const View& view, const std::vector<Ball>& start, std::vector<Ball> reached, double aspect) {
    if (start.empty()) return view;
    const Eigen::AlignedBox3d near = surroundings(start);
    for (Ball& ball : reached) ball.centre = ball.centre.cwiseMax(near.min()).cwiseMin(near.max());
    reached.insert(reached.end(), start.begin(), start.end());
    return fitted(view, reached, aspect);
}

double least_aspect(const FrameChoices& frames, std::size_t panels) {
    return static_cast<double>(frames.width) / static_cast<double>(panels) / frames.height;
}

void add_overview(std::vector<ComparedRun>& panels, const std::vector<std::vector<Frame>>& frames,
                  const GoTo& go_to) {
    const Choices& first = panels.front().choices;
    if (first.description.has_camera || first.frames.camera.view) return;
    const std::vector<Ball> start = movable_balls(build_scene(first));
    if (start.empty()) return;
    const View view = overview(first.description.view, start, survey(panels, frames, go_to).reached,
                               least_aspect(first.frames, panels.size()));
    for (ComparedRun& panel : panels) panel.choices.description.view = view;
}

}  // namespace pushfactor::demos::pictures
