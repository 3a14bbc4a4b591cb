// Symbolic factorisation: elimination order of the bodies' blocks, and fill-in. Internal to the solvers.
#pragma once

#include "engine/base/math.h"

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace pushfactor::engine::solvers {

class Elimination {
  public:
    struct Update {
        int target, left, right;  // block indices: target -= left times right
    };
    struct Node {
        int body = 0;
        std::vector<int> below;   // connected nodes later in the order, ascending
        std::vector<int> blocks;  // their blocks, in that order
        std::vector<Update> updates;
    };

    // For `bodies` bodies with a block each, connected by `pairs`: body numbers below `bodies`, in any order,
    // repetitions allowed. Minimum degree order for little fill-in. Gives up if a factorisation would take more
    // than `most_work` multiply-adds: a heap of thousands would fill gigabytes before it shows that it does not pay
    // off.
    void find(int bodies, std::span<const std::pair<int, int>> pairs, double most_work = infinity);

    const std::vector<Node>& nodes() const { return nodes_; }
    // Number of blocks on and below the diagonal; the diagonal ones come first, in elimination order.
    std::size_t block_count() const { return block_count_; }

    // Position of `body` in the order; -1 for a body without a block.
    int node_of(int body) const {
        return static_cast<std::size_t>(body) < node_of_.size() ? node_of_[static_cast<std::size_t>(body)] : -1;
    }
    // Block of two connected nodes, the earlier one first.
    int block_between(int earlier, int later) const;

    // Multiply-adds of a factorisation, symmetric or general; infinite if find() gave up.
    double symmetric_work() const { return symmetric_work_; }
    double general_work() const { return general_work_; }
    // Multiply-adds of a solve with the factors.
    double solve_work() const { return 72.0 * static_cast<double>(block_count_); }

  private:
    bool order(std::vector<std::vector<int>> neighbours, double most_work);
    void number_blocks();

    std::vector<int> node_of_;
    std::vector<Node> nodes_;
    std::size_t block_count_ = 0;
    double symmetric_work_ = 0.0, general_work_ = 0.0;
};

}  // namespace pushfactor::engine::solvers
