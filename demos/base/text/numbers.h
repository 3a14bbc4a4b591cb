// Numbers and comma-separated lists from and to text. Equal numbers give equal text; text that is not a number
// gives none.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pushfactor::demos {

// Finite, and from `low` to `high`, both included.
std::optional<double> parse_number(std::string_view text, double low = std::numeric_limits<double>::lowest(),
                                   double high = std::numeric_limits<double>::max());
// The same for a whole number, also as 25.0 or 1e3.
std::optional<int> parse_integer(std::string_view text, int low = std::numeric_limits<int>::min(),
                                 int high = std::numeric_limits<int>::max());

// In millimetres; units are mm, cm, in and pt (1/72 inch). Nothing without a number and a unit.
std::optional<double> parse_length_mm(std::string_view text);

// The shortest text that reads back as the same double.
std::string to_text(double value);

// The parts between commas or another sign, including empty ones; one empty part for an empty text.
std::vector<std::string_view> parts_of(std::string_view text, char between = ',');

}  // namespace pushfactor::demos
