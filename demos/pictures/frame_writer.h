// Where the pictures of a film go: PNG files, a video, or both.
#pragma once

#include "demos/pictures/stage_times.h"
#include "demos/pictures/video.h"
#include "demos/platform/channel.h"
#include "renderer/images/image.h"

#include <condition_variable>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace pushfactor::demos::pictures {

// Encodes and writes frames on threads of its own while the next ones are simulated and drawn. Frames are written
// in their order, so that those that are there are always the first ones; a few wait at most, and their memory is
// used again. What goes wrong is thrown by the next call: OutputError that says which file and why.
//
// A video needs ffmpeg (require_ffmpeg()).
class FrameWriter {
  public:
    // PNG files go to `folder` when `png`. `video` must have a name that check_video_name() accepts. `times`, if
    // not null, is told how long encoding and writing take.
    FrameWriter(std::filesystem::path folder, bool png, const std::optional<std::string>& video,
                const Rational& fps, StageTimes* times = nullptr);
    // Writes what waits; what goes wrong then is not heard of.
    ~FrameWriter();
    FrameWriter(const FrameWriter&) = delete;
    FrameWriter& operator=(const FrameWriter&) = delete;

    // An image to draw the next frame into: what it shows and its size have no meaning.
    renderer::Image blank();

    // Waits while too many frames wait.
    void write(const std::string& name, renderer::Image image);

    // Waits until all frames are written; there can be no more.
    void flush();
    // Also completes the video.
    void finish();

    // How many frames are written.
    std::size_t written() const;

  private:
    struct Frame {
        std::size_t number;
        std::string name;
        renderer::Image image;
    };

    void work();
    void handle(Frame& frame);
    bool wait_for_turn(std::size_t number);
    void put(const Frame& frame, const std::vector<std::uint8_t>& bytes);
    void end_turn(Frame& frame);
    void note_error();
    void join();

    std::filesystem::path folder_;
    bool png_;
    std::optional<std::string> video_name_;
    Rational fps_;
    StageTimes* times_;
    std::unique_ptr<Video> video_;  // from the first frame on, whose size it has; used by whose turn it is
    std::size_t sent_ = 0;
    Channel<Frame> waiting_;

    mutable std::mutex mutex_;  // of what follows
    std::condition_variable turned_;
    std::size_t turn_ = 0;  // the number of the frame to be written next
    std::exception_ptr error_;
    std::vector<renderer::Image> blanks_;

    std::vector<std::thread> threads_;
};

}  // namespace pushfactor::demos::pictures
