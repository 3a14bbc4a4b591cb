#include "engine/solvers/exact/body_matrix.h"

#include <algorithm>
#include <cmath>

namespace pushfactor::engine::solvers {

namespace {

// Replaces the lower triangle of a symmetric positive definite matrix by the inverse of its Cholesky factor, and
// what is above by zeros. With the inverse every further step is a product, without divisions that wait for each
// other.
void invert_factor(Matrix6& matrix) {
    Matrix6 inverse = Matrix6::Zero();
    for (int column = 0; column < 6; ++column) {
        for (int k = 0; k < column; ++k) {
            for (int row = column; row < 6; ++row) matrix(row, column) -= matrix(row, k) * matrix(column, k);
        }
        const double to_unit = 1.0 / std::sqrt(matrix(column, column));
        for (int row = column; row < 6; ++row) matrix(row, column) *= to_unit;
        inverse(column, column) = to_unit;
        for (int k = 0; k < column; ++k) {
            double sum = 0.0;
            for (int i = k; i < column; ++i) sum += matrix(column, i) * inverse(i, k);
            inverse(column, k) = -to_unit * sum;
        }
    }
    matrix = inverse;
}

// Replaces any matrix by its inverse: Gauss-Jordan with exchanges of rows. Not finite where it is singular.
void invert(Matrix6& matrix) {
    Matrix6 inverse = Matrix6::Identity();
    for (int column = 0; column < 6; ++column) {
        int pivot = column;
        for (int row = column + 1; row < 6; ++row) {
            if (std::abs(matrix(row, column)) > std::abs(matrix(pivot, column))) pivot = row;
        }
        if (pivot != column) {
            matrix.row(pivot).swap(matrix.row(column));
            inverse.row(pivot).swap(inverse.row(column));
        }
        const double to_unit = 1.0 / matrix(column, column);
        matrix.row(column) *= to_unit;
        inverse.row(column) *= to_unit;
        for (int row = 0; row < 6; ++row) {
            if (row == column) continue;
            const double share = matrix(row, column);
            matrix.row(row) -= share * matrix.row(column);
            inverse.row(row) -= share * inverse.row(column);
        }
    }
    matrix = inverse;
}

}  // namespace

void BodyMatrix::begin(const Elimination& order) {
    order_ = &order;
    symmetric_ = true;
    last_ = {};
    blocks_.resize(order.block_count());
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
        if (i < order.nodes().size()) {
            blocks_[i].setIdentity();
        } else {
            blocks_[i].setZero();
        }
    }
}

// A block belongs to the earlier node's column and the later node's row.
const BodyMatrix::Between& BodyMatrix::between(int a, int b) {
    if (last_.a != a || last_.b != b) {
        const int node_a = node_of(a), node_b = node_of(b);
        last_ = {.a = a,
                 .b = b,
                 .block = order_->block_between(std::min(node_a, node_b), std::max(node_a, node_b)),
                 .a_first = node_a < node_b};
    }
    return last_;
}

void BodyMatrix::add(int a, const Vector6& u_a, int b, const Vector6& u_b, double weight) {
    const int node_a = node_of(a), node_b = node_of(b);
    const Vector6 weighted_a = weight * u_a;
    if (node_a >= 0) block(node_a).noalias() += weighted_a * u_a.transpose();
    if (node_b < 0) return;
    const Vector6 weighted_b = weight * u_b;
    block(node_b).noalias() += weighted_b * u_b.transpose();
    if (node_a < 0 || node_a == node_b) return;
    const Between& pair = between(a, b);
    if (pair.a_first) {
        block(pair.block).noalias() += weighted_b * u_a.transpose();
    } else {
        block(pair.block).noalias() += weighted_a * u_b.transpose();
    }
}

void BodyMatrix::add_product(int a, const Vector6& v_a, const Vector6& u_a, int b, const Vector6& v_b,
                             const Vector6& u_b) {
    if (symmetric_) {
        symmetric_ = false;
        above_.assign(blocks_.size(), Matrix6::Zero());
    }
    const int node_a = node_of(a), node_b = node_of(b);
    if (node_a >= 0) block(node_a).noalias() += v_a * u_a.transpose();
    if (node_b >= 0) block(node_b).noalias() += v_b * u_b.transpose();
    if (node_a < 0 || node_b < 0 || node_a == node_b) return;
    const Between& pair = between(a, b);
    const Matrix6 b_by_a = v_b * u_a.transpose(), a_by_b = v_a * u_b.transpose();
    const Matrix6& below = pair.a_first ? b_by_a : a_by_b;
    const Matrix6& over = pair.a_first ? a_by_b : b_by_a;
    block(pair.block) += below;
    above_[static_cast<std::size_t>(pair.block)] += over - below.transpose();
}

void BodyMatrix::factor() {
    if (symmetric_) {
        factor_symmetric();
    } else {
        factor_general();
    }
}

void BodyMatrix::factor_symmetric() {
    const auto& nodes = order_->nodes();
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        const Elimination::Node& node = nodes[k];
        invert_factor(blocks_[k]);
        for (const int index : node.blocks) block(index) = (block(index) * blocks_[k].transpose()).eval();
        for (const Elimination::Update& update : node.updates) {
            block(update.target).noalias() -= block(update.left) * block(update.right).transpose();
        }
    }
}

// Of column k stay L_ik as they are, and D_k^-1 U_kj.
void BodyMatrix::factor_general() {
    const auto& nodes = order_->nodes();
    for (std::size_t i = nodes.size(); i < blocks_.size(); ++i) above_[i] += blocks_[i].transpose();
    const auto above = [this](int index) -> Matrix6& { return above_[static_cast<std::size_t>(index)]; };
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        const Elimination::Node& node = nodes[k];
        invert(blocks_[k]);
        for (const int index : node.blocks) above(index) = (blocks_[k] * above(index)).eval();
        for (const Elimination::Update& update : node.updates) {
            block(update.target).noalias() -= block(update.left) * above(update.right);
            if (update.left == update.right) continue;
            above(update.target).noalias() -= block(update.right) * above(update.left);
        }
    }
}

void BodyMatrix::solve(std::vector<Vector6>& x) const {
    const auto& nodes = order_->nodes();
    const auto below = [&](const Elimination::Node& node, std::size_t i) -> Vector6& {
        return x[static_cast<std::size_t>(nodes[static_cast<std::size_t>(node.below[i])].body)];
    };
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        const Elimination::Node& node = nodes[k];
        Vector6& own = x[static_cast<std::size_t>(node.body)];
        own = (blocks_[k] * own).eval();
        for (std::size_t i = 0; i < node.below.size(); ++i) {
            below(node, i).noalias() -= blocks_[static_cast<std::size_t>(node.blocks[i])] * own;
        }
    }
    for (std::size_t k = nodes.size(); k-- > 0;) {
        const Elimination::Node& node = nodes[k];
        Vector6& own = x[static_cast<std::size_t>(node.body)];
        for (std::size_t i = 0; i < node.below.size(); ++i) {
            const auto index = static_cast<std::size_t>(node.blocks[i]);
            if (symmetric_) {
                own.noalias() -= blocks_[index].transpose() * below(node, i);
            } else {
                own.noalias() -= above_[index] * below(node, i);
            }
        }
        if (symmetric_) own = (blocks_[k].transpose() * own).eval();
    }
}

}  // namespace pushfactor::engine::solvers
