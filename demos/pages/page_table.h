// Tables of a page, and the verdicts in them.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pushfactor::demos {

// The verdict on a check.
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

// Lines of cells; the first is the heading.
using TextTable = std::vector<std::vector<std::string>>;

// Headings of columns with a format of their own.
inline constexpr const char* command_column = "command";  // folded away, with a button that copies it
inline constexpr const char* verdict_column = "verdict";  // words of Mark, with sign and colour

// A table in a box that scrolls if it is wider than the page. Numbers have four digits; a text equal to the one
// above, like all to its left, is merged with it. `name` labels the table.
std::string table_html(const TextTable& table, const std::string& name);

// "✓ holds", or "✓ holds: 12".
std::string mark_html(Mark mark, std::optional<int> count = std::nullopt);

// Number of lines per mark.
std::array<int, mark_looks.size()> marks_in(const TextTable& table);

}  // namespace pushfactor::demos
