// Somebody who works ahead.
#pragma once

#include "demos/platform/channel.h"

#include <exception>
#include <functional>
#include <thread>

namespace pushfactor::demos {

// Makes things on a thread of its own, at most a few more than have been taken.
template <typename T>
class Producer {
  public:
    using Channel = demos::Channel<T>;

    // `make` sends things into the channel until it has made all of them, or until the channel is closed because
    // nobody wants more. It runs at once; what it uses must outlive this object.
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

    // The next thing. After the last one the thread has ended: throws what `make` threw, or gives none.
    std::optional<T> next() {
        std::optional<T> thing = channel_.receive();
        if (thing) return thing;
        if (thread_.joinable()) thread_.join();
        if (error_) std::rethrow_exception(error_);
        return std::nullopt;
    }

  private:
    Channel channel_;
    std::exception_ptr error_;  // of the thread; read after it has ended
    std::thread thread_;
};

}  // namespace pushfactor::demos
