#include "demos/reports/pieces/make_pieces.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <stop_token>
#include <thread>
#include <utility>
#include <vector>

namespace pushfactor::demos::reports {

namespace {

// Ends a piece in progress.
struct Dropped {};

class WorkerPool {
  public:
    using Keep = std::function<void(const Piece&, const Json&)>;

    WorkerPool(std::span<const Piece* const> pieces, int jobs, const Keep& keep) : pieces_(pieces), keep_(keep) {
        const auto most = static_cast<std::size_t>(std::max(1, jobs));
        for (std::size_t i = 0; i < std::min(most, pieces.size()); ++i) {
            workers_.emplace_back([this](const std::stop_token& stop) { work(stop); });
        }
    }

    // Requests all stops before the first join.
    ~WorkerPool() {
        for (std::jthread& worker : workers_) worker.request_stop();
    }

    WorkerPool(const WorkerPool&) = delete;
    WorkerPool& operator=(const WorkerPool&) = delete;

    // Number of pieces made since the last call; waits briefly if there are none. Throws what a piece threw.
    std::size_t fetch() {
        std::unique_lock lock(mutex_);
        news_.wait_for(lock, std::chrono::milliseconds(100), [this] { return made_ > 0 || error_; });
        if (error_) std::rethrow_exception(error_);
        return std::exchange(made_, 0);
    }

  private:
    void work(const std::stop_token& stop) {
        const auto check = [&stop] {
            if (stop.stop_requested()) throw Dropped{};
        };
        try {
            for (std::size_t i = next_++; i < pieces_.size(); i = next_++) {
                check();
                keep_(*pieces_[i], pieces_[i]->make(check));
                const std::lock_guard lock(mutex_);
                ++made_;
                news_.notify_one();
            }
        } catch (const Dropped&) {
        } catch (...) {
            const std::lock_guard lock(mutex_);
            if (!error_) error_ = std::current_exception();
            news_.notify_one();
        }
    }

    std::span<const Piece* const> pieces_;
    const Keep& keep_;
    std::atomic<std::size_t> next_ = 0;
    std::mutex mutex_;  // guards the two below
    std::size_t made_ = 0;
    std::exception_ptr error_;
    std::condition_variable news_;
    std::vector<std::jthread> workers_;  // last, so that they are joined first
};

}  // namespace

void make_pieces(std::span<const Piece* const> pieces, int jobs,
                 const std::function<void(const Piece&, const Json& result)>& keep,
                 const std::function<void()>& made, const std::function<void()>& check) {
    WorkerPool workers(pieces, jobs, keep);
    for (std::size_t done = 0; done < pieces.size();) {
        check();
        for (std::size_t news = workers.fetch(); news > 0; --news, ++done) made();
    }
}

}  // namespace pushfactor::demos::reports
