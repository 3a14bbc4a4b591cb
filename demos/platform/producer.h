// Background producer thread.
#pragma once

#include "demos/platform/channel.h"

#include <exception>
#include <functional>
#include <thread>

namespace pushfactor::demos {

// Produces items on a background thread, at most `ahead` more than have been taken.
template <typename T>
class Producer {
  public:
    using Channel = demos::Channel<T>;

    // `make` sends items into the channel until it is done or the channel is closed. It starts at once; what it
    // uses must outlive this object.
    Producer(std::size_t ahead, std::function<void(Channel&)> make) : channel_(ahead) {
        thread_ = std::thread([this, make = std::move(make)] {
            try {
                make(channel_);
            } catch (...) {
                error_ = std::current_exception();
            }
            channel_.close();
        });
    }

    ~Producer() {
        channel_.close();
        if (thread_.joinable()) thread_.join();
    }
    Producer(const Producer&) = delete;
    Producer& operator=(const Producer&) = delete;

    // The next item. After the last one throws what `make` threw, or returns none.
    std::optional<T> next() {
        std::optional<T> thing = channel_.receive();
        if (thing) return thing;
        if (thread_.joinable()) thread_.join();
        if (error_) std::rethrow_exception(error_);
        return std::nullopt;
    }

  private:
    Channel channel_;
    std::exception_ptr error_;  // of the thread; read after joining
    std::thread thread_;
};

}  // namespace pushfactor::demos
