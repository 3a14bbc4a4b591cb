// Arithmetic with twice the digits of a double, some 32 decimal ones: the same bits on every machine, which `long
// double` is not. After Dekker, Numer. Math. 18 (1971), and Knuth, TAOCP 2, 4.2.2. No part of a product may be
// beyond 2^900 or below 2^-900.
#pragma once

#include <cmath>

namespace pushfactor::engine {

// The unrounded sum of two numbers; `high` is what it rounds to.
struct Wide {
    double high = 0.0, low = 0.0;

    constexpr Wide() = default;
    constexpr Wide(double value) : high(value) {}  // NOLINT(google-explicit-constructor): a wider number
    constexpr Wide(double of_high, double of_low) : high(of_high), low(of_low) {}
    explicit operator double() const { return high; }
};

// a + b for |a| >= |b| or a = 0.
inline Wide fast_sum(double a, double b) {
    const double sum = a + b;
    return {sum, b - (sum - a)};
}

inline Wide exact_sum(double a, double b) {
    const double sum = a + b, part = sum - a;
    return {sum, (a - (sum - part)) + (b - part)};
}

// x as a sum of two numbers of 26 bits (Veltkamp).
inline Wide halves(double x) {
    const double wide = (0x1p27 + 1.0) * x, high = wide - (wide - x);
    return {high, x - high};
}

inline Wide exact_product(double a, double b) {
    const Wide of_a = halves(a), of_b = halves(b);
    const double product = a * b;
    return {product, ((of_a.high * of_b.high - product) + of_a.high * of_b.low + of_a.low * of_b.high) +
                         of_a.low * of_b.low};
}

inline Wide exact_square(double a) {
    const Wide parts = halves(a);
    const double square = a * a;
    return {square, ((parts.high * parts.high - square) + 2.0 * parts.high * parts.low) + parts.low * parts.low};
}

inline Wide operator-(const Wide& a) {
    return {-a.high, -a.low};
}

inline Wide operator+(const Wide& a, const Wide& b) {
    const Wide high = exact_sum(a.high, b.high), low = exact_sum(a.low, b.low);
    const Wide sum = fast_sum(high.high, high.low + low.high);
    return fast_sum(sum.high, sum.low + low.low);
}

inline Wide operator-(const Wide& a, const Wide& b) {
    return a + -b;
}

inline Wide operator*(const Wide& a, const Wide& b) {
    const Wide product = exact_product(a.high, b.high);
    return fast_sum(product.high, product.low + (a.high * b.low + a.low * b.high));
}

inline Wide operator/(const Wide& a, const Wide& b) {
    const double first = a.high / b.high;
    const Wide rest = a - b * first;
    const double second = rest.high / b.high;
    const double third = (rest - b * second).high / b.high;
    return fast_sum(first, second) + third;
}

inline Wide& operator+=(Wide& a, const Wide& b) {
    return a = a + b;
}

}  // namespace pushfactor::engine
