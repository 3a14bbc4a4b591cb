// What Debian 12's Emscripten needs before every file: LLVM 14 and its standard library. Nothing with newer ones.
#pragma once

#include <version>

#if defined(__clang__) && __clang_major__ < 15

#include <emmintrin.h>

// LLVM 14 reads a number that fills both lanes from memory anew, after what has been stored there since.
inline __m128d both_lanes(double x) {
    asm("" : "+r"(x));
    return _mm_set1_pd(x);
}
#define _mm_set1_pd both_lanes

#endif

// In as much as this project uses it.
#if defined(_LIBCPP_VERSION) && _LIBCPP_VERSION < 15000

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <iterator>
#include <string>

_LIBCPP_BEGIN_NAMESPACE_STD

template <typename To, typename From>
To bit_cast(const From& from) noexcept {
    static_assert(sizeof(To) == sizeof(From));
    To to;
    std::memcpy(&to, &from, sizeof(To));
    return to;
}

// The shortest text that reads as the same number. C's functions follow the locale, of which a page has one.
inline to_chars_result to_chars(char* first, char* last, double value) {
    char text[32];
    int length = 0;
    for (int digits = 1; digits <= 17; ++digits) {
        length = std::snprintf(text, sizeof text, "%.*g", digits, value);
        if (std::strtod(text, nullptr) == value) break;
    }
    if (last - first < length) return {last, errc::value_too_large};
    return {std::copy_n(text, length, first), errc{}};
}

inline from_chars_result from_chars(const char* first, const char* last, double& value) {
    const string text(first, last);
    // strtod takes more than from_chars: spaces, a plus, hexadecimal numbers.
    if (text.empty() || text.find_first_of(" \t\n\v\f\r+xX") == 0 || text.find_first_of("xX") != string::npos) {
        return {first, errc::invalid_argument};
    }
    char* end = nullptr;
    const double read = std::strtod(text.c_str(), &end);
    if (end == text.c_str()) return {first, errc::invalid_argument};
    value = read;
    return {first + (end - text.c_str()), errc{}};
}

namespace ranges {

template <typename Range, typename Predicate, typename Projection = identity>
bool any_of(Range&& range, Predicate is, Projection of = {}) {
    return std::any_of(range.begin(), range.end(),
                       [&](auto&& one) { return std::invoke(is, std::invoke(of, one)); });
}

template <typename Range, typename Predicate, typename Projection = identity>
bool none_of(Range&& range, Predicate is, Projection of = {}) {
    return !ranges::any_of(range, is, of);
}

template <typename Range, typename Function>
void for_each(Range&& range, Function visit) {
    std::for_each(range.begin(), range.end(), visit);
}

template <typename A, typename B, typename Same = equal_to, typename OfA = identity, typename OfB = identity>
bool equal(A&& a, B&& b, Same same = {}, OfA of_a = {}, OfB of_b = {}) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [&](auto&& x, auto&& y) {
        return std::invoke(same, std::invoke(of_a, x), std::invoke(of_b, y));
    });
}

template <typename Range, typename Value, typename Projection = identity>
auto find(Range&& range, const Value& value, Projection of = {}) {
    return std::find_if(range.begin(), range.end(), [&](auto&& one) { return std::invoke(of, one) == value; });
}

template <typename Range, typename Less = less, typename Projection = identity>
auto lower_bound(Range&& range, const auto& value, Less before = {}, Projection of = {}) {
    return std::lower_bound(range.begin(), range.end(), value, [&](auto&& one, auto&& other) {
        return std::invoke(before, std::invoke(of, one), other);
    });
}

template <typename Range, typename Less = less, typename Projection = identity>
auto upper_bound(Range&& range, const auto& value, Less before = {}, Projection of = {}) {
    return std::upper_bound(range.begin(), range.end(), value, [&](auto&& other, auto&& one) {
        return std::invoke(before, other, std::invoke(of, one));
    });
}

template <typename Range, typename Less = less, typename Projection = identity>
auto min_element(Range&& range, Less before = {}, Projection of = {}) {
    return std::min_element(range.begin(), range.end(), [&](auto&& one, auto&& other) {
        return std::invoke(before, std::invoke(of, one), std::invoke(of, other));
    });
}

template <typename Range, typename Less = less, typename Projection = identity>
auto max_element(Range&& range, Less before = {}, Projection of = {}) {
    return std::max_element(range.begin(), range.end(), [&](auto&& one, auto&& other) {
        return std::invoke(before, std::invoke(of, one), std::invoke(of, other));
    });
}

template <typename Range, typename Less = less, typename Projection = identity>
auto min(Range&& range, Less before = {}, Projection of = {}) {
    return *ranges::min_element(range, before, of);
}

template <typename Range>
void sort(Range&& range) {
    std::sort(range.begin(), range.end());
}

}  // namespace ranges

_LIBCPP_END_NAMESPACE_STD

#endif
