// Videos of frames by the program ffmpeg, which is needed only when a video is requested.
#pragma once

#include "demos/base/platform/child_process.h"
#include "demos/base/platform/output_file.h"
#include "demos/base/text/rational.h"
#include "renderer/images/image.h"

#include <filesystem>
#include <optional>
#include <string>

namespace pushfactor::demos::pictures {

// Throws UsageError unless the name ends in .mp4, .webm or .gif. Checks the name only.
void check_video_name(const std::filesystem::path& file);

// Throws OutputError that says what to install if ffmpeg is missing. To be called before rendering.
void require_ffmpeg(const std::filesystem::path& file);

// A video that is written whole or not at all: ffmpeg writes to a temporary file next to `file`,
// and finish() renames it. Without finish(), or after an error, ffmpeg is stopped, the temporary file is removed
// and an existing video stays. Every member throws OutputError that names the file and the reason, with ffmpeg's
// last messages if it failed; after that only the destructor may be called.
//
// The extension decides the format: .mp4 is H.264, .webm VP9, .gif a GIF of at most 50 frames per second and 640
// pixels across. A GIF has one palette for all frames, so ffmpeg keeps them in memory until the end, 4 bytes per
// pixel: it is for seconds, not for minutes.
//
// Several videos may be written at once, each by one thread at a time.
class Video {
  public:
    // Starts ffmpeg. `width` and `height` in pixels, above 0; `fps` in frames per second, above 0. Throws
    // UsageError for a name that check_video_name() refuses.
    Video(std::filesystem::path file, int width, int height, const Rational& fps);

    // Adds the next frame, of the size given at the start. Blocks while ffmpeg is behind.
    void add(const renderer::Image& image);

    // Waits until ffmpeg has written the last frame and renames the file. Needs at least one frame.
    void finish();

  private:
    [[noreturn]] void fail(const std::string& why) const;

    std::filesystem::path file_;
    std::optional<StagedFile> staged_;
    int width_;
    int height_;
    std::optional<ChildProcess> ffmpeg_;  // the last member: it ends before the file is removed
};

}  // namespace pushfactor::demos::pictures
