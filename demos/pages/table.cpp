#include "demos/pages/table.h"

#include "demos/base/platform/assets.h"
#include "demos/base/text/html.h"
#include "demos/base/text/numbers.h"
#include "demos/pages/short_numbers.h"
#include "demos/pictures/live/links.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iomanip>
#include <sstream>

namespace pushfactor::demos {

namespace {

std::string csv_field(const std::string& field) {
    if (field.find_first_of(",\"\n") == std::string::npos) return field;
    return (std::ostringstream() << std::quoted(field, '"', '"')).str();
}

// Longest text that is not wrapped [characters].
constexpr std::size_t long_text = 36;

// "1.5", and "<= 1.5" too.
bool is_number(std::string_view text) {
    if (text.starts_with("<= ") || text.starts_with(">= ")) text.remove_prefix(3);
    return parse_number(text).has_value();
}

// The table without empty columns, and with lines of equal length.
TextTable without_empty_columns(const TextTable& table) {
    TextTable result(table.size());
    for (std::size_t column = 0; column < table.front().size(); ++column) {
        const auto says_something = [column](const auto& line) {
            return column < line.size() && !line[column].empty();
        };
        if (table.size() > 1 && std::none_of(table.begin() + 1, table.end(), says_something)) continue;
        for (std::size_t line = 0; line < table.size(); ++line)
            result[line].push_back(column < table[line].size() ? table[line][column] : "");
    }
    return result;
}

class TableWriter {
  public:
    TableWriter(const TextTable& table, const std::string& name)
        : table_(without_empty_columns(table)), name_(name) {
        const auto& heading = table_.front();
        for (std::size_t column = 0; column < heading.size(); ++column) {
            columns_.push_back({.verdict = heading[column] == verdict_column,
                                .command = heading[column] == command_column,
                                .numeric = is_numeric(column)});
        }
        const auto naming = std::ranges::find_if(columns_, [](const Column& c) { return c.is_text(); });
        naming_ = static_cast<std::size_t>(naming - columns_.begin());
    }

    std::string html() const {
        std::string text = fmt::format(
            "<div class=\"scroll\" role=\"region\" tabindex=\"0\" aria-label=\"Table: "
            "{}\">\n<table>\n<thead>\n<tr>",
            html::escaped(name_));
        for (std::size_t column = 0; column < columns_.size(); ++column) {
            const char* const style = columns_[column].numeric ? " class=\"number\""
                                      : column == naming_      ? " class=\"name\""
                                                               : "";
            text += fmt::format("<th scope=\"col\"{}>{}</th>", style, html::escaped(table_.front()[column]));
        }
        text += "</tr>\n</thead>\n<tbody>\n";
        for (std::size_t line = 1; line < table_.size(); ++line) {
            text += "<tr>";
            for (std::size_t column = 0; column < columns_.size(); ++column) text += cell(line, column);
            text += "</tr>\n";
        }
        return text + "</tbody>\n</table>\n</div>\n";
    }

  private:
    struct Column {
        bool verdict = false, command = false, numeric = false;

        bool is_text() const { return !verdict && !command && !numeric; }
    };

    const std::string& at(std::size_t line, std::size_t column) const { return table_[line][column]; }

    bool is_numeric(std::size_t column) const {
        std::size_t numbers = 0, texts = 0;
        for (std::size_t line = 1; line < table_.size(); ++line) {
            if (!at(line, column).empty()) ++(is_number(at(line, column)) ? numbers : texts);
        }
        return numbers > texts;
    }

    // Whether the cell is merged with the one above.
    bool repeats(std::size_t line, std::size_t column) const {
        const Column& own = columns_[column];
        if (line < 2 || own.verdict || own.numeric || at(line, column) != at(line - 1, column)) return false;
        if (own.command) return true;
        for (std::size_t left = 0; left < column; ++left) {
            if (columns_[left].verdict || columns_[left].command) continue;
            if (columns_[left].numeric || at(line, left) != at(line - 1, left)) return false;
        }
        return true;
    }

