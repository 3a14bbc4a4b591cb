// Tables of numbers and texts, for CSV files, gnuplot data and pages, and the verdicts in them.
#pragma once

#include <array>
#include <concepts>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace pushfactor::demos {

// A number, a text, or empty.
class Cell {
  public:
    Cell() = default;
    Cell(double number) : number_(number) {}
    Cell(std::integral auto number) : number_(static_cast<double>(number)) {}
    Cell(const std::optional<double>& number) : number_(number) {}
    Cell(std::string text) : text_(std::move(text)) {}
    Cell(std::string_view text) : text_(text) {}
    Cell(const char* text) : text_(text) {}

    double number() const { return number_.value(); }
    std::string exact() const;    // numbers with all their digits
    std::string rounded() const;  // at least three digits; whole numbers are not rounded

  private:
    std::optional<double> number_;
    std::string text_;
};

struct Table {
    std::vector<std::string> columns;  // with units: "time_s"
    std::vector<std::vector<Cell>> rows{};
};

// Lines of cells, of which the first may be a heading.
using TextTable = std::vector<std::vector<std::string>>;

std::string csv_text(const Table& table);  // fields are quoted where necessary

// The rows with all digits of their numbers.
TextTable exact_rows(const Table& table);

// Headings and rounded cells of the named `columns`, by default all.
TextTable page_lines(const Table& table, const std::vector<std::string>& columns = {});

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

// Headings of columns with a format of their own.
inline constexpr const char* command_column = "command";  // folded away, with a button that copies it
inline constexpr const char* verdict_column = "verdict";  // words of Mark, with sign and colour

// A table in a box that scrolls if it is wider than the page. Numbers have four digits; a text equal to the one
// above, like all to its left, is merged with it. `name` labels the table.
std::string table_html(const TextTable& table, const std::string& name);

// A command with a copy button, and with its links to the page that runs the program in a browser, where that has
// been made. `what` describes the command to screen readers.
std::string command_html(std::string_view command, std::string_view what);

// "✓ holds", or "✓ holds: 12".
std::string mark_html(Mark mark, std::optional<int> count = std::nullopt);

// Number of lines per mark.
std::array<int, mark_looks.size()> marks_in(const TextTable& table);

}  // namespace pushfactor::demos
