#include "tests/peers/problems/block_solvers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace pushfactor::tests::problems {

namespace {

using engine::Matrix3;
using engine::Vector3;
using engine::VectorX;

// Of the symmetric part of the block of both tangents.
double largest_eigenvalue(const Matrix3& block) {
    const double a = block(1, 1), b = block(2, 2), c = 0.5 * (block(1, 2) + block(2, 1));
    return 0.5 * (a + b) + std::hypot(0.5 * (a - b), c);
}

double step_for(double weight) {
    return weight > 0.0 ? 1.0 / weight : 0.0;
}

VectorX sweeps_alone(const BlockProblem& problem, Eigen::Index rows, int sweeps) {
    VectorX impulses = VectorX::Zero(rows);
    for (int i = 0; i < sweeps; ++i) problem.sweep(impulses);
    return impulses;
}

// M. Silcowitz, S. Niebe, K. Erleben, "A nonsmooth nonlinear conjugate gradient method for interactive contact
// force problems", 2010. A sweep stands for a gradient step.
VectorX conjugate_sweeps(const BlockProblem& problem, Eigen::Index rows, int sweeps) {
    VectorX impulses = VectorX::Zero(rows);
    VectorX before = impulses, step = VectorX::Zero(rows), direction = VectorX::Zero(rows);
    double last = 0.0;
    for (int i = 0; i < sweeps; ++i) {
        before = impulses;
        problem.sweep(impulses);
        step = impulses - before;
        const double now = step.squaredNorm();
        const double share = i > 0 && last > 0.0 ? now / last : 2.0;
        last = now;
        if (i + 1 == sweeps) break;  // a direction is only added before another sweep, which projects it
        if (share > 1.0) {
            direction = step;
        } else {
            impulses += share * direction;
            direction = share * direction + step;
        }
    }
    return impulses;
}

}  // namespace

BlockProblem::BlockProblem(const LocalProblem& problem) : free_(problem.free) {
    const auto count = static_cast<std::size_t>(problem.contacts());
    std::vector<std::map<int, Matrix3>> rows(count);
    for (Eigen::Index column = 0; column < problem.matrix.outerSize(); ++column) {
        for (SparseMatrix::InnerIterator entry(problem.matrix, column); entry; ++entry) {
            const auto row = static_cast<std::size_t>(entry.row() / 3);
            const auto [place, is_new] = rows[row].try_emplace(static_cast<int>(column / 3), Matrix3::Zero());
            place->second(entry.row() % 3, column % 3) = entry.value();
        }
    }
    for (std::size_t row = 0; row < count; ++row) {
        Contact contact{blocks_.size(), 0, 0.0, 0.0, problem.mu[static_cast<Eigen::Index>(row)]};
        for (const auto& [column, block] : rows[row]) {
            blocks_.push_back({column, block});
            if (column != static_cast<int>(row)) continue;
            contact.normal_step = step_for(block(0, 0));
            contact.tangential_step = step_for(largest_eigenvalue(block));
        }
        contact.end = blocks_.size();
        contacts_.push_back(contact);
    }
}

void BlockProblem::sweep(VectorX& impulses) const {
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        const Contact& contact = contacts_[i];
        const auto row = static_cast<Eigen::Index>(3 * i);
        Vector3 velocity = free_.segment<3>(row);
        const Matrix3* own = nullptr;
        for (std::size_t k = contact.begin; k < contact.end; ++k) {
            velocity += blocks_[k].matrix * impulses.segment<3>(3 * blocks_[k].contact);
            if (blocks_[k].contact == static_cast<int>(i)) own = &blocks_[k].matrix;
        }
        double& normal = impulses[row];
        const double change = std::max(normal - contact.normal_step * velocity[0], 0.0) - normal;
        normal += change;
        if (own) velocity.tail<2>() += change * own->col(0).tail<2>();
        Eigen::Vector2d tangential = impulses.segment<2>(row + 1) - contact.tangential_step * velocity.tail<2>();
        const double length = tangential.norm(), radius = contact.mu * normal;
        if (length > radius) tangential *= radius / length;
        impulses.segment<2>(row + 1) = tangential;
    }
}

std::span<const BlockSolver> block_solvers() {
    static constexpr std::array table{BlockSolver{"pgs", sweeps_alone}, BlockSolver{"nncg", conjugate_sweeps}};
    return table;
}

}  // namespace pushfactor::tests::problems
