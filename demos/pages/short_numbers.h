// Rounded numbers: files keep all digits, pages show four.
#pragma once

#include <string>
#include <string_view>

namespace pushfactor::demos {

// The text with its numbers rounded to four significant digits: "0.30000000000000004" becomes "0.3000", "1e-06"
// "1e-6" and "-0.0" "0.0". Numbers that are part of a name, a version or a range stay as they are, and so do whole
// numbers.
std::string with_short_numbers(std::string_view text);

// The same for a cell of a table, where a whole number of more than five digits is rounded too ("1.235e6"), zeros
// at the end of a rounded number are left out, and "<=" becomes one character.
std::string short_cell(std::string_view text);

}  // namespace pushfactor::demos
