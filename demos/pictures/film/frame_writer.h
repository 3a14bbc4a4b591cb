// Writes the pictures of a film as PNG files, a video, or both.
#pragma once

#include "demos/pictures/film/frame_queue.h"
#include "demos/pictures/film/video.h"

#include <filesystem>
#include <optional>
#include <string>

namespace pushfactor::demos::pictures {

// Frames are encoded on background threads and written in order, so that the files are always the first frames.
//
// A video needs ffmpeg (require_ffmpeg()).
class FrameWriter {
  public:
    // PNG files go to `folder` when `png`, with the mark of their `film` (film_mark()). `video` must have a name
    // that check_video_name() accepts. `times`, if not null, is told how long encoding and writing take.
    FrameWriter(std::filesystem::path folder, bool png, const std::optional<std::string>& video,
                const Rational& fps, StageTimes* times = nullptr, std::string film = {});

    // Throws OutputError, also in the name of a frame that was sent before, that says which file and why.
    FrameQueue& queue() { return queue_; }

    // Waits until all frames are written, and completes the video.
    void finish();

  private:
    FrameQueue::End encode(const std::string& name, const renderer::Image& image, StageWatch& watch);

    std::filesystem::path folder_;
    bool png_;
    std::optional<std::string> video_name_;
    Rational fps_;
    std::string film_;
    // Made with the first frame, which has its size; used by the thread whose turn it is.
    std::optional<Video> video_;
    FrameQueue queue_;
};

}  // namespace pushfactor::demos::pictures
