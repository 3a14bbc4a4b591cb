// Remaining budget of an exact solve, over all columns and methods. Internal to the solvers.
#pragma once

namespace pushfactor::engine::solvers {

class Effort {
  public:
    // Limits on multiply-adds in total and on factorisations per column.
    explicit Effort(double work, double factorisations = infinity) : left_(work), of_a_column_(factorisations) {
        begin_column(1);
    }

    // Gives a column its share of the rest; `columns` is the number of columns still to come, including this one.
    void begin_column(int columns) {
        work_ = left_ / columns;
        factorisations_ = of_a_column_;
    }

    // Whether the rest of the column covers a factorisation that takes `work`.
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
    double left_ = 0.0, work_ = 0.0, spent_ = 0.0;  // multiply-adds, of all columns and of the current one
    double of_a_column_ = 0.0, factorisations_ = 0.0;
};

}  // namespace pushfactor::engine::solvers
