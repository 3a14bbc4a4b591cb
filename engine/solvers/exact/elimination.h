// The order in which the bodies' blocks of a matrix are eliminated, and where that fills in: what a factorisation
// is before it sees a number. An inner matter of the solvers.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace pushfactor::engine::solvers {

class Elimination {
  public:
    struct Update {
        int target, left, right;  // blocks: target -= left times right
    };
    struct Node {
        int body = 0;
        std::vector<int> below;   // nodes later in the order that are connected, ascending
        std::vector<int> blocks;  // of them, in that order
        std::vector<Update> updates;
    };

    // For `bodies` bodies with a block each, connected as in `pairs`: body numbers below `bodies`, in any order and
    // number. Least degree goes first, so that little fills in. Gives up where a factorisation would take more than
    // `most_work` multiply-adds: a heap of thousands would fill gigabytes before anybody saw that it does not pay.
    void find(int bodies, std::span<const std::pair<int, int>> pairs,
              double most_work = std::numeric_limits<double>::infinity());

    const std::vector<Node>& nodes() const { return nodes_; }
    // Blocks on the diagonal and below it, the diagonal ones first, in the order of elimination.
    std::size_t block_count() const { return block_count_; }

    // The place of `body` in the order; -1 for a body that has no block.
    int node_of(int body) const {
        return static_cast<std::size_t>(body) < node_of_.size() ? node_of_[static_cast<std::size_t>(body)] : -1;
    }
    // The block of two connected nodes, the earlier one first.
    int block_between(int earlier, int later) const;

    // Multiply-adds of a factorisation of a symmetric matrix, and of one of any other; infinite where it gave up.
    double symmetric_work() const { return symmetric_work_; }
    double general_work() const { return general_work_; }
    // Of a solution with the factors.
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
