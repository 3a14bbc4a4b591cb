// A table of numbers and texts, for CSV files, gnuplot data and pages.
#pragma once

#include <concepts>
#include <optional>
#include <string>
#include <string_view>
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

std::string csv_text(const Table& table);  // fields are quoted where necessary

// The rows with all digits of their numbers.
std::vector<std::vector<std::string>> exact_rows(const Table& table);

// Headings and rounded cells of the named `columns`, by default all.
std::vector<std::vector<std::string>> page_lines(const Table& table, const std::vector<std::string>& columns = {});

}  // namespace pushfactor::demos
