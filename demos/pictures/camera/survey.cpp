#include "demos/pictures/camera/survey.h"

#include "demos/pictures/camera/balls.h"
#include "demos/pictures/camera/overview.h"
#include "demos/pictures/overlays/overlay.h"
#include "demos/platform/progress.h"
#include "demos/text/errors.h"
#include "demos/text/median.h"

#include <algorithm>

namespace pushfactor::demos::pictures {

namespace {

// Of one panel.
class Surveyor : public Observer {
  public:
    using Maxima = std::map<OverlayKind, std::vector<double>>;

    Surveyor(const Session& session, Outline& outline, Maxima& maxima, Survey& found)
        : run_(session.run(0)),
          frames_(session.sequence().frames.front()),
          choices_(session.choices(0).frames),
          ghosts_(plan_ghosts(choices_, run_.settings().dt)),
          near_(surroundings(movable_balls(run_.scene()))),
          places_(run_.scene().bodies.size()),
          outline_(outline),
          maxima_(maxima),
          found_(found) {
        step(0);
    }

    void step(std::size_t) override {
        if (choices_.camera.fit && is_shown()) add_moving(run_.scene(), near_, outline_);
    }

    void frame(std::size_t number) override {
        add_places(run_.scene(), places_);
        for (const OverlayItem& item : choices_.overlay) {
            double most = 0.0;
            for (const Quantity& quantity : quantities(run_.scene(), item.kind)) {
                const double size = quantity.value.norm();
                most = std::max(most, size);
                if (size > 0.0 || !has_arrows(item.kind)) found_.shown.insert({item.kind, quantity.kind});
            }
            auto& at_frame = maxima_[item.kind];
            at_frame.resize(frames_.size(), 0.0);
            at_frame[number] = std::max(at_frame[number], most);
        }
        next_ = number + 1;
    }

    void end() {
        add_corners(places_, run_.scene(), found_.reached);
        if (choices_.camera.fit) add_support(run_.scene(), outline_);
    }

  private:
    // Whether the next frame shows this step.
    bool is_shown() const {
        const double dt = run_.settings().dt.value();
        const double frame_time = dt * static_cast<double>(frames_[next_].step);
        return std::ranges::binary_search(ghosts_, run_.sample().step) ||
               run_.sample().time > frame_time - choices_.trail_seconds() - 0.5 * dt;
    }

    const Simulation& run_;
    const Frames& frames_;
    const FrameChoices& choices_;
    std::vector<long> ghosts_;
    Eigen::AlignedBox3d near_;
    std::vector<Eigen::AlignedBox3d> places_;
    std::size_t next_ = 0;  // frame
    Outline& outline_;
    Maxima& maxima_;
    Survey& found_;
};

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

Survey survey(const std::vector<ComparedRun>& panels, const std::vector<Frames>& frames,
              const Session::GoTo& go_to) {
    Survey found;
    Surveyor::Maxima maxima;
    Outline outline;
    for (std::size_t p = 0; p < panels.size(); ++p) {
        Session session({.panels = {panels[p]}, .frames = {frames[p]}}, false, go_to);
        Surveyor surveyor(session, outline, maxima, found);
        try {
            session.play_frames({&surveyor}, [](const Simulation&) {
                stop_if_interrupted("nothing was drawn yet");
                return true;
            });
        } catch (const NonFiniteError&) {
            // The run that is drawn reports it.
        }
        surveyor.end();
        if (p + 1 == panels.size()) found.subject = subject_of(session.run(0).scene(), outline);
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
