#include "engine/solvers/exact/body_matrix.h"

#include "engine/solvers/exact/blocks.h"

#include <algorithm>

namespace pushfactor::engine::solvers {

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

// A block is stored in the column of the earlier node and the row of the later one.
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
    if (node_a >= 0) blocks::add_outer(at(node_a), weight, u_a.data(), u_a.data());
    if (node_b >= 0) blocks::add_outer(at(node_b), weight, u_b.data(), u_b.data());
    if (node_a < 0 || node_b < 0 || node_a == node_b) return;
    const Between& pair = between(a, b);
    const Vector6 &earlier = pair.a_first ? u_a : u_b, &later = pair.a_first ? u_b : u_a;
    blocks::add_outer(at(pair.block), weight, later.data(), earlier.data());
}

void BodyMatrix::add_product(int a, const Vector6& v_a, const Vector6& u_a, int b, const Vector6& v_b,
                             const Vector6& u_b, double weight) {
    if (symmetric_) {
        symmetric_ = false;
        above_.assign(blocks_.size(), Matrix6::Zero());
    }
    const int node_a = node_of(a), node_b = node_of(b);
    if (node_a >= 0) blocks::add_outer(at(node_a), weight, v_a.data(), u_a.data());
    if (node_b >= 0) blocks::add_outer(at(node_b), weight, v_b.data(), u_b.data());
    if (node_a < 0 || node_b < 0 || node_a == node_b) return;
    const Between& pair = between(a, b);
    const auto add_pair = [&](const Vector6& v_1, const Vector6& u_1, const Vector6& v_2, const Vector6& u_2) {
        blocks::add_outer(at(pair.block), weight, v_2.data(), u_1.data());
        blocks::add_difference(above(pair.block), weight, v_1.data(), u_2.data(), u_1.data(), v_2.data());
    };
    if (pair.a_first) {
        add_pair(v_a, u_a, v_b, u_b);
    } else {
        add_pair(v_b, u_b, v_a, u_a);
    }
}

void BodyMatrix::factor() {
    if (symmetric_) {
        factor_symmetric();
    } else {
        factor_general();
    }
}

void BodyMatrix::factor_symmetric() {
    int k = 0;
    for (const Elimination::Node& node : order_->nodes()) {
        double* const own = at(k++);
        blocks::invert_factor(own);
        for (const int index : node.blocks) blocks::multiply_with_transposed(at(index), own);
        for (const Elimination::Update& update : node.updates) {
            blocks::subtract_product_with_transposed(at(update.target), at(update.left), at(update.right));
        }
    }
}

// Column k then holds L_ik unchanged and D_k^-1 U_kj.
void BodyMatrix::factor_general() {
    const auto& nodes = order_->nodes();
    const int count = static_cast<int>(blocks_.size());
    for (int index = static_cast<int>(nodes.size()); index < count; ++index) {
        blocks::add_transposed(above(index), at(index));
    }
    int k = 0;
    for (const Elimination::Node& node : nodes) {
        double* const own = at(k++);
        blocks::invert(own);
        for (const int index : node.blocks) blocks::multiply(above(index), own);
        for (const Elimination::Update& update : node.updates) {
            blocks::subtract_product(at(update.target), at(update.left), above(update.right));
            if (update.left == update.right) continue;
            blocks::subtract_product(above(update.target), at(update.right), above(update.left));
        }
    }
}

void BodyMatrix::solve(std::vector<Vector6>& x) const {
    const auto& nodes = order_->nodes();
    const auto of_body = [&x](const Elimination::Node& node) -> Vector6& {
        return x[static_cast<std::size_t>(node.body)];
    };
    const auto each_below = [&](const Elimination::Node& node, const auto& visit) {
        for (std::size_t i = 0; i < node.below.size(); ++i) {
            const auto index = static_cast<std::size_t>(node.blocks[i]);
            visit(index, of_body(nodes[static_cast<std::size_t>(node.below[i])]).data());
        }
    };
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        Vector6& own = of_body(nodes[k]);
        own = (blocks_[k] * own).eval();
        each_below(nodes[k], [&](std::size_t index, double* below) {
            blocks::subtract_times(below, blocks_[index].data(), own.data());
        });
    }
    for (std::size_t k = nodes.size(); k-- > 0;) {
        Vector6& own = of_body(nodes[k]);
        each_below(nodes[k], [&](std::size_t index, const double* below) {
            if (symmetric_) {
                blocks::subtract_transposed_times(own.data(), blocks_[index].data(), below);
            } else {
                blocks::subtract_times(own.data(), above_[index].data(), below);
            }
        });
        if (symmetric_) own = (blocks_[k].transpose() * own).eval();
    }
}

}  // namespace pushfactor::engine::solvers
