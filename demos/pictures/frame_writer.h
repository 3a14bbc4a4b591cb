// Writes the pictures of a film as PNG files, a video, or both.
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

// Encodes and writes frames on background threads while the next ones are simulated and drawn. Frames are written
// in order, so that the files are always the first frames; the queue is short, and its memory is reused. An error
// is thrown by the next call: OutputError that says which file and why.
//
// A video needs ffmpeg (require_ffmpeg()).
class FrameWriter {
  public:
    // PNG files go to `folder` when `png`. `video` must have a name that check_video_name() accepts. `times`, if
    // not null, is told how long encoding and writing take.
    FrameWriter(std::filesystem::path folder, bool png, const std::optional<std::string>& video,
                const Rational& fps, StageTimes* times = nullptr);
    // Writes the queued frames; errors are ignored.
    ~FrameWriter();
    FrameWriter(const FrameWriter&) = delete;
    FrameWriter& operator=(const FrameWriter&) = delete;

    // A recycled image for the next frame, of unspecified content and size.
    renderer::Image blank();

    // Queues a frame. Blocks while the queue is full.
    void write(const std::string& name, renderer::Image image);

    // Waits until all frames are written; no more can follow.
    void flush();
    // flush(), and completes the video.
    void finish();

    // Number of frames written.
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
    std::unique_ptr<Video>
        video_;  // made with the first frame, which has its size; used by the thread whose turn it is
    std::size_t sent_ = 0;
    Channel<Frame> waiting_;

    mutable std::mutex mutex_;  // guards the members below
    std::condition_variable turned_;
    std::size_t turn_ = 0;  // number of the next frame to be written
    std::exception_ptr error_;
    std::vector<renderer::Image> blanks_;

    std::vector<std::thread> threads_;
};

}  // namespace pushfactor::demos::pictures
