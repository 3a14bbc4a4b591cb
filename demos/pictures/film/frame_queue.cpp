#include "demos/pictures/film/frame_queue.h"

#include <algorithm>
#include <utility>

namespace pushfactor::demos::pictures {

namespace {

constexpr std::size_t waiting = 2;  // frames
constexpr unsigned most_threads = 4;

}  // namespace

FrameQueue::FrameQueue(Work work, StageTimes* times) : work_(std::move(work)), times_(times), waiting_(waiting) {
    const unsigned threads = std::clamp(std::thread::hardware_concurrency(), 1u, most_threads);
    for (unsigned i = 0; i < threads; ++i) threads_.emplace_back([this] { run(); });
}

FrameQueue::~FrameQueue() {
    waiting_.close();
}

renderer::Image FrameQueue::blank() {
    const std::lock_guard lock(mutex_);
    if (blanks_.empty()) return {};
    renderer::Image image = std::move(blanks_.back());
    blanks_.pop_back();
    return image;
}

void FrameQueue::send(const std::string& name, renderer::Image image) {
    if (waiting_.send({sent_++, name, std::move(image)})) return;
    threads_.clear();
    std::rethrow_exception(error_);
}

void FrameQueue::flush() {
    waiting_.close();
    threads_.clear();
    if (error_) std::rethrow_exception(error_);
}

std::size_t FrameQueue::ended() const {
    const std::lock_guard lock(mutex_);
    return turn_;
}

void FrameQueue::run() {
    StageWatch watch(times_);
    try {
        while (auto frame = waiting_.receive()) handle(*frame, watch);
    } catch (...) {
        waiting_.close();
        const std::lock_guard lock(mutex_);
        if (!error_) error_ = std::current_exception();  // later ones are its consequences
        turned_.notify_all();
    }
}

void FrameQueue::handle(Frame& frame, StageWatch& watch) {
    watch.skip();
    const End end = work_(frame.name, frame.image, watch);
    {
        std::unique_lock lock(mutex_);
        turned_.wait(lock, [&] { return turn_ == frame.number || error_; });
        if (error_) return;  // the turn never comes
    }
    watch.skip();
    end(watch);
    const std::lock_guard lock(mutex_);
    ++turn_;
    blanks_.push_back(std::move(frame.image));
    turned_.notify_all();
}

}  // namespace pushfactor::demos::pictures
