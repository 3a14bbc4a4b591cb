// The rows of a step, paper section 5: which source has appended which, so that each gets its own part of the
// solution back (6.2.3).
#pragma once

#include "engine/constraints/constraint_source.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace pushfactor::engine {

// Which source has appended a row, for those that follow the bodies in small steps.
class RowSources {
  public:
    using Sources = std::span<const std::unique_ptr<ConstraintSource>>;

    // Consecutive rows appended by one source.
    struct Part {
        std::size_t source, begin, end;
    };

    RowSources() = default;  // none follows
    RowSources(Sources sources, std::span<const Part> parts)
        : sources_(sources), parts_(parts), any_(std::ranges::any_of(sources, &ConstraintSource::can_follow)) {}

    // The source of this row of the step; null if its rows keep their axes.
    const ConstraintSource* follower_of(int row) const {
        if (!any_) return nullptr;
        for (const Part& part : parts_) {
            const auto own = static_cast<std::size_t>(row);
            if (own < part.begin || own >= part.end) continue;
            const ConstraintSource& source = *sources_[part.source];
            return source.can_follow() ? &source : nullptr;
        }
        return nullptr;
    }

  private:
    Sources sources_{};
    std::span<const Part> parts_{};
    bool any_ = false;
};

class StepRows {
  public:
    // The sources of a world; the same ones throughout a step.
    using Sources = RowSources::Sources;
    using Part = RowSources::Part;

    // Replaces all rows by those of a new step.
    void append(Sources sources, const StepStart& step);
    // Appends what ConstraintSource::append_unforeseen() finds missing.
    void append_unforeseen(Sources sources, const StepStart& step, std::span<const Vector6> forces,
                           std::span<const char> changed);

    std::span<const ConstraintRow> all() const { return {rows_.data(), rows_.size()}; }
    std::size_t size() const { return rows_.size(); }
    std::span<const Part> parts() const { return parts_; }
    RowSources sources_of(Sources sources) const { return {sources, parts_}; }

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
