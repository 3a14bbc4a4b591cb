// Lengths on paper, with their unit: "85mm".
#pragma once

#include <optional>
#include <string_view>

namespace pushfactor::demos {

// In millimetres; units are mm, cm, in and pt (1/72 inch). Nothing without a number and a unit.
std::optional<double> parse_length_mm(std::string_view text);

}  // namespace pushfactor::demos
