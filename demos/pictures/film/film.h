// The pictures of a run, or of several runs side by side, drawn while these go on.
#pragma once

#include "demos/pictures/camera/layout.h"
#include "demos/pictures/camera/survey.h"
#include "demos/pictures/film/frame_queue.h"
#include "demos/pictures/film/motion.h"
#include "demos/pictures/replay/replay.h"
#include "demos/runs/session.h"

#include <functional>
#include <string>
#include <vector>

namespace pushfactor::demos::pictures {

// The panels of a film at one time.
struct Snapshot {
    std::string name;   // of the frame's file
    double time = 0.0;  // s
    std::vector<renderer::Picture> pictures;
    std::vector<std::vector<Moment>> open;  // per panel, while the shutter is
};

class Film {
  public:
    // `session` is at its start and must outlive the film. The survey of the panels is made if the frame options
    // need it. Throws UsageError for an overlay of parts that the scene lacks.
    Film(OffscreenRenderer& offscreen, const Session& session, SurveyOnce& survey);

    // Called after each step of a run.
    void note(std::size_t panel);

    // The current state of the runs. Drawing uses only this snapshot, so that the runs may go on meanwhile.
    Snapshot look(const std::string& name) const;

    // Draws a snapshot and its captions into `sheet`, whose memory is reused. Throws renderer::RendererError for
    // what cannot be drawn.
    void draw(const Snapshot& moment, renderer::Image& sheet) const;

  private:
    const BuiltScene& scene(std::size_t panel) const { return session_.run(panel).scene(); }
    View seen_from(const BuiltScene& scene) const;
    Subject subject_in(const Size& cell) const;
    Layout closest_layout(const Size& sheet) const;
    View place_camera(const BuiltScene& scene, double across) const;
    renderer::Picture coloured(std::size_t panel) const;
    renderer::Picture look(std::size_t panel) const;
    void draw_panel(const Snapshot& moment, std::size_t panel, renderer::Image& image) const;
    std::vector<LegendLine> legend(const View& view) const;
    std::size_t legend_lines() const;
    void write(renderer::Image& sheet, double time) const;

    OffscreenRenderer& offscreen_;
    const Session& session_;
    FrameChoices choices_;
    std::string caption_;
    Survey survey_;
    Layout layout_;
    int strip_ = 0;            // pixels below several panels, for what belongs to all of them
    std::vector<View> views_;  // of the panels, at the start
    std::vector<Scale> scales_;
    std::vector<Motion> motions_;  // of the panels
};

// The options that a film from a trajectory cannot have, because it has poses only. Throws UsageError.
void require_poses_only(const Sequence& sequence, const std::string& file);

// What is made at each frame; either may be null.
struct Pictures {
    Film* film = nullptr;
    Replay* replay = nullptr;
};

// Plays a session: simulates on one thread, draws the frames of the shard on this one and sends the images to
// `queue`, which is flushed. `recorder` may be null; `progress` receives the number of frames so far. Ends early,
// without an error, when the program is interrupted.
void take_frames(Session& session, Observer* recorder, const Pictures& pictures, FrameQueue& queue,
                 StageTimes* times, const std::function<void(long)>& progress);

}  // namespace pushfactor::demos::pictures
