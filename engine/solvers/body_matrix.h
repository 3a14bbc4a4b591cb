// Symmetric positive definite matrices with a 6 x 6 block for each movable body, and their Cholesky factors: what a
// solver needs that works on the bodies' velocities instead of on the rows' forces. The blocks outside of the
// diagonal are where rows connect two bodies, and where elimination fills in.
#pragma once

#include "engine/math.h"

#include <span>
#include <utility>
#include <vector>

namespace pushfactor::engine::solvers {

using Matrix6 = Eigen::Matrix<double, 6, 6>;

class BodyMatrix {
  public:
    // Which bodies are connected: pairs of body indices below `bodies`, in any order and number. A body that is in
    // no pair and not in `alone` has no block. Orders the bodies by least degree, so that little fills in. Does
    // nothing when nothing has changed since the last call.
    void connect(std::size_t bodies, std::span<const std::pair<int, int>> pairs, std::span<const int> alone);

    // Multiply-adds of one factorisation.
    double factor_work() const { return factor_work_; }
    std::size_t block_count() const { return blocks_.size(); }
    double solve_work() const { return 72.0 * static_cast<double>(blocks_.size()); }

    void set_identity();

    // Adds weight u u^T for u = (u_a at body a, u_b at body b); a body without a block is skipped (below zero).
    void add(int a, const Vector6& u_a, int b, const Vector6& u_b, double weight);

    // Replaces the matrix by its factor; the diagonal blocks of that by their inverses.
    void factor();

    // Solves for a vector with six entries a body, in place; entries of bodies without a block stay.
    void solve(std::vector<Vector6>& x) const;

    bool has(int body) const { return node_of_[static_cast<std::size_t>(body)] >= 0; }

  private:
    struct Update {
        int target, left, right;  // blocks: target -= left right^T
    };
    struct Node {
        int body = 0;
        std::vector<int> below;   // nodes later in the order that are connected, ascending
        std::vector<int> blocks;  // of them, in that order
        std::vector<Update> updates;
    };

    static void invert_factor(Matrix6& matrix);
    void order_nodes(std::vector<std::vector<int>> neighbours);
    void plan();
    int block_between(int earlier, int later) const;

    std::vector<std::pair<int, int>> connected_;  // what connect() was asked for
    std::vector<int> alone_;
    std::size_t bodies_ = 0;

    std::vector<int> node_of_;  // of a body, by its place in the order; -1 without a block
    std::vector<Node> nodes_;
    std::vector<Matrix6> blocks_;  // the diagonal ones first
    double factor_work_ = 0.0;
};

}  // namespace pushfactor::engine::solvers
