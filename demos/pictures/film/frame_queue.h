// Work on frames by background threads, in the order of the frames where it matters.
#pragma once

#include "demos/base/platform/channel.h"
#include "demos/pictures/film/stage_times.h"
#include "renderer/images/image.h"

#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace pushfactor::demos::pictures {

// The queue is short and the memory of images is reused, so that memory does not grow with the number of frames. An
// error of the work is thrown by the next call.
class FrameQueue {
  public:
    // What is left to do with a frame: called in the order of the frames, one at a time.
    using End = std::function<void(StageWatch& watch)>;
    // Called for several frames at once. The image is valid until the end of the frame.
    using Work = std::function<End(const std::string& name, const renderer::Image& image, StageWatch& watch)>;

    // `times` may be null.
    explicit FrameQueue(Work work, StageTimes* times = nullptr);
    // Completes the queued frames; errors are ignored.
    ~FrameQueue();
    FrameQueue(const FrameQueue&) = delete;
    FrameQueue& operator=(const FrameQueue&) = delete;

    // A recycled image for the next frame, of unspecified content and size.
    renderer::Image blank();

    // Queues a frame. Blocks while the queue is full.
    void send(const std::string& name, renderer::Image image);

    // Waits until all frames have ended; no more can follow.
    void flush();

    // Number of frames that have ended.
    std::size_t ended() const;

  private:
    struct Frame {
        std::size_t number;
        std::string name;
        renderer::Image image;
    };

    void run();
    void handle(Frame& frame, StageWatch& watch);

    Work work_;
    StageTimes* times_;
    std::size_t sent_ = 0;
    Channel<Frame> waiting_;

    mutable std::mutex mutex_;  // guards the members below
    std::condition_variable turned_;
    std::size_t turn_ = 0;  // number of the next frame to end
    std::exception_ptr error_;
    std::vector<renderer::Image> blanks_;

    std::vector<std::jthread> threads_;  // the last member: they end before the others do
};

}  // namespace pushfactor::demos::pictures
