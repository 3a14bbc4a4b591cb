// Exact fractions for times: 1/60 s is no decimal number, and frame n must show exactly t = n / fps.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace pushfactor::demos {

struct Rational {
    std::int64_t numerator = 0;
    std::int64_t denominator = 1;  // above 0, no common factor with the numerator

    double value() const { return static_cast<double>(numerator) / static_cast<double>(denominator); }
    bool is_whole() const { return denominator == 1; }

    friend bool operator==(const Rational&, const Rational&) = default;
};

// In lowest terms; `denominator` must not be 0.
Rational make_rational(std::int64_t numerator, std::int64_t denominator);

// Exact; throws std::overflow_error if a term does not fit into 64 bits.
Rational operator*(const Rational& a, const Rational& b);
Rational operator/(const Rational& a, const Rational& b);
Rational operator+(const Rational& a, const Rational& b);

// Parses "1/60", "0.02", "3" or "1e-3". None if the text is not such a number or has too many digits to be exact.
std::optional<Rational> parse_rational(std::string_view text);

// "1/60", or "0.5" and "3" where that is exact.
std::string to_text(const Rational& value);

}  // namespace pushfactor::demos
