// Reading tables of CSV files; pages/table.h writes them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pushfactor::demos {

// The cells of one line; they may be in quotes.
std::vector<std::string> csv_cells(const std::string& line);

// The lines below the heading, which has to be `columns`. Lines that begin with # are left out; the heading may
// come again, so files can be joined. Throws UsageError, which begins with `option`, names the line and what it
// must be.
std::vector<std::vector<std::string>> read_csv(const std::string& option, const std::filesystem::path& file,
                                               const std::vector<std::string>& columns);

}  // namespace pushfactor::demos
