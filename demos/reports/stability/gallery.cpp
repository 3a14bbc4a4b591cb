#include "demos/reports/stability/gallery.h"

#include "demos/pictures/camera/framing.h"
#include "demos/pictures/camera/layout.h"
#include "demos/pictures/camera/survey.h"
#include "demos/pictures/draw_list.h"
#include "renderer/base/renderer_error.h"

#include <fmt/format.h>

namespace pushfactor::demos::reports::stability {

namespace {

using engine::Vector3;

constexpr pictures::Size thumbnail{320, 180};  // pixels
constexpr int columns = 3;
constexpr int samples = 4;
constexpr float letters = 11.0f;  // pixels

// The start of a scene: all finite bodies by their corners, because a ball around a floor or a card is mostly
// empty, and the fixed points of its distances.
std::vector<pictures::Ball> balls_of(const SceneDescription& start) {
    std::vector<pictures::Ball> balls;
    for (const BodyDescription& body : start.bodies) {
        std::ranges::copy(pictures::hull_of(body, body.position, body.orientation), std::back_inserter(balls));
    }
    for (const DistanceDescription& distance : start.distances) {
        if (distance.a.body == "world") balls.push_back({distance.a.point, 0.0});
    }
    return balls;
}

Eigen::AlignedBox3d place_of(const std::vector<pictures::Ball>& balls) {
    Eigen::AlignedBox3d place;
    for (const pictures::Ball& ball : balls) {
        place.extend(ball.centre + Vector3::Constant(ball.radius));
        place.extend(ball.centre - Vector3::Constant(ball.radius));
    }
    return place;
}

// Pictures have single precision, so scenes far from the origin are drawn shifted: the point that becomes the
// origin.
Vector3 origin_of(const SceneDescription& start) {
    const Eigen::AlignedBox3d place = place_of(balls_of(start));
    const bool far = !place.isEmpty() && place.center().norm() > 100.0 * place.diagonal().norm();
    return far ? Vector3(start.bodies.front().position) : Vector3::Zero();
}

void shift(SceneDescription& scene, const Vector3& by) {
    for (BodyDescription& body : scene.bodies) body.position += by;
    const auto shift_ends = [&by](auto& link) {
        for (DistanceDescription::End* end : {&link.a, &link.b}) {
            if (end->body == "world") end->point += by;
        }
    };
    std::ranges::for_each(scene.distances, shift_ends);
    std::ranges::for_each(scene.joints, shift_ends);
    scene.view.eye += by;
    scene.view.target += by;
}

// A camera with the start and the end of the run in view, without bodies that ended so far away that nothing else
// would be visible.
View camera(const SceneDescription& start, const BuiltScene& end, double aspect) {
    std::vector<pictures::Ball> balls = balls_of(start);
    const std::vector<pictures::Ball> ended = pictures::movable_balls(end);
    if (balls.empty()) return pictures::fitted(start.view, ended, aspect);
    const Eigen::AlignedBox3d place = place_of(balls);
    for (const pictures::Ball& ball : ended) {
        if (place.exteriorDistance(ball.centre) < 2.0 * place.diagonal().norm()) balls.push_back(ball);
    }
    return pictures::fitted(start.view, balls, aspect);
}

// Blank if the state is beyond single precision.
renderer::Image draw(pictures::OffscreenRenderer& offscreen, const pictures::Size& size, const Trial& trial) {
    Choices choices = understand(trial.state().string(), {});
    SceneDescription start = trial.start();
    const Vector3 here = -origin_of(start);
    shift(start, here);
    shift(choices.description, here);
    const BuiltScene scene = build_scene(choices);
    const double aspect = static_cast<double>(size.width) / size.height;
    try {
        return offscreen.draw(pictures::draw_list(scene, camera(start, scene, aspect)), size, samples);
    } catch (const renderer::RendererError&) {
        return renderer::blank_image(size.width, size.height, glm::vec3(0.9f));
    }
}

std::string label_of(const Trial& trial) {
    return fmt::format("{}, {}: {}{}", trial.one().name, trial.expected().preset, trial.outcome(),
                       trial.holds() ? "" : " (not as expected)");
}

}  // namespace

Gallery::Gallery(const std::filesystem::path& folder) {
    try {
        output_ = std::make_unique<figures::FigureOutput>(
            folder, FigureFormat{.width = columns * thumbnail.width, .samples = samples});
    } catch (const renderer::RendererError& error) {
        missing_ = error.what();
    }
}

std::string Gallery::hang(const std::string& name, std::span<const Trial> trials) {
    std::vector<const Trial*> shown;
    for (const Trial& trial : trials) {
        if (output_ && std::filesystem::exists(trial.state())) shown.push_back(&trial);
    }
    if (shown.empty()) return {};
    const int across = std::min(columns, static_cast<int>(shown.size()));
    const int rows = (static_cast<int>(shown.size()) + across - 1) / across;
    const pictures::Layout layout =
        pictures::grid({across * thumbnail.width, rows * thumbnail.height}, across, rows);
    std::vector<renderer::Image> images;
    for (const Trial* trial : shown) images.push_back(draw(output_->offscreen(), layout.cell, *trial));
    renderer::Image sheet = pictures::assemble(layout, images);
    for (std::size_t i = 0; i < shown.size(); ++i) {
        output_->offscreen().lettering().name(sheet, layout.place(i), label_of(*shown[i]), letters);
    }
    return output_->save(sheet, name);
}

}  // namespace pushfactor::demos::reports::stability
