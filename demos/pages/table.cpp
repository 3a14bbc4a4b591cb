#include "demos/pages/table.h"

#include "demos/text/numbers.h"

#include <fmt/ranges.h>

namespace pushfactor::demos::figures {

std::string csv_text(const Table& table) {
    std::string text = fmt::format("{}\n", fmt::join(table.columns, ","));
    for (const auto& row : table.rows) {
        for (std::size_t i = 0; i < row.size(); ++i) {
            if (i > 0) text += ',';
            if (row[i]) text += to_text(*row[i]);
        }
        text += '\n';
    }
    return text;
}

}  // namespace pushfactor::demos::figures
