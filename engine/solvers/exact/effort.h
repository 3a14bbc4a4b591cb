// What an exact solve may still spend: over all columns and everything that is tried. An inner matter of the
// solvers.
#pragma once

#include <limits>

namespace pushfactor::engine::solvers {

class Effort {
  public:
    // At most so many multiply-adds in all, and so many factorisations per column.
    explicit Effort(double work, double factorisations = std::numeric_limits<double>::infinity())
        : left_(work), of_a_column_(factorisations) {
        begin_column(1);
    }

    // A column gets its share of what is left, where so many are still to come, itself included.
    void begin_column(int columns) {
        work_ = left_ / columns;
        factorisations_ = of_a_column_;
    }

    // Whether there is enough left in the column for a factorisation that takes `work`.
    bool affords(double work) const { return work <= work_ && factorisations_ >= 1.0; }
    void spend(double work) {
        work_ -= work;
        left_ -= work;
        spent_ += work;
    }
    void spend_factorisation(double work) {
        spend(work);
        factorisations_ -= 1.0;
    }
    double spent() const { return spent_; }

  private:
    double left_ = 0.0, work_ = 0.0, spent_ = 0.0;  // multiply-adds, of all columns and of the one at hand
    double of_a_column_ = 0.0, factorisations_ = 0.0;
};

}  // namespace pushfactor::engine::solvers
