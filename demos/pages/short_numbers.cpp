#include "demos/pages/short_numbers.h"

#include "demos/base/text/numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <regex>

namespace pushfactor::demos {

namespace {

constexpr int most_digits = 4;

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

// Whether a digit next to `c` is part of a word.
bool is_wordy(char c) {
    return is_digit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

// A number in its parts: "-", "12", ".50", "e+07".
struct Token {
    std::string sign, whole, fraction, exponent;

    std::size_t size() const { return sign.size() + whole.size() + fraction.size() + exponent.size(); }
    std::string mantissa() const { return whole + fraction; }
};

// Whether the number is not part of a name, a version, a date or a range.
bool stands_alone(std::string_view text, std::size_t at, const Token& token) {
    const std::size_t end = at + token.size();
    const auto goes_on = [&text](std::size_t i) { return i < text.size() && is_wordy(text[i]); };
    if (at > 0 && (is_wordy(text[at - 1]) || text[at - 1] == '.')) return false;
    if (at > 1 && text[at - 1] == '-' && is_wordy(text[at - 2])) return false;
    if (at > 0 && !token.sign.empty() && text[at - 1] == ')') return false;
    if (goes_on(end)) return false;
    return end >= text.size() || (text[end] != '.' && text[end] != '-') || !goes_on(end + 1);
}

int significant(const std::string& mantissa) {
    const auto first = mantissa.find_first_not_of("0.");
    if (first == std::string::npos) return 0;
    return static_cast<int>(std::count_if(mantissa.begin() + static_cast<std::ptrdiff_t>(first), mantissa.end(),
                                          [](char c) { return is_digit(c); }));
}

// "1e-06" as "1e-6", "1.5e+07" as "1.5e7".
std::string with_short_exponent(std::string text) {
    const auto at = text.find('e');
    if (at == std::string::npos) return text;
    std::string exponent = text.substr(at + 1);
    const bool negative = exponent.front() == '-';
    exponent.erase(0, std::min(exponent.find_first_not_of("+-0"), exponent.size() - 1));
    return text.substr(0, at + 1) + (negative ? "-" : "") + exponent;
}

std::string rounded(double value, bool keep_zeros) {
    const double size = std::abs(value);
    if (size >= 999.95 && size < 99999.5) return fmt::format("{:.0f}", value);
    std::string text =
        keep_zeros ? fmt::format("{:#.{}g}", value, most_digits) : fmt::format("{:.{}g}", value, most_digits);
    return with_short_exponent(text);
}

std::string short_text(const Token& token, bool in_cell) {
    const std::string mantissa = token.mantissa();
    const std::string text = token.sign + mantissa + token.exponent;
    const int digits = significant(mantissa);
    if (digits == 0) return mantissa;
    const bool whole = token.fraction.empty();
    if (whole && !token.exponent.empty() && digits > 1) return text;  // probably a commit
    const bool long_number = whole ? in_cell && digits > most_digits + 1 : digits > most_digits;
    if (!long_number) return with_short_exponent(text);
    const auto value = parse_number(text);
    return value ? rounded(*value, !in_cell) : text;
}

std::string shortened(std::string_view text, bool in_cell) {
    static const std::regex number(R"((-?)(\d+)(\.\d+)?(e[-+]?\d+)?)");
    std::string result;
    std::size_t end = 0;  // of the number before
    for (std::cregex_iterator i(text.data(), text.data() + text.size(), number), none; i != none; ++i) {
        const std::cmatch& match = *i;
        const Token token{match[1], match[2], match[3], match[4]};
        const auto at = static_cast<std::size_t>(match.position());
        result += text.substr(end, at - end);
        result += stands_alone(text, at, token) ? short_text(token, in_cell) : match.str();
        end = at + token.size();
    }
    return result.append(text.substr(end));
}

}  // namespace

std::string with_short_numbers(std::string_view text) {
    return shortened(text, false);
}

std::string short_cell(std::string_view text) {
    std::string result = shortened(text, true);
    for (const auto& [written, sign] : {std::pair{"<= ", "≤ "}, std::pair{">= ", "≥ "}}) {
        for (auto at = result.find(written); at != std::string::npos; at = result.find(written, at)) {
            result.replace(at, 3, sign);
        }
    }
    return result;
}

}  // namespace pushfactor::demos