    std::string cell(std::size_t line, std::size_t column) const {
        if (repeats(line, column)) return "";
        std::size_t lines = 1;
        while (line + lines < table_.size() && repeats(line + lines, column)) ++lines;
        const std::string& text = at(line, column);
        const Column& own = columns_[column];
        std::string attributes = lines > 1 ? fmt::format(" rowspan=\"{}\"", lines) : "";
        if (own.command) return fmt::format("<td{}>{}</td>", attributes, folded(line, text));
        if (const auto mark = mark_of(text); own.verdict && mark)
            return fmt::format("<td{}>{}</td>", attributes, mark_html(*mark));
        if (own.numeric) attributes += " class=\"number\"";
        const std::string shown = short_cell(text);
        if (!own.numeric && shown.size() > long_text) attributes += " class=\"long\"";
        return column == naming_ ? fmt::format("<th scope=\"row\"{}>{}</th>", attributes, html::escaped(shown))
                                 : fmt::format("<td{}>{}</td>", attributes, html::escaped(shown));
    }

    std::string folded(std::size_t line, const std::string& command) const {
        if (command.empty()) return "";
        std::string what = naming_ < columns_.size() ? at(line, naming_) : name_;
        if (const std::size_t next = naming_ + 1; next < columns_.size() && columns_[next].is_text())
            what += ", " + at(line, next);
        return fmt::format("<details><summary>show</summary>{}</details>", command_html(command, what));
    }

    const TextTable table_;
    const std::string& name_;
    std::vector<Column> columns_;
    std::size_t naming_ = 0;  // column with the names of the lines
};

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

TextTable exact_rows(const Table& table) {
    TextTable rows;
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

TextTable page_lines(const Table& table, const std::vector<std::string>& columns) {
    TextTable lines{columns.empty() ? table.columns : columns};
    std::vector<std::size_t> places;
    for (const std::string& name : lines.front()) {
        const auto found = std::ranges::find(table.columns, name);
        places.push_back(static_cast<std::size_t>(found - table.columns.begin()));
    }
    for (std::string& heading : lines.front()) std::replace(heading.begin(), heading.end(), '_', ' ');
    for (const auto& row : table.rows) {
        std::vector<std::string>& line = lines.emplace_back();
        for (const std::size_t i : places) line.push_back(row.at(i).rounded());
    }
    return lines;
}

std::string table_html(const TextTable& table, const std::string& name) {
    return table.empty() ? "" : TableWriter(table, name).html();
}

std::string command_html(std::string_view command, std::string_view what) {
    std::string live;
    if (std::filesystem::exists(live_page())) {
        for (const pictures::live::PageLink& link : pictures::live::page_links(command)) {
            live += fmt::format(" · <a href=\"{}\">In the browser{}</a>", html::escaped(link.address),
                                link.differs.empty() ? "" : ", " + html::escaped(link.differs));
        }
    }
    return fmt::format(
        "<div class=\"command\"><code>{}</code><button type=\"button\" class=\"copy\" hidden aria-label=\"Copy the "
        "command: {}\">Copy</button></div>{}",
        html::escaped(command), html::escaped(what),
        live.empty() ? "" : "<p class=\"files\">" + live.substr(std::string_view(" · ").size()) + "</p>");
}

std::string mark_html(Mark mark, std::optional<int> count) {
    const MarkLook& look = mark_looks[static_cast<std::size_t>(mark)];
    return fmt::format(
        "<span class=\"verdict {}\"><span aria-hidden=\"true\">{}</span> <span class=\"word\">{}{}</span>{}</span>",
        look.style, look.sign, look.word, count ? ": " : "", count ? std::to_string(*count) : "");
}

std::array<int, mark_looks.size()> marks_in(const TextTable& table) {
    std::array<int, mark_looks.size()> counts{};
    if (table.empty()) return counts;
    const auto found = std::ranges::find(table.front(), verdict_column);
    const auto column = static_cast<std::size_t>(found - table.front().begin());
    for (std::size_t line = 1; line < table.size(); ++line) {
        if (column >= table[line].size()) continue;
        if (const auto mark = mark_of(table[line][column])) ++counts[static_cast<std::size_t>(*mark)];
    }
    return counts;
}

}  // namespace pushfactor::demos
