#include "demos/text/numbers.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace pushfactor::demos {

namespace {

template <typename Number>
std::optional<Number> parse(std::string_view text) {
    if (text.starts_with('+')) text.remove_prefix(1);
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return value;
}

}  // namespace

std::optional<double> parse_number(std::string_view text) {
    const auto value = parse<double>(text);
    return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<int> parse_integer(std::string_view text) {
    return parse<int>(text);
}

std::string to_text(double value) {
    return fmt::format("{}", value);
}

}  // namespace pushfactor::demos
