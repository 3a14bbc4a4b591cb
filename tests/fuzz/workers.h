// Shares numbered work among all cores.
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>
#include <optional>
#include <thread>
#include <vector>

namespace pushfactor::tests {

// Asked now and then in the calling thread, with the number of results so far; when it returns false, those that
// run are finished and no more are begun.
using GoOn = std::function<bool(long)>;

// work(0) .. work(count - 1), which must not throw, in this order; less if `go_on` says so.
template <typename Result, typename Work>
std::vector<Result> results_of(long count, const Work& work, const GoOn& go_on) {
    std::vector<std::optional<Result>> found(static_cast<std::size_t>(count));
    std::atomic<long> next = 0, done = 0;
    std::atomic<bool> stopped = false;
    {
        std::vector<std::jthread> workers;
        for (unsigned k = 0; k < std::max(1u, std::thread::hardware_concurrency()); ++k) {
            workers.emplace_back([&] {
                for (long i = next++; i < count && !stopped; i = next++) {
                    found[static_cast<std::size_t>(i)] = work(i);
                    ++done;
                }
            });
        }
        while (done < count && go_on(done)) std::this_thread::sleep_for(std::chrono::milliseconds(20));
        stopped = true;
    }
    std::vector<Result> all;
    for (std::optional<Result>& result : found) {
        if (result) all.push_back(std::move(*result));
    }
    return all;
}

}  // namespace pushfactor::tests
