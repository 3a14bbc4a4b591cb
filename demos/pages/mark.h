// The verdict on a check, as shown on pages.
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace pushfactor::demos {

enum class Mark {
    holds,
    known_miss,  // misses the bar, but no worse than known
    fails,
    not_compared
};

// A word and a sign, so that the verdict does not depend on colour.
struct MarkLook {
    std::string_view word, sign, style;  // style: a class of page.css
};

inline constexpr std::array mark_looks{MarkLook{"holds", "✓", "holds"}, MarkLook{"known miss", "≈", "known"},
                                       MarkLook{"fails", "✗", "fails"}, MarkLook{"not compared", "–", "known"}};

inline std::string_view word_of(Mark mark) {
    return mark_looks[static_cast<std::size_t>(mark)].word;
}

inline std::optional<Mark> mark_of(std::string_view word) {
    for (std::size_t i = 0; i < mark_looks.size(); ++i) {
        if (mark_looks[i].word == word) return static_cast<Mark>(i);
    }
    return std::nullopt;
}

}  // namespace pushfactor::demos
