#include "tests/fuzz/campaign.h"

#include "demos/base/text/numbers.h"
#include "tests/fuzz/random_scene.h"
#include "tests/fuzz/shrink.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>
#include <thread>

namespace pushfactor::tests {

namespace {

// Hands out seeds until none is left or it is stopped. Shared by threads.
class Worklist {
  public:
    Worklist(std::uint64_t first, long count) : first_(first), count_(count) {}

    void work() {
        for (long i = next_++; i < count_ && !stopped_; i = next_++) {
            const std::uint64_t seed = first_ + static_cast<std::uint64_t>(i);
            const demos::SceneDescription scene = random_scene(seed);
            const Verdict verdict = judge(scene);
            if (verdict.kind != Verdict::Kind::holds) note(seed, scene, verdict);
            ++judged_;
        }
    }

    void stop() { stopped_ = true; }
    long judged() const { return judged_; }
    bool is_done() const { return judged_ >= count_; }

    Campaign result() {
        std::sort(campaign_.failures.begin(), campaign_.failures.end(),
                  [](const Failure& a, const Failure& b) { return a.seed < b.seed; });
        campaign_.judged = judged_;
        return std::move(campaign_);
    }

  private:
    void note(std::uint64_t seed, const demos::SceneDescription& scene, const Verdict& verdict) {
        const bool fails = verdict.kind == Verdict::Kind::fails;
        std::optional<Failure> failure;
        if (fails) failure = shrunk(seed, scene, verdict);
        const std::lock_guard lock(mutex_);
        if (failure) campaign_.failures.push_back(std::move(*failure));
        if (!fails) ++campaign_.non_finite;
    }

    std::uint64_t first_;
    long count_;
    std::atomic<long> next_ = 0, judged_ = 0;
    std::atomic<bool> stopped_ = false;
    std::mutex mutex_;
    Campaign campaign_;
};

}  // namespace

Failure shrunk(std::uint64_t seed, const demos::SceneDescription& scene, const Verdict& verdict) {
    demos::SceneDescription smaller = scene;
    if (verdict.step > 0) {
        const double dt = settings_of(scene).dt.value();
        smaller.options["seconds"] = demos::to_text(static_cast<double>(verdict.step) * dt);
    }
    smaller = shrink(smaller, [&](const demos::SceneDescription& candidate) {
        const Verdict found = judge(candidate);
        return found.kind == verdict.kind && found.claim == verdict.claim;
    });
    return {.seed = seed, .verdict = judge(smaller), .scene = smaller};
}

Campaign judge_scenes(std::uint64_t first, long count, const std::function<bool(long)>& go_on) {
    Worklist list(first, count);
    std::vector<std::jthread> workers;
    for (unsigned i = 0; i < std::max(1u, std::thread::hardware_concurrency()); ++i) {
        workers.emplace_back([&list] { list.work(); });
    }
    while (!list.is_done() && go_on(list.judged())) std::this_thread::sleep_for(std::chrono::milliseconds(20));
    list.stop();
    workers.clear();
    return list.result();
}

}  // namespace pushfactor::tests
