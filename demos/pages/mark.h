// What a page says at a glance about something that was checked.
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace pushfactor::demos {

enum class Mark {
    holds,
    known_miss,  // not as wanted, but no worse than it is known to be
    fails
};

// A word and a sign, so that colour alone says nothing.
struct MarkLook {
    std::string_view word, sign, style;  // style: a class of page.css
};

inline constexpr std::array mark_looks{MarkLook{"holds", "✓", "holds"}, MarkLook{"known miss", "≈", "known"},
                                       MarkLook{"fails", "✗", "fails"}};

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
