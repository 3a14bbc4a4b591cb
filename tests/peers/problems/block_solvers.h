// Solvers of local problems, where there are no bodies to sweep over: W in blocks of 3 x 3.
#pragma once

#include "tests/peers/problems/contact_problem.h"

#include <span>
#include <string_view>
#include <vector>

namespace pushfactor::tests::problems {

// The problem as sweeps read it: rows of blocks, and step sizes.
class BlockProblem {
  public:
    explicit BlockProblem(const LocalProblem& problem);

    // One sweep of projected Gauss-Seidel over all contacts, in their order; `impulses` [N s] are changed.
    void sweep(engine::VectorX& impulses) const;

    double multiply_adds_of_a_sweep() const { return 9.0 * static_cast<double>(blocks_.size()); }

  private:
    struct Block {
        int contact;
        engine::Matrix3 matrix;
    };
    struct Contact {
        std::size_t begin, end;               // blocks of its row
        double normal_step, tangential_step;  // kg; 0 for a contact that moves nothing
        double mu;
    };

    std::vector<Block> blocks_;
    std::vector<Contact> contacts_;
    engine::VectorX free_;
};

struct BlockSolver {
    std::string_view name;
    // From zero; returns the impulses after so many sweeps.
    engine::VectorX (*solve)(const BlockProblem& problem, Eigen::Index rows, int sweeps);
};

// Projected Gauss-Seidel, and the same with conjugate directions (as solvers/nncg.h).
std::span<const BlockSolver> block_solvers();

}  // namespace pushfactor::tests::problems
