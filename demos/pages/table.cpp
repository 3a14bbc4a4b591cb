#include "demos/pages/table.h"

#include "demos/text/numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pushfactor::demos {

namespace {

std::string csv_field(const std::string& field) {
    if (field.find_first_of(",\"\n") == std::string::npos) return field;
    std::string text = "\"";
    for (const char c : field) text += c == '"' ? "\"\"" : std::string(1, c);
    return text + '"';
}

}  // namespace

std::string Cell::exact() const {
    return number_ ? to_text(*number_) : text_;
}

std::string Cell::rounded() const {
    if (!number_) return text_;
    if (*number_ == 0.0) return "0";
    const double size = std::abs(*number_);
    return size >= 100.0 && size < 1e7 ? fmt::format("{:.0f}", *number_) : fmt::format("{:.3g}", *number_);
}

std::vector<std::vector<std::string>> exact_rows(const Table& table) {
    std::vector<std::vector<std::string>> rows;
    for (const auto& row : table.rows)
        std::ranges::transform(row, std::back_inserter(rows.emplace_back()), &Cell::exact);
    return rows;
}

std::string csv_text(const Table& table) {
    std::string text;
    const auto add = [&text](const std::vector<std::string>& fields) {
        for (std::size_t i = 0; i < fields.size(); ++i) text += (i > 0 ? "," : "") + csv_field(fields[i]);
        text += '\n';
    };
    add(table.columns);
    for (const auto& row : exact_rows(table)) add(row);
    return text;
}

std::vector<std::vector<std::string>> page_lines(const Table& table, const std::vector<std::string>& columns) {
    std::vector<std::vector<std::string>> lines{columns.empty() ? table.columns : columns};
    std::vector<std::size_t> places;
    for (const std::string& name : lines.front()) {
        const auto found = std::find(table.columns.begin(), table.columns.end(), name);
        places.push_back(static_cast<std::size_t>(found - table.columns.begin()));
    }
    for (std::string& heading : lines.front()) std::replace(heading.begin(), heading.end(), '_', ' ');
    for (const auto& row : table.rows) {
        std::vector<std::string>& line = lines.emplace_back();
        for (const std::size_t i : places) line.push_back(row.at(i).rounded());
    }
    return lines;
}

}  // namespace pushfactor::demos
