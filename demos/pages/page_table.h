// A table of a page.
#pragma once

#include "demos/pages/mark.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace pushfactor::demos {

// Lines of texts; the first is the heading.
using TextTable = std::vector<std::vector<std::string>>;

// Headings of columns that are shown in a way of their own.
inline constexpr const char* command_column = "command";  // folded away, with a button that copies it
inline constexpr const char* verdict_column = "verdict";  // words of mark.h, with sign and colour

// In a box of its own, in which it scrolls where it is wider than the page. Numbers have four digits; a text that
// only repeats the line above, like all to its left, is one cell with it. `name` says what the table is of.
std::string table_html(const TextTable& table, const std::string& name);

// "✓ holds", or "✓ holds: 12".
std::string mark_html(Mark mark, std::optional<int> count = std::nullopt);

// How many lines have each mark.
std::array<int, mark_looks.size()> marks_in(const TextTable& table);

}  // namespace pushfactor::demos
