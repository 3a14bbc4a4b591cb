#include "tests/peers/table.h"

#include <fmt/format.h>

#include <cmath>
#include <ostream>

namespace pushfactor::tests::peers {

namespace {

std::string cell(const Value& value) {
    if (!value.text.empty()) return value.text;
    if (!std::isfinite(value.number)) return "-";
    const double size = std::abs(value.number);
    return size >= 1e3 && size < 1e7 ? fmt::format("{:.0f}", value.number) : fmt::format("{:.3g}", value.number);
}

}  // namespace

void write_markdown(std::ostream& out, const Case& of, const std::vector<Line>& lines) {
    if (lines.empty()) return;
    out << "\n### " << of.title << "\n\n| engine | setting |";
    for (const Value& value : lines.front().values) out << ' ' << value.name << " |";
    out << "\n|---|---|";
    for (std::size_t i = 0; i < lines.front().values.size(); ++i) out << "---|";
    out << '\n';
    for (const Line& line : lines) {
        out << "| " << line.engine << " | " << line.setting << " |";
        for (const Value& value : line.values) out << ' ' << cell(value) << " |";
        out << '\n';
    }
    out.flush();
}

void write_csv_header(std::ostream& out) {
    out << "case,engine,setting,measure,value,text\n";
}

void write_csv(std::ostream& out, const Case& of, const std::vector<Line>& lines) {
    for (const Line& line : lines) {
        for (const Value& value : line.values)
            out << fmt::format("{},{},\"{}\",\"{}\",{:.9g},{}\n", of.name, line.engine, line.setting, value.name,
                               value.number, value.text);
    }
}

}  // namespace pushfactor::tests::peers
