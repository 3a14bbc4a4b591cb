#include "engine/step/step_rows.h"

namespace pushfactor::engine {

void StepRows::append(Sources sources, const StepStart& step) {
    rows_.clear();
    parts_.clear();
    for (std::size_t s = 0; s < sources.size(); ++s) {
        const std::size_t begin = rows_.size();
        sources[s]->append_rows(step, rows_);
        parts_.push_back({s, begin, rows_.size()});
    }
}

void StepRows::append_unforeseen(Sources sources, const StepStart& step, std::span<const Vector6> forces,
                                 std::span<const char> changed) {
    for (std::size_t s = 0; s < sources.size(); ++s) {
        const std::size_t begin = rows_.size();
        sources[s]->append_unforeseen(step, forces, changed, rows_);
        if (rows_.size() > begin) parts_.push_back({s, begin, rows_.size()});
    }
}

void StepRows::hand_out(Sources sources, std::span<const Lambda> answers) {
    const bool one_part_each = parts_.size() == sources.size();
    for (std::size_t s = 0; s < sources.size(); ++s) {
        const Part& first = parts_[s];
        if (one_part_each) {
            sources[s]->remember(answers.subspan(first.begin, first.end - first.begin));
            continue;
        }
        of_source_.clear();
        for (const Part& part : parts_) {
            if (part.source != s) continue;
            const auto own = answers.subspan(part.begin, part.end - part.begin);
            of_source_.insert(of_source_.end(), own.begin(), own.end());
        }
        sources[s]->remember(of_source_);
    }
}

}  // namespace pushfactor::engine
