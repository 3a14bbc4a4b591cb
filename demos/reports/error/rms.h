// Root of the mean of squares.
#pragma once

#include <cmath>

namespace pushfactor::demos::reports::error {

class Rms {
  public:
    void add(double square) {
        sum_ += square;
        ++count_;
    }
    double value() const { return count_ > 0 ? std::sqrt(sum_ / static_cast<double>(count_)) : 0.0; }

  private:
    double sum_ = 0.0;
    long count_ = 0;
};

}  // namespace pushfactor::demos::reports::error
