#include "demos/base/text/rational.h"

#include <charconv>
#include <cstdlib>
#include <numeric>
#include <stdexcept>

namespace pushfactor::demos {

namespace {

std::int64_t product(std::int64_t a, std::int64_t b) {
    std::int64_t result = 0;
    if (__builtin_mul_overflow(a, b, &result)) throw std::overflow_error("a fraction with too many digits");
    return result;
}

std::optional<std::int64_t> parse_whole(std::string_view text) {
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return value;
}

std::optional<Rational> parse_decimal(std::string_view text) {
    std::int64_t exponent = 0;
    if (const auto e = text.find_first_of("eE"); e != std::string_view::npos) {
        std::string_view power = text.substr(e + 1);
        if (power.starts_with('+')) power.remove_prefix(1);
        const auto parsed = parse_whole(power);
        if (!parsed || std::abs(*parsed) > 18) return std::nullopt;
        exponent = *parsed;
        text = text.substr(0, e);
    }
    std::string digits(text);
    if (const auto point = digits.find('.'); point != std::string::npos) {
        exponent -= static_cast<std::int64_t>(digits.size() - point - 1);
        digits.erase(point, 1);
    }
    const auto mantissa = parse_whole(digits);
    if (!mantissa) return std::nullopt;
    Rational value = make_rational(*mantissa, 1);
    for (; exponent > 0; --exponent) value = value * Rational{10, 1};
    for (; exponent < 0; ++exponent) value = value / Rational{10, 1};
    return value;
}

}  // namespace

Rational make_rational(std::int64_t numerator, std::int64_t denominator) {
    const std::int64_t divisor = std::gcd(numerator, denominator);
    const std::int64_t sign = denominator < 0 ? -1 : 1;
    return {sign * numerator / divisor, sign * denominator / divisor};
}

Rational operator*(const Rational& a, const Rational& b) {
    // Cross-cancel first, so that only a result that is too large overflows.
    const Rational left = make_rational(a.numerator, b.denominator);
    const Rational right = make_rational(b.numerator, a.denominator);
    return {product(left.numerator, right.numerator), product(left.denominator, right.denominator)};
}

Rational operator+(const Rational& a, const Rational& b) {
    std::int64_t sum = 0;
    if (__builtin_add_overflow(product(a.numerator, b.denominator), product(b.numerator, a.denominator), &sum)) {
        throw std::overflow_error("a fraction with too many digits");
    }
    return make_rational(sum, product(a.denominator, b.denominator));
}

Rational operator/(const Rational& a, const Rational& b) {
    return a * make_rational(b.denominator, b.numerator);
}

std::optional<Rational> parse_rational(std::string_view text) {
    try {
        if (const auto slash = text.find('/'); slash != std::string_view::npos) {
            const auto numerator = parse_whole(text.substr(0, slash));
            const auto denominator = parse_whole(text.substr(slash + 1));
            if (!numerator || !denominator || *denominator <= 0) return std::nullopt;
            return make_rational(*numerator, *denominator);
        }
        return parse_decimal(text);
    } catch (const std::overflow_error&) {
        return std::nullopt;
    }
}

std::string to_text(const Rational& value) {
    if (value.is_whole()) return std::to_string(value.numerator);
    // A decimal when the denominator divides a power of ten that is short to read.
    for (std::int64_t power = 10; power <= 1'000'000; power *= 10) {
        if (power % value.denominator != 0) continue;
        const std::int64_t scaled = product(std::abs(value.numerator), power / value.denominator);
        std::string fraction = std::to_string(power + scaled % power).substr(1);
        return (value.numerator < 0 ? "-" : "") + std::to_string(scaled / power) + "." + fraction;
    }
    return std::to_string(value.numerator) + "/" + std::to_string(value.denominator);
}

}  // namespace pushfactor::demos
