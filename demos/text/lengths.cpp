#include "demos/text/lengths.h"

#include "demos/text/numbers.h"

#include <array>
#include <utility>

namespace pushfactor::demos {

std::optional<double> parse_length_mm(std::string_view text) {
    constexpr std::array<std::pair<std::string_view, double>, 4> units{
        {{"mm", 1.0}, {"cm", 10.0}, {"in", 25.4}, {"pt", 25.4 / 72.0}}};
    for (const auto& [unit, millimetres] : units) {
        if (!text.ends_with(unit)) continue;
        const auto number = parse_number(text.substr(0, text.size() - unit.size()));
        if (number) return *number * millimetres;
    }
    return std::nullopt;
}

}  // namespace pushfactor::demos
