// Frames become a video by way of ffmpeg, a program that is looked for only when a video is wanted.
#pragma once

#include "demos/platform/child_process.h"
#include "demos/text/rational.h"
#include "renderer/images/image.h"

#include <filesystem>
#include <memory>
#include <string>

namespace pushfactor::demos::pictures {

// Throws UsageError unless the name ends in .mp4, .webm or .gif. Looks at the name only.
void check_video_name(const std::filesystem::path& file);

// Throws OutputError that says what to install unless ffmpeg is there, before anything is rendered in vain.
void require_ffmpeg(const std::filesystem::path& file);

// A video that is either made whole or not at all: ffmpeg writes to a temporary file beside `file`
// (name.partial.mp4), and finish() gives it its name. Without finish(), or after an error, ffmpeg is stopped,
// nothing is left and what was there before stays. Every member throws OutputError that names the file and the
// reason, with ffmpeg's own last words where it failed; after that only the destructor may be called.
//
// The name decides the format: .mp4 is H.264, .webm VP9, .gif a GIF of at most 50 frames a second and 640 pixels
// across. A GIF has one palette for all frames, so ffmpeg keeps them in memory until the end, 4 bytes a pixel: it
// is for seconds, not for minutes.
//
// Any number of videos may be made at once, each by one thread at a time.
class Video {
  public:
    // Starts ffmpeg. `width` and `height` in pixels, above 0; `fps` in frames a second, above 0. Throws UsageError
    // for a name that check_video_name() refuses.
    Video(std::filesystem::path file, int width, int height, const Rational& fps);
    ~Video();
    Video(const Video&) = delete;
    Video& operator=(const Video&) = delete;

    // The next frame, of the size given at the start. Waits while ffmpeg is behind.
    void add(const renderer::Image& image);

    // Waits until ffmpeg has written the last frame; the video has its name then. At least one must have been
    // added.
    void finish();

  private:
    void make_temporary();
    void remove_temporary();
    [[noreturn]] void fail(const std::string& why) const;

    std::filesystem::path file_;
    std::filesystem::path temporary_;  // empty when it is not there
    int width_;
    int height_;
    std::unique_ptr<ChildProcess> ffmpeg_;
};

}  // namespace pushfactor::demos::pictures
