// Axes along which the rows of a Newton step push their bodies: their own, and those of the rows whose forces
// follow theirs, u_i + sum of c_k u_k. Internal to the solvers.
#pragma once

#include "engine/solvers/exact/body_matrix.h"
#include "engine/solvers/exact/unit_problem.h"

#include <vector>

namespace pushfactor::engine::solvers {

class PushedAxes {
  public:
    void start(const UnitProblem& problem) {
        own_ = problem.units;
        axes_.clear();
        leads_.assign(problem.rows.size(), 0);
        if (problem.bounds_follow) axes_.assign(own_, own_ + problem.rows.size());
    }

    // A force along `unit` of `factor` times that of row `leader`, between the same two bodies.
    void follow(int leader, double factor, const Jacobian& unit) {
        Jacobian& axis = axes_[static_cast<std::size_t>(leader)];
        axis.a += factor * unit.a;
        axis.b += factor * unit.b;
        leads_[static_cast<std::size_t>(leader)] = 1;
    }

    bool leads(std::size_t row) const { return leads_[row] != 0; }

    // By row.
    const Jacobian* all() const { return axes_.empty() ? own_ : axes_.data(); }

    // Adds the row to the matrix; only one that leads makes it unsymmetric.
    void add(const UnitProblem& problem, std::size_t number, double weight, BodyMatrix& matrix) const {
        const UnitRow& row = problem.rows[number];
        if (leads(number)) {
            const Jacobian& axis = axes_[number];
            matrix.add_product(row.a, axis.a, row.unit->a, row.b, axis.b, row.unit->b, weight);
        } else {
            matrix.add(row.a, row.unit->a, row.b, row.unit->b, weight);
        }
    }

  private:
    const Jacobian* own_ = nullptr;
    std::vector<Jacobian> axes_;  // empty if no bounds follow
    std::vector<char> leads_;
};

}  // namespace pushfactor::engine::solvers
