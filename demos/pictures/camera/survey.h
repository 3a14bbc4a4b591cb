// Extents and scales of a run, found by a separate run before the first picture: physics is cheap compared with
// pictures, and scale and camera must not change from frame to frame. Made only for options that need it.
#pragma once

#include "demos/pictures/camera/framing.h"
#include "demos/pictures/camera/outline.h"
#include "demos/pictures/lettering.h"
#include "demos/pictures/overlays/overlay.h"
#include "demos/runs/session.h"

#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace pushfactor::demos::pictures {

struct Survey {
    std::vector<Ball> reached;  // around all moving bodies, in all frames of all panels
    Subject subject;            // of all frames of all panels, if the camera is to fit it
    std::map<OverlayKind, double>
        typical;  // N or m/s: median over the frames of the largest value in any panel; absent for none
    std::set<std::pair<OverlayKind, std::size_t>> shown;  // legend entries that occur
};

// Whether camera or overlay depend on the whole run.
inline bool needs_survey(const FrameChoices& choices) {
    return choices.camera.fit || !choices.overlay.empty();
}

// What a run reaches, collected as it goes on.
class Extents {
  public:
    // `run` is at its start and must outlive this. The outline is collected if the camera is to fit it.
    Extents(const Simulation& run, bool fit);

    void add_outline();
    // Of the bodies that move; the box around all places of each, so that memory does not grow with the run.
    void add_places();

    // Adds the outline with what supports it, and the corners of the boxes as balls of the bodies' sizes.
    void add_to(Outline& outline, std::vector<Ball>& reached) const;

  private:
    const Simulation& run_;
    bool fit_;
    Eigen::AlignedBox3d near_;  // where a body is worth showing
    Outline outline_;
    std::vector<Eigen::AlignedBox3d> places_;  // of each body
};

// `frames` are those of the panels, in the same order. Runs are advanced, or brought to each frame by `go_to`.
Survey survey(const std::vector<ComparedRun>& panels, const std::vector<Frames>& frames,
              const Session::GoTo& go_to = {});

// The same, made when it is first asked for: an overview and a camera that fits need one run, not two.
class SurveyOnce {
  public:
    // `frames` must outlive it.
    explicit SurveyOnce(const std::vector<Frames>& frames, Session::GoTo go_to = {})
        : frames_(frames), go_to_(std::move(go_to)) {}

    const Survey& of(const std::vector<ComparedRun>& panels) {
        if (!made_) made_ = survey(panels, frames_, go_to_);
        return *made_;
    }

  private:
    const std::vector<Frames>& frames_;
    Session::GoTo go_to_;
    std::optional<Survey> made_;
};

// Width over height of the narrowest panel that may be needed for so many.
double least_aspect(const FrameChoices& frames, std::size_t panels);

// Gives the panels a view that shows all motion in all frames, found by the survey; does nothing if the scene
// has a camera or one was given. Bodies that fly so far that the picture would show nothing else are followed only
// part of their way.
void add_overview(std::vector<ComparedRun>& panels, SurveyOnce& survey);

struct Scale {
    OverlayKind kind = OverlayKind::contacts;
    double units_a_metre = 1.0;  // N or m/s per metre of arrow
};

// Length of a typical arrow as a share of the distance from eye to target.
inline constexpr double typical_arrow = 0.11;

// As given, or such that a typical value of the survey makes a typical arrow in `view`.
std::vector<Scale> scales_of(const std::vector<OverlayItem>& overlay, const Survey& survey, const View& view);

// With an arrow as long as a round number of the entry's unit is at the target of `view`, in a picture of `height`
// pixels; points have none.
LegendLine legend_line(const LegendEntry& entry, const Scale& scale, const View& view, int height);

}  // namespace pushfactor::demos::pictures
