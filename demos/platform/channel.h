// A bounded queue between threads.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <mutex>
#include <optional>

namespace pushfactor::demos {

// First in, first out. Any number of threads may use both ends.
template <typename T>
class Channel {
  public:
    // Holds at most `capacity` items; `capacity` is at least 1.
    explicit Channel(std::size_t capacity) : capacity_(capacity) {}

    // Blocks while the channel is full. Returns false and drops the item if it is closed.
    bool send(T thing) {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [this] { return closed_ || things_.size() < capacity_; });
        if (closed_) return false;
        things_.push_back(std::move(thing));
        changed_.notify_all();
        return true;
    }

    // Blocks until the next item. None when the channel is closed and empty.
    std::optional<T> receive() {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [this] { return closed_ || !things_.empty(); });
        if (things_.empty()) return std::nullopt;
        std::optional<T> thing(std::move(things_.front()));
        things_.pop_front();
        changed_.notify_all();
        return thing;
    }

    // Nothing more can be sent; what is in the channel can still be received.
    void close() {
        const std::lock_guard lock(mutex_);
        closed_ = true;
        changed_.notify_all();
    }

    bool is_closed() const {
        const std::lock_guard lock(mutex_);
        return closed_;
    }

  private:
    std::size_t capacity_;
    mutable std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<T> things_;
    bool closed_ = false;
};

}  // namespace pushfactor::demos
