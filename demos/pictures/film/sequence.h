// The frames of a scene: its runs are stepped to them and drawn.
#pragma once

#include "demos/options/comparison.h"
#include "demos/options/frame_options.h"
#include "demos/pictures/film/film.h"
#include "demos/pictures/film/frame_queue.h"
#include "demos/pictures/replay/replay.h"
#include "demos/runs/observed_run.h"
#include "demos/runs/trajectory.h"
#include "demos/text/shard.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace pushfactor::demos::pictures {

struct Sequence {
    std::vector<ComparedRun> panels;  // one, or those of a comparison
    std::vector<Frames> frames;       // per panel, equally many in each
    Shard shard{};                    // the frames that are drawn: every `count`-th

    const std::string& scene() const { return panels.front().choices.description.name; }
    std::size_t frame_count() const { return frames.front().size(); }
    std::size_t drawn_count() const;  // of the shard
    // A run ends with its last still.
    long last_step(std::size_t panel) const;
};

// The options that a film from a trajectory cannot have, because it has poses only. Throws UsageError.
void require_poses_only(const Sequence& sequence, const std::string& file);

// Draws the frames of the shard from the poses of a trajectory, without simulating, and sends them to `queue`,
// which is flushed. `simulation` is that of the film. Ends early as take_frames() does.
void draw_frames(const Sequence& sequence, Simulation& simulation, Trajectory& trajectory, const Film& film,
                 FrameQueue& queue, const std::function<void(long)>& progress);

// The frames that these options ask for. Throws UsageError.
Sequence plan_sequence(const std::string& scene, const GivenOptions& given);

// What is made of the runs of a sequence; either may be absent.
struct Takers {
    std::optional<Film> film{};
    std::optional<Replay> replay{};
};

// Steps the runs to each frame and then to the end: simulates on one thread, draws on this one and sends the images
// to `queue`, which is flushed. `progress` receives the number of frames so far. Ends early, without an error, when
// the program is interrupted.
void take_frames(const Sequence& sequence, std::vector<ObservedRun>& runs, Takers& takers, FrameQueue& queue,
                 StageTimes* times, const std::function<void(long)>& progress);

// Completes the files of the runs and returns their summary as JSON. `driver` is what drew (Studio::driver()),
// empty if nothing was drawn.
std::string finish(const Sequence& sequence, std::vector<ObservedRun>& runs, const std::string& driver);

}  // namespace pushfactor::demos::pictures
