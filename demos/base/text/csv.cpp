#include "demos/base/text/csv.h"

#include "demos/base/text/errors.h"
#include "demos/base/text/input.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <sstream>

namespace pushfactor::demos {

std::vector<std::string> csv_cells(const std::string& line) {
    std::vector<std::string> cells(1);
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const char c = line[i];
        if (c == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"') {
            cells.back() += line[++i];  // doubled: one of the text
        } else if (c == '"') {
            quoted = !quoted;
        } else if (c == ',' && !quoted) {
            cells.emplace_back();
        } else {
            cells.back() += c;
        }
    }
    return cells;
}

std::vector<std::vector<std::string>> read_csv(const std::string& option, const std::filesystem::path& file,
                                               const std::vector<std::string>& columns) {
    const auto refuse = [&](const std::string& what) {
        throw UsageError("{} {}: {}", option, file.string(), what);
    };
    std::istringstream stream(read_input(file, fmt::format("{} {}", option, file.string())));
    std::vector<std::vector<std::string>> rows;
    bool headed = false;
    std::string line;
    for (int number = 1; std::getline(stream, line); ++number) {
        if (line.starts_with("#")) continue;
        std::vector<std::string> cells = csv_cells(line);
        const bool heading = cells.front() == columns.front();
        if (!headed || heading) {
            if (cells != columns) refuse(fmt::format("line {}: must be {}", number, fmt::join(columns, ",")));
            headed = true;
            continue;
        }
        if (cells.size() != columns.size()) {
            refuse(fmt::format("line {}: must have {} cells, not {}", number, columns.size(), cells.size()));
        }
        rows.push_back(std::move(cells));
    }
    if (!headed) refuse(fmt::format("must begin with {}", fmt::join(columns, ",")));
    return rows;
}

}  // namespace pushfactor::demos
