// Remaining budget of an exact solve, over all columns and methods. Internal to the solvers.
#pragma once

#include <algorithm>

namespace pushfactor::engine::solvers {

class Effort {
  public:
    // Limits on multiply-adds in total and on factorisations per column.
    Effort(double work, int columns, double factorisations)
        : left_(work), columns_(columns), of_a_column_(factorisations) {}

    // Gives the next column its share of the rest, but at least so many multiply-adds; to be called for the first
    // one too.
    void begin_column(double at_least = 0.0) {
        work_ = std::max(left_ / columns_--, at_least);
        factorisations_ = of_a_column_;
    }

    // Whether the rest of the column covers a factorisation that takes `work`.
    bool affords(double work) const { return work <= work_ && factorisations_ >= 1.0; }
    void spend(double work) {
        work_ -= work;
        left_ -= work;
    }
    void spend_factorisation(double work) {
        spend(work);
        factorisations_ -= 1.0;
    }

  private:
    double left_ = 0.0, work_ = 0.0;  // multiply-adds, of all columns and of the current one
    int columns_ = 1;                 // still to come
    double of_a_column_ = 0.0, factorisations_ = 0.0;
};

}  // namespace pushfactor::engine::solvers
