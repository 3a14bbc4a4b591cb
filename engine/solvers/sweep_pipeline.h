// Sweeps of one island on several threads, to the same bits as on one: while a sweep goes on, the next one follows
// it as near as it may. A part of the rows may be swept again as soon as the sweep before has passed all rows of
// its bodies; ordered from the bottom up these are few, so that the next sweep is behind by a layer and not by a
// heap.
//
// Not a colouring, which finds rows without common bodies and takes another order: the order decides how far a
// sweep gets, and bottom-up ones get far (row_order.h). An inner matter of the solvers.
#pragma once

#include "engine/solvers/unit_rows.h"
#include "engine/threads.h"

#include <atomic>
#include <cstddef>
#include <functional>
#include <vector>

namespace pushfactor::engine::solvers {

class SweepPipeline {
  public:
    // Below so many rows threads cost more than they bring.
    static constexpr std::size_t least_rows = 2000;

    // Finds out which parts of `rows` have to wait for which. Comes first, and again for other rows.
    void plan(UnitRows<1>& rows);

    // So many sweeps of the rows that were planned. The threads that sweep them call `before` with the rows from
    // one number up to another, before these are swept for the first time, and `after` when they have been for the
    // last time.
    using Part = std::function<void(std::size_t begin, std::size_t end)>;
    void sweep(UnitRows<1>& rows, int sweeps, Threads& threads, const Part& before, const Part& after);

  private:
    static constexpr std::size_t blocks_of_a_part = 32;

    // How far a sweep has got, in a cache line of its own.
    struct alignas(64) Progress {
        std::atomic<std::size_t> parts = 0;
    };

    void work(UnitRows<1>& rows, int sweeps, const Part& before, const Part& after);

    std::vector<std::size_t> last_block_;  // by movable body: the last one that acts on it
    std::vector<std::size_t> needs_;       // by part: parts that the sweep before has to have passed
    std::vector<Progress> progress_;       // by sweep
    std::atomic<int> next_ = 0;            // the first sweep that no thread has taken yet
};

}  // namespace pushfactor::engine::solvers
