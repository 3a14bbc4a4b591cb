// Matrices with a 6 x 6 block per movable body, and their factors, for solvers that work on the bodies' velocities
// instead of the rows' forces. Off-diagonal blocks exist where rows connect two bodies and where elimination fills
// in (elimination.h).
//
// Symmetric positive definite while only add() is used: Cholesky. After add_product() unsymmetric: LU without
// pivoting between blocks.
#pragma once

#include "engine/base/math.h"
#include "engine/solvers/exact/elimination.h"

#include <vector>

namespace pushfactor::engine::solvers {

using Matrix6 = Eigen::Matrix<double, 6, 6>;

class BodyMatrix {
  public:
    // Resets to the identity, for factorisation in this order, which must outlive its use.
    void begin(const Elimination& order);

    // Adds weight u u^T for u = (u_a at body a, u_b at body b). Bodies without a block are skipped. Two bodies with
    // blocks must be connected.
    void add(int a, const Vector6& u_a, int b, const Vector6& u_b, double weight);

    // Adds weight v u^T for v = (v_a at body a, v_b at body b) and u likewise.
    void add_product(int a, const Vector6& v_a, const Vector6& u_a, int b, const Vector6& v_b, const Vector6& u_b,
                     double weight);

    // Replaces the matrix by its factors, with inverted diagonal blocks.
    void factor();

    // Solves in place for a vector with six entries per body; entries of bodies without a block stay unchanged.
    void solve(std::vector<Vector6>& x) const;

    // Multiply-adds of factor() for the current matrix.
    double factor_work() const { return symmetric_ ? order_->symmetric_work() : order_->general_work(); }
    double solve_work() const { return order_->solve_work(); }

  private:
    // The block of two bodies, and whether a is eliminated first.
    struct Between {
        int a = -1, b = -1;
        int block = 0;
        bool a_first = true;
    };
    int node_of(int body) const { return order_->node_of(body); }
    double* at(int index) { return blocks_[static_cast<std::size_t>(index)].data(); }
    double* above(int index) { return above_[static_cast<std::size_t>(index)].data(); }
    const Between& between(int a, int b);
    void factor_symmetric();
    void factor_general();

    const Elimination* order_ = nullptr;
    bool symmetric_ = true;
    std::vector<Matrix6> blocks_;  // on and below the diagonal
    // Above the diagonal, stored at the index of the mirrored block: first the difference to its transpose, then
    // the block itself, then its product with the inverse of the preceding diagonal block.
    std::vector<Matrix6> above_;
    Between last_;  // cache: rows of the same two bodies come together
};

}  // namespace pushfactor::engine::solvers
