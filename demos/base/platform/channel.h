// A bounded queue between threads, and a thread that fills one.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <future>
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

// Produces items on a background thread, at most `ahead` more than have been taken.
template <typename T>
class Producer {
  public:
    // `make` sends items into the channel until it is done or the channel is closed. It starts at once; what it
    // uses must outlive this object.
    Producer(std::size_t ahead, std::function<void(Channel<T>&)> make) : channel_(ahead) {
        made_ = std::async(std::launch::async, [this, make = std::move(make)] {
            try {
                make(channel_);
            } catch (...) {
                channel_.close();
                throw;
            }
            channel_.close();
        });
    }

    ~Producer() { channel_.close(); }
    Producer(const Producer&) = delete;
    Producer& operator=(const Producer&) = delete;

    // The next item. After the last one throws what `make` threw, or returns none.
    std::optional<T> next() {
        std::optional<T> thing = channel_.receive();
        if (thing) return thing;
        if (made_.valid()) made_.get();
        return std::nullopt;
    }

  private:
    Channel<T> channel_;
    std::future<void> made_;  // its destructor waits for the thread
};

}  // namespace pushfactor::demos
