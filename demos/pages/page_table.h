// Tables of a page.
#pragma once

#include "demos/pages/mark.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace pushfactor::demos {

// Lines of cells; the first is the heading.
using TextTable = std::vector<std::vector<std::string>>;

// Headings of columns with a format of their own.
inline constexpr const char* command_column = "command";  // folded away, with a button that copies it
inline constexpr const char* verdict_column = "verdict";  // words of mark.h, with sign and colour

// A table in a box that scrolls if it is wider than the page. Numbers have four digits; a text equal to the one
// above, like all to its left, is merged with it. `name` labels the table.
std::string table_html(const TextTable& table, const std::string& name);

// "✓ holds", or "✓ holds: 12".
std::string mark_html(Mark mark, std::optional<int> count = std::nullopt);

// Number of lines per mark.
std::array<int, mark_looks.size()> marks_in(const TextTable& table);

}  // namespace pushfactor::demos
