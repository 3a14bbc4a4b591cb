#include "engine/solvers/exact/elimination.h"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <set>

namespace pushfactor::engine::solvers {

namespace {

// Work for a node of a symmetric matrix with that many blocks below and products: diagonal block, each block below
// it, each product.
double symmetric_work_of(double below, double products) {
    return 56.0 + 126.0 * below + 216.0 * products;
}

}  // namespace

void Elimination::find(int bodies, std::span<const std::pair<int, int>> pairs, double most_work) {
    std::vector<std::vector<int>> neighbours(static_cast<std::size_t>(bodies));
    for (const auto& [a, b] : pairs) {
        neighbours[static_cast<std::size_t>(a)].push_back(b);
        neighbours[static_cast<std::size_t>(b)].push_back(a);
    }
    if (order(std::move(neighbours), most_work)) {
        number_blocks();
        return;
    }
    nodes_.clear();
    node_of_.clear();
    block_count_ = 0;
    symmetric_work_ = general_work_ = infinity;
}

// Minimum degree; the neighbours of an eliminated body become neighbours of each other. Ties go to the lowest
// number, so that the order depends on nothing else. Returns false if the work limit is exceeded.
bool Elimination::order(std::vector<std::vector<int>> neighbours, double most_work) {
    std::set<std::pair<std::size_t, int>> left;  // degree and body
    for (std::size_t body = 0; body < neighbours.size(); ++body) {
        auto& own = neighbours[body];
        std::sort(own.begin(), own.end());
        own.erase(std::unique(own.begin(), own.end()), own.end());
        left.insert({own.size(), static_cast<int>(body)});
    }
    node_of_.assign(neighbours.size(), -1);
    nodes_.clear();
    std::vector<std::vector<int>> below;  // body numbers
    double work = 0.0;
    while (!left.empty()) {
        const int body = left.begin()->second;
        const auto degree = static_cast<double>(left.begin()->first);
        work += symmetric_work_of(degree, 0.5 * degree * (degree + 1.0));
        if (work > most_work) return false;
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
        for (const int body : below[k]) nodes_[k].below.push_back(node_of(body));
        std::sort(nodes_[k].below.begin(), nodes_[k].below.end());
    }
    return true;
}

// Numbers the blocks of the factor and lists the products.
void Elimination::number_blocks() {
    int count = static_cast<int>(nodes_.size());
    for (Node& node : nodes_) {
        for (std::size_t i = 0; i < node.below.size(); ++i) node.blocks.push_back(count++);
    }
    block_count_ = static_cast<std::size_t>(count);
    symmetric_work_ = general_work_ = 0.0;
    for (Node& node : nodes_) {
        for (std::size_t j = 0; j < node.below.size(); ++j) {
            for (std::size_t i = j; i < node.below.size(); ++i) {
                const int target = i == j ? node.below[i] : block_between(node.below[j], node.below[i]);
                node.updates.push_back({target, node.blocks[i], node.blocks[j]});
            }
        }
        const auto below = static_cast<double>(node.below.size());
        const auto products = static_cast<double>(node.updates.size());
        symmetric_work_ += symmetric_work_of(below, products);
        // An unsymmetric matrix has the products above the diagonal too.
        general_work_ += 216.0 + 216.0 * below + 216.0 * (2.0 * products - below);
    }
}

int Elimination::block_between(int earlier, int later) const {
    const Node& node = nodes_[static_cast<std::size_t>(earlier)];
    const auto found = std::lower_bound(node.below.begin(), node.below.end(), later);
    assert(found != node.below.end() && *found == later);
    return node.blocks[static_cast<std::size_t>(found - node.below.begin())];
}

}  // namespace pushfactor::engine::solvers
