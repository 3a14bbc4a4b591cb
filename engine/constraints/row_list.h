// The rows of a step. Memory is reused from step to step, and each row is initialised where it is written,
// which saves a pass over all of them.
#pragma once

#include "engine/constraints/constraint_row.h"

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace pushfactor::engine {

class RowList {
  public:
    ConstraintRow& emplace_back() {
        if (count_++ == made_.size()) return made_.emplace_back();
        return *std::construct_at(&made_[count_ - 1]);
    }

    // Appends `count` rows with stale values that the caller has to initialise. Returns all rows.
    std::span<ConstraintRow> append(std::size_t count) {
        count_ += count;
        if (made_.size() < count_) made_.resize(count_ + count_ / 8);
        return {made_.data(), count_};
    }

    void clear() { count_ = 0; }
    std::size_t size() const { return count_; }
    bool empty() const { return count_ == 0; }

    ConstraintRow& operator[](std::size_t row) { return made_[row]; }
    const ConstraintRow& operator[](std::size_t row) const { return made_[row]; }
    ConstraintRow* begin() { return made_.data(); }
    ConstraintRow* end() { return made_.data() + count_; }
    ConstraintRow* data() { return made_.data(); }
    const ConstraintRow* data() const { return made_.data(); }
    std::span<ConstraintRow> last(std::size_t count) { return {end() - count, count}; }
    std::span<const ConstraintRow> all() const { return {data(), count_}; }
    const ConstraintRow* begin() const { return made_.data(); }
    const ConstraintRow* end() const { return made_.data() + count_; }

  private:
    std::vector<ConstraintRow> made_;  // the first count_ are valid
    std::size_t count_ = 0;
};

}  // namespace pushfactor::engine
