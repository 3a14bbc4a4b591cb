#include "demos/pictures/camera/survey.h"

#include "demos/base/platform/progress.h"
#include "demos/base/text/errors.h"
#include "demos/base/text/median.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pushfactor::demos::pictures {

namespace {

// Of one panel.
class Surveyor : public Observer {
  public:
    using Maxima = std::map<OverlayKind, std::vector<double>>;

    Surveyor(const Session& session, Maxima& maxima, Survey& found)
        : run_(session.run(0)),
          frames_(session.sequence().frames.front()),
          choices_(session.choices(0).frames),
          ghosts_(plan_ghosts(choices_, run_.settings().dt)),
          extents_(run_, choices_.camera.fit),
          maxima_(maxima),
          found_(found) {
        step(0);
    }

    // If the next frame shows this step.
    void step(std::size_t) override {
        const double dt = run_.settings().dt.value(), now = run_.sample().time;
        const double frame_time = dt * static_cast<double>(frames_[next_].step);
        const bool ghost = std::ranges::binary_search(ghosts_, run_.sample().step);
        if (ghost || now > frame_time - choices_.trail_seconds() - 0.5 * dt) extents_.add_outline();
    }

    void frame(std::size_t number) override {
        extents_.add_places();
        for (const OverlayItem& item : choices_.overlay) {
            double most = 0.0;
            if (item.kind == OverlayKind::trails) found_.shown.insert({item.kind, 0});
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

    const Extents& extents() const { return extents_; }

  private:
    const Simulation& run_;
    const Frames& frames_;
    const FrameChoices& choices_;
    std::vector<long> ghosts_;
    Extents extents_;
    std::size_t next_ = 0;  // frame
    Maxima& maxima_;
    Survey& found_;
};

// 1, 2 or 5 times a power of ten, at most `value`.
double round_number(double value) {
    const double power = std::pow(10.0, std::floor(std::log10(value)));
    const double digit = value / power;
    return power * (digit >= 5.0 ? 5.0 : digit >= 2.0 ? 2.0 : 1.0);
}

}  // namespace

Extents::Extents(const Simulation& run, bool fit)
    : run_(run), fit_(fit), near_(surroundings(movable_balls(run.scene()))), places_(run.scene().bodies.size()) {}

void Extents::add_outline() {
    if (fit_) add_moving(run_.scene(), near_, outline_);
}

void Extents::add_places() {
    const BuiltScene& scene = run_.scene();
    for (std::size_t i = 0; i < places_.size(); ++i) {
        if (goes_about(scene.bodies[i])) places_[i].extend(scene.world.bodies[i].position);
    }
}

void Extents::add_to(Outline& outline, std::vector<Ball>& reached) const {
    outline.add(outline_);
    if (fit_) add_support(run_.scene(), outline);
    for (std::size_t i = 0; i < places_.size(); ++i) {
        if (places_[i].isEmpty()) continue;
        for (int corner = 0; corner < 8; ++corner) {
            reached.push_back({.centre = places_[i].corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner)),
                               .radius = bounding_radius(run_.scene().bodies[i])});
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
        Surveyor surveyor(session, maxima, found);
        try {
            session.play_frames({&surveyor}, [](const Simulation&) {
                stop_if_interrupted("nothing was drawn yet");
                return true;
            });
        } catch (const NonFiniteError&) {
            // The run that is drawn reports it.
        }
        surveyor.extents().add_to(outline, found.reached);
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

std::vector<Scale> scales_of(const std::vector<OverlayItem>& overlay, const Survey& survey, const View& view) {
    std::vector<Scale> scales;
    for (const OverlayItem& item : overlay) {
        const auto typical = survey.typical.find(item.kind);
        const double usual = typical == survey.typical.end() ? 1.0 : typical->second;
        const double chosen = usual / (typical_arrow * distance_of(view));
        scales.push_back({item.kind, item.units_a_metre.value_or(chosen)});
    }
    return scales;
}

LegendLine legend_line(const LegendEntry& entry, const Scale& scale, const View& view, int height) {
    if (entry.unit.empty()) return {.colour = entry.colour, .text = entry.name};
    const double example = round_number(1.3 * typical_arrow * distance_of(view) * scale.units_a_metre);
    const double pixels_a_metre = 0.5 * height / (distance_of(view) * half_tangent(view));
    return {.colour = entry.colour,
            .text = fmt::format("{}, {:g} {}", entry.name, example, entry.unit),
            .arrow = static_cast<float>(example / scale.units_a_metre * pixels_a_metre)};
}

}  // namespace pushfactor::demos::pictures
