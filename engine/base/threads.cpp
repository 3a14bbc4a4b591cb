#include "engine/base/threads.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <exception>
#include <thread>

namespace pushfactor::engine {

namespace {

// How often a thread looks whether another one is there before it hands its core over, some tenths of a
// millisecond: whoever yields to another program gets the core back after milliseconds only.
constexpr int looks_before_yield = 400'000;
// And how often before that means that the other one is not running: not at all where a team meets after equal
// parts, and about a millisecond where the last part of shared work may take long.
constexpr int looks_of_a_team = looks_before_yield, looks_at_the_end = 2'000'000;

// Calls of keep_at_hand() that the caller does alone after one in which the threads have waited for each other:
// twice as many each time, half as many after each one in which they have not.
constexpr int least_alone = 8, most_alone = 256;

// A job says in one byte how many take part.
constexpr int most_threads = 255;

// Parts per thread: enough that one which takes longer does not hold up the others for long.
constexpr std::size_t parts_per_thread = 8;

// Returns how often it had to look.
template <typename IsThere>
int wait_until(const IsThere& is_there) {
    int looks = 0;
    while (!is_there()) {
        if (looks < looks_at_the_end) ++looks;
        if (looks > looks_before_yield) std::this_thread::yield();
    }
    return looks;
}

// In cache lines of their own, as is everything that several threads write.
struct alignas(64) Counter {
    std::atomic<std::size_t> value = 0;
};

}  // namespace

struct Team::Meeting {
    alignas(64) std::atomic<int> arrived = 0;
    alignas(64) std::atomic<unsigned> round = 0;
    alignas(64) std::atomic<bool> stalled = false;  // whether somebody has waited for long

    void wait_for(int size, int patience) {
        const unsigned before = round.load(std::memory_order_relaxed);
        if (arrived.fetch_add(1, std::memory_order_acq_rel) + 1 == size) {
            arrived.store(0, std::memory_order_relaxed);
            round.store(before + 1, std::memory_order_release);
            return;
        }
        const int looks = wait_until([&] { return round.load(std::memory_order_acquire) != before; });
        if (looks >= patience) stalled.store(true, std::memory_order_relaxed);
    }
};

void Team::wait_for_all() {
    if (size_ > 1) meeting_->wait_for(size_, looks_of_a_team);
}

// What is written before a task begins is read in it, and what it has written after it has ended. The library sees
// to that, but the thread sanitizer does not see into the library, so it is said once more.
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

// The threads at hand during keep_at_hand(). Helpers come when they are awake, and take part in what is posted from
// then on.
struct Threads::Crew {
    // The last job: its number, and in the lowest byte how many take part, or `dismissed`.
    static constexpr std::uint64_t size_mask = most_threads, one_job = 0x100;
    static constexpr std::uint64_t dismissed = 0;

    alignas(64) std::atomic<std::uint64_t> posted = 1;
    alignas(64) std::atomic<int> helpers = 0;
    const std::function<void(Team&)>* work = nullptr;  // read by those only who take part
    Team::Meeting meeting;

    void take_part(int member, int size) noexcept {
        Team team;
        team.member_ = member;
        team.size_ = size;
        team.meeting_ = &meeting;
        (*work)(team);
        if (size > 1) meeting.wait_for(size, looks_at_the_end);
    }

    void help() {
        std::uint64_t seen = posted.load(std::memory_order_acquire);
        const int member = 1 + helpers.fetch_add(1, std::memory_order_acq_rel);
        while ((seen & size_mask) != dismissed) {
            wait_until([&] { return posted.load(std::memory_order_acquire) != seen; });
            seen = posted.load(std::memory_order_acquire);
            const int size = static_cast<int>(seen & size_mask);
            if (member < size) take_part(member, size);
        }
    }

    void post(const std::function<void(Team&)>& job) {
        const int size = 1 + helpers.load(std::memory_order_acquire);
        work = &job;
        posted.store(next_number() + static_cast<std::uint64_t>(size), std::memory_order_release);
        take_part(0, size);
    }

    void dismiss() { posted.store(next_number() + dismissed, std::memory_order_release); }

    std::uint64_t next_number() const { return (posted.load(std::memory_order_relaxed) / one_job + 1) * one_job; }
};

Threads::Threads(int count)
    : count_(std::clamp(count, 1, std::min(all(), most_threads))),
      arena_(std::make_unique<Arena>(count_)),
      after_next_one_(least_alone) {}

Threads::~Threads() = default;

int Threads::all() {
    return tbb::this_task_arena::max_concurrency();
}

// Each member begins with a stretch of its own, and helps with the others when that is done.
void Threads::share(std::size_t count, std::size_t grain, const Part& work) {
    if (!crew_ || count <= grain) {
        if (count > 0) work(0, count, 0);
        return;
    }
    const std::size_t least = std::max(grain, count / (parts_per_thread * static_cast<std::size_t>(count_)));
    const std::size_t parts = (count + least - 1) / least;
    std::vector<Counter> taken(static_cast<std::size_t>(count_));  // of each stretch
    std::atomic<bool> failed = false;
    std::exception_ptr failure;
    const auto job = [&](Team& team) {
        const auto size = static_cast<std::size_t>(team.size());
        for (std::size_t k = 0; k < size; ++k) {
            const std::size_t stretch = (static_cast<std::size_t>(team.member()) + k) % size;
            const std::size_t first = stretch * parts / size, end = (stretch + 1) * parts / size;
            for (;;) {
                const std::size_t part = first + taken[stretch].value.fetch_add(1, std::memory_order_relaxed);
                if (part >= end) break;
                try {
                    work(part * least, std::min(count, (part + 1) * least), team.member());
                } catch (...) {
                    if (!failed.exchange(true)) failure = std::current_exception();
                }
            }
        }
    };
    crew_->post(job);
    if (failure) std::rethrow_exception(failure);
}

void Threads::as_team(const std::function<void(Team& team)>& work) {
    if (crew_) {
        crew_->post(work);
    } else {
        Team alone;
        work(alone);
    }
}

void Threads::keep_at_hand(const std::function<void()>& work) {
    if (count_ == 1 || crew_ || alone_for_ > 0) {
        if (!crew_ && alone_for_ > 0) --alone_for_;
        work();
        return;
    }
    if (work_in_crew(work)) {
        alone_for_ = after_next_one_;
        after_next_one_ = std::min(2 * after_next_one_, most_alone);
    } else {
        after_next_one_ = std::max(after_next_one_ / 2, least_alone);
    }
}

// Returns whether the threads have waited for each other.
bool Threads::work_in_crew(const std::function<void()>& work) {
    Crew crew;
    const auto leader = std::this_thread::get_id();
    bool led = false;
    std::exception_ptr failure;
    const auto come = [&](int) {
        arena_->as_task([&] {
            if (std::this_thread::get_id() != leader || led) {
                crew.help();
                return;
            }
            led = true;
            try {
                crew_ = &crew;
                work();
            } catch (...) {
                failure = std::current_exception();
            }
            crew_ = nullptr;
            crew.dismiss();
        });
    };
    arena_->execute([&] { tbb::parallel_for(0, count_, come, tbb::simple_partitioner()); });
    if (failure) std::rethrow_exception(failure);
    return crew.meeting.stalled.load(std::memory_order_relaxed);
}

}  // namespace pushfactor::engine
