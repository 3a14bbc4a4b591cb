// Threads that share the work of a step. Each result is written to its own place and each sum has a fixed order, so
// the bits do not depend on the number of threads. The only file in the engine that knows oneTBB.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace pushfactor::engine {

// One of several threads that go through the same work at the same time; by default it is alone.
class Team {
  public:
    int member() const { return member_; }  // 0 .. size() - 1
    int size() const { return size_; }

    // Returns once every member has called it equally often. What the others wrote before is visible then.
    void wait_for_all();

    // Whether this member takes part `part` of `count`. Parts next to each other go to the same one, and each time
    // to the same one, so that their data stays in the caches of one core.
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
    // This many, the caller included; at least one, and no more than the machine runs at once.
    explicit Threads(int count);
    ~Threads();

    // As many as this machine runs at once.
    static int all();

    int count() const { return count_; }

    // Calls `work(begin, end, slot)` for parts of 0 .. count - 1, which together are all of it, of at least
    // `grain` numbers where there are that many; all at once outside of keep_at_hand(). Each of the slots,
    // 0 .. count() - 1, is in one call at a time.
    using Part = std::function<void(std::size_t begin, std::size_t end, int slot)>;
    void share(std::size_t count, std::size_t grain, const Part& work);

    // Calls `work(team)` at the same time on all threads that are at hand, once on each: the caller, and during
    // keep_at_hand() others. It must not throw.
    void as_team(const std::function<void(Team& team)>& work);

    // Calls `work()`, which is rich in calls of the above. Meanwhile the other threads do not go to sleep between
    // these: to wake one takes some ten microseconds, and that for each call.
    //
    // Threads that meet often have to run at the same time. Where other programs take their cores they wait for
    // each other for milliseconds, so after a call in which they did, the caller works alone for some calls.
    void keep_at_hand(const std::function<void()>& work);

  private:
    struct Arena;
    struct Crew;

    bool work_in_crew(const std::function<void()>& work);

    int count_;
    std::unique_ptr<Arena> arena_;
    Crew* crew_ = nullptr;    // during keep_at_hand()
    int alone_for_ = 0;       // calls of keep_at_hand() from now on
    int after_next_one_ = 0;  // the same after the next one in which the threads wait for each other
};

// Calls `work(begin, end)` for parts of 0 .. count - 1; all at once without threads.
template <typename Work>
void share(Threads* threads, std::size_t count, std::size_t grain, const Work& work) {
    if (threads && count > grain) {
        threads->share(count, grain, [&work](std::size_t begin, std::size_t end, int) { work(begin, end); });
    } else if (count > 0) {
        work(std::size_t{0}, count);
    }
}

// Calls `work(part, begin, end)` for parts of 0 .. count - 1 of `size` numbers each, the last one of what is left.
// Returns how many there are. Without threads all is one part.
template <typename Work>
std::size_t share_parts(Threads* threads, std::size_t count, std::size_t size, const Work& work) {
    if (!threads || count <= size) {
        work(std::size_t{0}, std::size_t{0}, count);
        return 1;
    }
    const std::size_t parts = (count + size - 1) / size;
    threads->share(parts, 1, [&](std::size_t begin, std::size_t end, int) {
        for (std::size_t part = begin; part < end; ++part) {
            work(part, part * size, std::min(count, (part + 1) * size));
        }
    });
    return parts;
}

// As many as share_parts() would make.
inline std::size_t parts_of(const Threads* threads, std::size_t count, std::size_t size) {
    return !threads || count <= size ? 1 : (count + size - 1) / size;
}

// A search whose findings come in the order of what is searched, however many threads search it.
template <typename T>
class Search {
  public:
    // Appends to `all` what `find(begin, end, found)` appends to `found`, for parts of 0 .. count - 1.
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

// As std::sort, of numbers of which no two are equal.
template <typename T, typename Before>
void sort_distinct(Threads* threads, std::span<T> all, const Before& before) {
    constexpr std::size_t worth_it = 2000;
    const auto part = [&all](std::size_t k, std::size_t parts) {
        return all.begin() + static_cast<std::ptrdiff_t>(k * all.size() / parts);
    };
    if (!threads || threads->count() == 1 || all.size() < worth_it) {
        std::sort(all.begin(), all.end(), before);
        return;
    }
    std::size_t parts = 1;
    while (parts < static_cast<std::size_t>(threads->count())) parts *= 2;
    share(threads, parts, 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) std::sort(part(k, parts), part(k + 1, parts), before);
    });
    for (std::size_t width = 1; width < parts; width *= 2) {
        share(threads, parts / (2 * width), 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t k = begin; k < end; ++k) {
                const std::size_t first = 2 * width * k;
                std::inplace_merge(part(first, parts), part(first + width, parts), part(first + 2 * width, parts),
                                   before);
            }
        });
    }
}

}  // namespace pushfactor::engine
