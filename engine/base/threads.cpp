#include "engine/base/threads.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <ctime>
#include <exception>
#include <thread>

namespace pushfactor::engine {

namespace {

// Polls before a waiting thread yields its core, some tenths of a millisecond: a thread that yields to another
// program gets the core back only after milliseconds.
constexpr int looks_before_yield = 400'000;

// Share of a keep_at_hand() call in which a thread was kept from running, from which on the threads hinder each
// other: a second program on its core takes half, interrupts up to an eighth of a short call.
constexpr double hindered = 0.25;

// Number of keep_at_hand() calls that run on the caller alone after one in which threads were kept from running:
// doubles each time, halves after each other call.
constexpr int least_alone = 8, most_alone = 256;

// A job stores its number of participants in one byte.
constexpr int most_threads = 255;

// Parts per thread: enough that a slow part does not hold up the other threads for long.
constexpr std::size_t parts_per_thread = 8;

template <typename IsThere>
void wait_until(const IsThere& is_there) {
    for (int looks = 0; !is_there();) {
        if (looks < looks_before_yield) {
            ++looks;
        } else {
            std::this_thread::yield();
        }
    }
}

// s
double seconds_of(clockid_t clock) {
    std::timespec now{};
    clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// Since it was made, on the thread that has made it, which never sleeps meanwhile.
class Presence {
  public:
    // The share of the time in which the system has kept the thread from running.
    double kept_away() const {
        const double all = seconds_of(CLOCK_MONOTONIC) - begun_, own = seconds_of(CLOCK_THREAD_CPUTIME_ID) - ran_;
        return all > 0.0 ? 1.0 - own / all : 0.0;
    }

  private:
    double begun_ = seconds_of(CLOCK_MONOTONIC), ran_ = seconds_of(CLOCK_THREAD_CPUTIME_ID);  // s
};

// On its own cache line, like everything that several threads write, to avoid false sharing.
struct alignas(64) Counter {
    std::atomic<std::size_t> value = 0;
};

}  // namespace

struct Team::Meeting {
    alignas(64) std::atomic<int> arrived = 0;
    alignas(64) std::atomic<unsigned> round = 0;

    void wait_for(int size) {
        const unsigned before = round.load(std::memory_order_relaxed);
        if (arrived.fetch_add(1, std::memory_order_acq_rel) + 1 == size) {
            arrived.store(0, std::memory_order_relaxed);
            round.store(before + 1, std::memory_order_release);
            return;
        }
        wait_until([&] { return round.load(std::memory_order_acquire) != before; });
    }
};

void Team::wait_for_all() {
    if (size_ > 1) meeting_->wait_for(size_);
}

// oneTBB already orders writes before a task with reads inside it, and its results with reads afterwards; `begun`
// and `ended` repeat that for the thread sanitizer, which cannot see into the library.
struct Threads::Arena {
    explicit Arena(int count) : of_tbb(count) {}

    tbb::task_arena of_tbb;
    std::atomic<unsigned> begun = 0, ended = 0;
};

// The threads available during keep_at_hand(). Helpers join when they have woken up, and take part in jobs
// posted after that.
struct Threads::Crew {
    // The last job: its number and, in the lowest byte, the number of participants or `dismissed`.
    static constexpr std::uint64_t size_mask = most_threads, one_job = 0x100;
    static constexpr std::uint64_t dismissed = 0;

    alignas(64) std::atomic<std::uint64_t> posted = 1;
    alignas(64) std::atomic<int> helpers = 0;
    alignas(64) std::atomic<bool> kept_away = false;   // some thread, for long
    const std::function<void(Team&)>* work = nullptr;  // read by participants only
    Team::Meeting meeting;

    void take_part(int member, int size) noexcept {
        Team team;
        team.member_ = member;
        team.size_ = size;
        team.meeting_ = &meeting;
        (*work)(team);
        if (size > 1) meeting.wait_for(size);
    }

    void note(const Presence& of_thread) {
        if (of_thread.kept_away() > hindered) kept_away.store(true, std::memory_order_relaxed);
    }

    void help() {
        const Presence own;
        std::uint64_t seen = posted.load(std::memory_order_acquire);
        const int member = 1 + helpers.fetch_add(1, std::memory_order_acq_rel);
        while ((seen & size_mask) != dismissed) {
            wait_until([&] { return posted.load(std::memory_order_acquire) != seen; });
            seen = posted.load(std::memory_order_acquire);
            const int size = static_cast<int>(seen & size_mask);
            if (member < size) take_part(member, size);
        }
        note(own);
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

// Each member starts with its own range of parts, then helps with the ranges of the others.
void Threads::share(std::size_t count, std::size_t grain, const Part& work) {
    if (!crew_ || count <= grain) {
        if (count > 0) work(0, count, 0);
        return;
    }
    const std::size_t least = std::max(grain, count / (parts_per_thread * static_cast<std::size_t>(count_)));
    const std::size_t parts = (count + least - 1) / least;
    std::vector<Counter> taken(static_cast<std::size_t>(count_));  // per range
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

// Returns whether threads were kept from running.
bool Threads::work_in_crew(const std::function<void()>& work) {
    Crew crew;
    const auto leader = std::this_thread::get_id();
    bool led = false;
    std::exception_ptr failure;
    const auto lead = [&] {
        const Presence own;
        led = true;
        try {
            crew_ = &crew;
            work();
        } catch (...) {
            failure = std::current_exception();
        }
        crew_ = nullptr;
        crew.note(own);
        crew.dismiss();
    };
    const auto come = [&](int) {
        arena_->begun.load(std::memory_order_acquire);
        if (std::this_thread::get_id() != leader || led) {
            crew.help();
        } else {
            lead();
        }
        arena_->ended.fetch_add(1, std::memory_order_release);
    };
    arena_->begun.fetch_add(1, std::memory_order_release);
    arena_->of_tbb.execute([&] { tbb::parallel_for(0, count_, come, tbb::simple_partitioner()); });
    arena_->ended.load(std::memory_order_acquire);
    if (failure) std::rethrow_exception(failure);
    return crew.kept_away.load(std::memory_order_relaxed);
}

}  // namespace pushfactor::engine
