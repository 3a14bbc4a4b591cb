// Files of measured numbers in assets/measured.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pushfactor::demos::reports::reality {

// The lines of a CSV file of numbers below its heading, which has to be `columns`; a file that ends in .gz is
// decompressed. Throws RunError for a missing or damaged file.
std::vector<std::vector<double>> numbers_of(const std::filesystem::path& file, const std::string& columns);

}  // namespace pushfactor::demos::reports::reality
