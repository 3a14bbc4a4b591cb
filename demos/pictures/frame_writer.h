// Where the pictures of a film go: PNG files, a video, or both.
#pragma once

#include "demos/pictures/video.h"
#include "renderer/image.h"

#include <filesystem>
#include <future>
#include <optional>
#include <string>

namespace pushfactor::demos::pictures {

// Encodes and writes one frame while the next one is simulated and drawn. Frames keep their order, at most one
// waits, and what goes wrong is thrown by the next call: OutputError that says which file and why.
//
// A video needs ffmpeg. Without it the frames are written as PNG, wanted or not, so that nothing is lost, and
// finish() throws.
class FrameWriter {
  public:
    // PNG files go to `folder` when `png`. `video` must have a name that check_video_name() accepts.
    FrameWriter(std::filesystem::path folder, bool png, const std::optional<std::string>& video,
                const Rational& fps);

    void write(const std::string& name, renderer::Image image);
    void finish();

  private:
    void encode(const std::string& name, const renderer::Image& image);

    std::filesystem::path folder_;
    bool png_;
    std::optional<std::string> video_name_;
    Rational fps_;
    bool can_film_;
    std::unique_ptr<Video> video_;  // from the first frame on, whose size it has
    std::future<void> writing_;     // last, so that it ends before what it uses
};

}  // namespace pushfactor::demos::pictures
