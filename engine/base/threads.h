// Threads that share the work of a step. Every result has its own place and every sum a fixed order, so results
// are bit-identical for any number of threads. Where functions take `Threads*` these share their work; null is one
// thread. The only file in the engine that uses oneTBB, and a clock, on which only the number of threads depends.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace pushfactor::engine {

// One of several threads that run the same function concurrently; by default the only one.
class Team {
  public:
    int member() const { return member_; }  // 0 .. size() - 1
    int size() const { return size_; }

    // Barrier. Writes of the other members before it are visible afterwards.
    void wait_for_all();

    // Whether this member takes part `part` of `count`. Neighbouring parts go to the same member, every time,
    // so that their data stays in the caches of one core.
    bool owns(std::size_t part, std::size_t count) const {
        return static_cast<int>(part * static_cast<std::size_t>(size_) / count) == member_;
    }

  private:
    friend class Threads;
    struct Meeting;

    int member_ = 0;
    int size_ = 1;
    Meeting* meeting_ = nullptr;  // null: alone
};

class Threads {
  public:
    // `count` threads including the caller, clamped to 1 .. min(all(), 255).
    explicit Threads(int count);
    ~Threads();

    // Number of threads that this machine runs concurrently.
    static int all();

    int count() const { return count_; }

    // Calls `work(begin, end, slot)` for ranges that together cover 0 .. count - 1, of at least `grain`
    // elements where there are that many; a single call outside of keep_at_hand(). Each slot, 0 .. count() - 1,
    // is in use by at most one call at a time.
    using Part = std::function<void(std::size_t begin, std::size_t end, int slot)>;
    void share(std::size_t count, std::size_t grain, const Part& work);

    // Calls `work(team)` concurrently, once on each available thread: the caller and, during keep_at_hand(),
    // others. `work` must not throw.
    void as_team(const std::function<void(Team& team)>& work);

    // Calls `work()`, which calls the functions above many times. Meanwhile the other threads do not sleep
    // between these calls: waking one takes some ten microseconds per call.
    //
    // Threads that synchronise often have to run at the same time. Where other programs take their cores they
    // wait for each other for milliseconds; after a call in which the system has kept one of them from running for
    // a quarter of the time the caller works alone for a number of calls.
    void keep_at_hand(const std::function<void()>& work);

  private:
    struct Arena;
    struct Crew;

    bool work_in_crew(const std::function<void()>& work);

    int count_;
    std::unique_ptr<Arena> arena_;
    Crew* crew_ = nullptr;    // during keep_at_hand()
    int alone_for_ = 0;       // remaining calls of keep_at_hand() that run on the caller alone
    int after_next_one_ = 0;  // value of alone_for_ after the next such call
};

// Grain of passes over bodies or their colliders.
inline constexpr std::size_t bodies_of_a_part = 250;

// Calls `work(begin, end)` for ranges that cover 0 .. count - 1; a single call without threads.
template <typename Work>
void share(Threads* threads, std::size_t count, std::size_t grain, const Work& work) {
    if (threads && count > grain) {
        threads->share(count, grain, [&work](std::size_t begin, std::size_t end, int) { work(begin, end); });
    } else if (count > 0) {
        work(std::size_t{0}, count);
    }
}

// Calls `visit` for each element of `all`.
template <typename T, typename Visit>
void share_each(Threads* threads, std::span<T> all, std::size_t grain, const Visit& visit) {
    share(threads, all.size(), grain, [&](std::size_t begin, std::size_t end) {
        for (T& one : all.subspan(begin, end - begin)) visit(one);
    });
}

// The number of ranges that share_parts() would make.
inline std::size_t parts_of(const Threads* threads, std::size_t count, std::size_t size) {
    return !threads || count <= size ? 1 : (count + size - 1) / size;
}

// Calls `work(part, begin, end)` for ranges of `size` elements that cover 0 .. count - 1; the last one may be
// shorter. Returns their number. Without threads there is one range.
template <typename Work>
std::size_t share_parts(Threads* threads, std::size_t count, std::size_t size, const Work& work) {
    const std::size_t parts = parts_of(threads, count, size);
    if (parts == 1) {
        work(std::size_t{0}, std::size_t{0}, count);
        return parts;
    }
    threads->share(parts, 1, [&](std::size_t begin, std::size_t end, int) {
        for (std::size_t part = begin; part < end; ++part) {
            work(part, part * size, std::min(count, (part + 1) * size));
        }
    });
    return parts;
}

// Parallel search whose results are in the order of the searched range, for any number of threads.
template <typename T>
class Search {
  public:
    // Appends to `all` what `find(begin, end, found)` appends to `found`, for ranges that cover 0 .. count - 1.
    template <typename Find>
    void append_to(std::vector<T>& all, Threads* threads, std::size_t count, std::size_t size, const Find& find) {
        if (parts_of(threads, count, size) == 1) {
            find(std::size_t{0}, count, all);
            return;
        }
        found_.resize(std::max(found_.size(), parts_of(threads, count, size)));
        const std::size_t parts =
            share_parts(threads, count, size, [&](std::size_t part, std::size_t begin, std::size_t end) {
                found_[part].clear();
                find(begin, end, found_[part]);
            });
        for (std::size_t k = 0; k < parts; ++k) all.insert(all.end(), found_[k].begin(), found_[k].end());
    }

  private:
    std::vector<std::vector<T>> found_;  // by part
};

}  // namespace pushfactor::engine
