// Pictures of a session, drawn while it goes on.
#pragma once

#include "demos/pictures/film/film.h"
#include "demos/pictures/film/frame_queue.h"
#include "demos/pictures/replay/replay.h"

#include <functional>
#include <string>

namespace pushfactor::demos::pictures {

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
