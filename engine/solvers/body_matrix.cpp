#include "engine/solvers/body_matrix.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>
#include <set>

namespace pushfactor::engine::solvers {

void BodyMatrix::connect(std::size_t bodies, std::span<const std::pair<int, int>> pairs,
                         std::span<const int> alone) {
    if (bodies == bodies_ && std::equal(pairs.begin(), pairs.end(), connected_.begin(), connected_.end()) &&
        std::equal(alone.begin(), alone.end(), alone_.begin(), alone_.end())) {
        return;
    }
    bodies_ = bodies;
    connected_.assign(pairs.begin(), pairs.end());
    alone_.assign(alone.begin(), alone.end());

    std::vector<std::vector<int>> neighbours(bodies);
    node_of_.assign(bodies, -1);
    for (const int body : alone) node_of_[static_cast<std::size_t>(body)] = 0;
    for (const auto& [a, b] : pairs) {
        node_of_[static_cast<std::size_t>(a)] = node_of_[static_cast<std::size_t>(b)] = 0;
        neighbours[static_cast<std::size_t>(a)].push_back(b);
        neighbours[static_cast<std::size_t>(b)].push_back(a);
    }
    order_nodes(std::move(neighbours));
    plan();
}

// Least degree first; the neighbours of an eliminated body become neighbours of each other. Among equals the one
// with the lowest index, so that the order depends on nothing else.
void BodyMatrix::order_nodes(std::vector<std::vector<int>> neighbours) {
    std::set<std::pair<std::size_t, int>> left;  // degree and body
    for (std::size_t body = 0; body < bodies_; ++body) {
        auto& own = neighbours[body];
        std::sort(own.begin(), own.end());
        own.erase(std::unique(own.begin(), own.end()), own.end());
        if (node_of_[body] >= 0) left.insert({own.size(), static_cast<int>(body)});
    }
    nodes_.clear();
    std::vector<std::vector<int>> below;  // as bodies
    while (!left.empty()) {
        const int body = left.begin()->second;
        left.erase(left.begin());
        const std::vector<int> around = std::move(neighbours[static_cast<std::size_t>(body)]);
        for (const int other : around) {
            std::vector<int> merged;
            auto& own = neighbours[static_cast<std::size_t>(other)];
            left.erase({own.size(), other});
            std::set_union(own.begin(), own.end(), around.begin(), around.end(), std::back_inserter(merged));
            std::erase_if(merged, [&](int b) { return b == body || b == other; });
            own = std::move(merged);
            left.insert({own.size(), other});
        }
        node_of_[static_cast<std::size_t>(body)] = static_cast<int>(nodes_.size());
        nodes_.push_back({.body = body, .below = {}, .blocks = {}, .updates = {}});
        below.push_back(around);
    }
    for (std::size_t k = 0; k < nodes_.size(); ++k) {
        for (const int body : below[k]) nodes_[k].below.push_back(node_of_[static_cast<std::size_t>(body)]);
        std::sort(nodes_[k].below.begin(), nodes_[k].below.end());
    }
}

// Where each block of the factor lies, and which products go where.
void BodyMatrix::plan() {
    int count = static_cast<int>(nodes_.size());
    for (Node& node : nodes_) {
        for (std::size_t i = 0; i < node.below.size(); ++i) node.blocks.push_back(count++);
    }
    blocks_.resize(static_cast<std::size_t>(count));
    factor_work_ = 0.0;
    for (Node& node : nodes_) {
        for (std::size_t j = 0; j < node.below.size(); ++j) {
            for (std::size_t i = j; i < node.below.size(); ++i) {
                const int target = i == j ? node.below[i] : block_between(node.below[j], node.below[i]);
                node.updates.push_back({target, node.blocks[i], node.blocks[j]});
            }
        }
        // Of the diagonal block, of each block below it, and of each product.
        factor_work_ += 56.0 + 126.0 * static_cast<double>(node.below.size()) +
                        216.0 * static_cast<double>(node.updates.size());
    }
}

int BodyMatrix::block_between(int earlier, int later) const {
    const Node& node = nodes_[static_cast<std::size_t>(earlier)];
    const auto found = std::lower_bound(node.below.begin(), node.below.end(), later);
    assert(found != node.below.end() && *found == later);
    return node.blocks[static_cast<std::size_t>(found - node.below.begin())];
}

void BodyMatrix::set_identity() {
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
        if (i < nodes_.size()) {
            blocks_[i].setIdentity();
        } else {
            blocks_[i].setZero();
        }
    }
}

void BodyMatrix::add(int a, const Vector6& u_a, int b, const Vector6& u_b, double weight) {
    const int node_a = node_of_[static_cast<std::size_t>(a)];
    const int node_b = node_of_[static_cast<std::size_t>(b)];
    const Vector6 weighted_a = weight * u_a;
    if (node_a >= 0) blocks_[static_cast<std::size_t>(node_a)].noalias() += weighted_a * u_a.transpose();
    if (node_b < 0) return;
    const Vector6 weighted_b = weight * u_b;
    blocks_[static_cast<std::size_t>(node_b)].noalias() += weighted_b * u_b.transpose();
    if (node_a < 0 || node_a == node_b) return;
    // A block belongs to the earlier node's column and the later node's row.
    if (node_a < node_b) {
        blocks_[static_cast<std::size_t>(block_between(node_a, node_b))].noalias() += weighted_b * u_a.transpose();
    } else {
        blocks_[static_cast<std::size_t>(block_between(node_b, node_a))].noalias() += weighted_a * u_b.transpose();
    }
}

// Replaces the lower triangle of a symmetric positive definite matrix by the inverse of its Cholesky factor, and
// what is above by zeros. With the inverse every further step is a product, without divisions that wait for each
// other.
void BodyMatrix::invert_factor(Matrix6& matrix) {
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

void BodyMatrix::factor() {
    for (std::size_t k = 0; k < nodes_.size(); ++k) {
        const Node& node = nodes_[k];
        invert_factor(blocks_[k]);
        for (const int block : node.blocks) {
            Matrix6& below = blocks_[static_cast<std::size_t>(block)];
            below = (below * blocks_[k].transpose()).eval();
        }
        for (const Update& update : node.updates) {
            blocks_[static_cast<std::size_t>(update.target)].noalias() -=
                blocks_[static_cast<std::size_t>(update.left)] *
                blocks_[static_cast<std::size_t>(update.right)].transpose();
        }
    }
}

void BodyMatrix::solve(std::vector<Vector6>& x) const {
    for (std::size_t k = 0; k < nodes_.size(); ++k) {
        const Node& node = nodes_[k];
        Vector6& own = x[static_cast<std::size_t>(node.body)];
        own = (blocks_[k] * own).eval();
        for (std::size_t i = 0; i < node.below.size(); ++i) {
            const int body = nodes_[static_cast<std::size_t>(node.below[i])].body;
            x[static_cast<std::size_t>(body)].noalias() -= blocks_[static_cast<std::size_t>(node.blocks[i])] * own;
        }
    }
    for (std::size_t k = nodes_.size(); k-- > 0;) {
        const Node& node = nodes_[k];
        Vector6& own = x[static_cast<std::size_t>(node.body)];
        for (std::size_t i = 0; i < node.below.size(); ++i) {
            const int body = nodes_[static_cast<std::size_t>(node.below[i])].body;
            own.noalias() -=
                blocks_[static_cast<std::size_t>(node.blocks[i])].transpose() * x[static_cast<std::size_t>(body)];
        }
        own = (blocks_[k].transpose() * own).eval();
    }
}

}  // namespace pushfactor::engine::solvers
