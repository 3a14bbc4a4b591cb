#include "demos/base/text/numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

namespace pushfactor::demos {

std::optional<double> parse_number(std::string_view text, double low, double high) {
    if (text.starts_with('+')) text.remove_prefix(1);
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool is_whole_text = error == std::errc{} && end == text.data() + text.size();
    return is_whole_text && value >= low && value <= high ? std::optional(value) : std::nullopt;
}

std::optional<int> parse_integer(std::string_view text, int low, int high) {
    const auto value = parse_number(text, low, high);
    return value && *value == std::trunc(*value) ? std::optional(static_cast<int>(*value)) : std::nullopt;
}

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

std::string to_text(double value) {
    return fmt::format("{}", value);
}

std::vector<std::string_view> parts_of(std::string_view text, char between) {
    std::vector<std::string_view> parts;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(between, begin), text.size());
        parts.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return parts;
}

}  // namespace pushfactor::demos
