// Matrices with a 6 x 6 block for each movable body, and their factors: what a solver needs that works on the
// bodies' velocities instead of on the rows' forces. The blocks outside of the diagonal are where rows connect two
// bodies, and where elimination fills in (elimination.h).
//
// Symmetric positive definite while only add() has added to it: Cholesky factors. After add_product() it is
// symmetric no more: L U factors, without exchanges between blocks.
#pragma once

#include "engine/base/math.h"
#include "engine/solvers/exact/elimination.h"

#include <vector>

namespace pushfactor::engine::solvers {

using Matrix6 = Eigen::Matrix<double, 6, 6>;

class BodyMatrix {
  public:
    // Makes it the unit matrix, to be factorised in this order, which must outlive its use.
    void begin(const Elimination& order);

    // Adds weight u u^T for u = (u_a at body a, u_b at body b). A body without a block is skipped. Two bodies with
    // blocks must be connected.
    void add(int a, const Vector6& u_a, int b, const Vector6& u_b, double weight);

    // Adds v u^T for v = (v_a at body a, v_b at body b) and u likewise.
    void add_product(int a, const Vector6& v_a, const Vector6& u_a, int b, const Vector6& v_b, const Vector6& u_b);

    // Replaces the matrix by its factors; the diagonal blocks of those by their inverses.
    void factor();

    // Solves for a vector with six entries per body, in place; entries of bodies without a block stay.
    void solve(std::vector<Vector6>& x) const;

    // Multiply-adds of factor() for the matrix as it is.
    double factor_work() const { return symmetric_ ? order_->symmetric_work() : order_->general_work(); }
    double solve_work() const { return order_->solve_work(); }

  private:
    // The block of two bodies, the node of the earlier one, and whether that is the first of them.
    struct Between {
        int a = -1, b = -1;
        int block = 0;
        bool a_first = true;
    };
    int node_of(int body) const { return order_->node_of(body); }
    Matrix6& block(int index) { return blocks_[static_cast<std::size_t>(index)]; }
    const Between& between(int a, int b);
    void factor_symmetric();
    void factor_general();

    const Elimination* order_ = nullptr;
    bool symmetric_ = true;
    std::vector<Matrix6> blocks_;  // on and below the diagonal
    // Above the diagonal, at the place of the block that mirrors it: first what it has beyond that one transposed,
    // then the block itself, then that times the inverse of the diagonal block before it.
    std::vector<Matrix6> above_;
    Between last_;  // rows of the same two bodies come together
};

}  // namespace pushfactor::engine::solvers
