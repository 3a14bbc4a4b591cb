#include "engine/threads.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <thread>

namespace pushfactor::engine {

// What is written before a task begins is read in it, and what it has written after it has ended. The library sees
// to that, but the thread sanitizer does not see into the library: so it is said once more.
struct Threads::Arena {
    explicit Arena(int count) : of_tbb(count) {}

    template <typename Work>
    void execute(const Work& work) {
        begun.fetch_add(1, std::memory_order_release);
        of_tbb.execute(work);
        ended.load(std::memory_order_acquire);
    }
    template <typename Work>
    void as_task(const Work& work) {
        begun.load(std::memory_order_acquire);
        work();
        ended.fetch_add(1, std::memory_order_release);
    }

    tbb::task_arena of_tbb;
    std::atomic<unsigned> begun = 0, ended = 0;
};

Threads::Threads(int count) : count_(std::clamp(count, 1, all())), arena_(std::make_unique<Arena>(count_)) {}

Threads::~Threads() = default;

int Threads::all() {
    return tbb::this_task_arena::max_concurrency();
}

void Threads::let_others_run() {
    std::this_thread::yield();
}

void Threads::share(std::size_t count, std::size_t grain, const Part& work) {
    if (count_ == 1 || count <= grain) {
        if (count > 0) work(0, count, 0);
        return;
    }
    const auto part = [&](const tbb::blocked_range<std::size_t>& range) {
        arena_->as_task([&] { work(range.begin(), range.end(), tbb::this_task_arena::current_thread_index()); });
    };
    arena_->execute([&] {
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, grain), part, tbb::simple_partitioner());
    });
}

void Threads::together(const std::function<void()>& work) {
    if (count_ == 1) {
        work();
        return;
    }
    arena_->execute([&] {
        tbb::parallel_for(
            0, count_, [&](int) { arena_->as_task(work); }, tbb::simple_partitioner());
    });
}

}  // namespace pushfactor::engine
