// Threads that share the work of a step. Who uses them writes each result to a place of its own, so that the bits
// do not depend on their number. The one place in the engine that knows oneTBB.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>

namespace pushfactor::engine {

class Threads {
  public:
    // So many, the caller included; at least one, and no more than the machine runs at once.
    explicit Threads(int count);
    ~Threads();

    // As many as this machine runs at once.
    static int all();

    int count() const { return count_; }

    // For who waits for another thread, and may have taken its core.
    static void let_others_run();

    // Calls `work(begin, end, slot)` for parts of 0 .. count - 1, which together are all of it, of at least
    // `grain` numbers where there are so many. Of the slots, 0 .. count() - 1, each is in one call at a time.
    using Part = std::function<void(std::size_t begin, std::size_t end, int slot)>;
    void share(std::size_t count, std::size_t grain, const Part& work);

    // Calls `work()` at least once, on as many threads at the same time as can be had.
    void together(const std::function<void()>& work);

  private:
    struct Arena;

    int count_;
    std::unique_ptr<Arena> arena_;
};

}  // namespace pushfactor::engine
