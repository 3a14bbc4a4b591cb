// The rows of a step, paper section 5: which source has appended which, so that each gets its own part of the
// solution back (6.2.3).
#pragma once

#include "engine/constraints/constraint_source.h"

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace pushfactor::engine {

class StepRows {
  public:
    // The sources of a world; the same ones throughout a step.
    using Sources = std::span<const std::unique_ptr<ConstraintSource>>;

    // Consecutive rows appended by one source.
    struct Part {
        std::size_t source, begin, end;
    };

    // Replaces all rows by those of a new step.
    void append(Sources sources, const StepStart& step);
    // Appends what ConstraintSource::append_unforeseen() finds missing.
    void append_unforeseen(Sources sources, const StepStart& step, std::span<const Vector6> forces,
                           std::span<const NewForce> changed);

    std::span<const ConstraintRow> all() const { return {rows_.data(), rows_.size()}; }
    std::size_t size() const { return rows_.size(); }
    std::span<const Part> parts() const { return parts_; }

    // For a step that has the same rows in several states: they may be replaced by as many of the same sources.
    RowList& list() { return rows_; }

    // Gives each source the answers of its own rows, in the order in which it has appended them. `answers` has one
    // per row.
    void hand_out(Sources sources, std::span<const Lambda> answers);

  private:
    RowList rows_;
    std::vector<Part> parts_;
    std::vector<Lambda> of_source_;
};

}  // namespace pushfactor::engine
