// Columns of numbers, as a CSV file.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace pushfactor::demos::figures {

struct Table {
    std::vector<std::string> columns;                      // with units: "time_s"
    std::vector<std::vector<std::optional<double>>> rows;  // empty where there is nothing to say
};

std::string csv_text(const Table& table);

}  // namespace pushfactor::demos::figures
