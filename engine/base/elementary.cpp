#include "engine/base/elementary.h"

#include "engine/base/wide.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

// Each function reduces its argument until few terms of a Taylor series suffice, and keeps what the last rounding
// but one would lose in a second number: a value is the unrounded sum `high + low`.

namespace pushfactor::engine::elementary {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double inf = std::numeric_limits<double>::infinity();

// Rounds |x| < 2^51 to an integer.
double nearest(double x) {
    constexpr double integers_only = 0x1.8p52;
    return (x + integers_only) - integers_only;
}

// c_0 + c_1 z + ..., even and odd powers apart, which processors work on side by side.
template <std::size_t n>
double polynomial(double z, const std::array<double, n>& c) {
    static_assert(n % 2 == 0);
    const double square = z * z;
    double even = c[n - 2], odd = c[n - 1];
    for (std::size_t i = n - 2; i > 0; i -= 2) {
        even = even * square + c[i - 2];
        odd = odd * square + c[i - 1];
    }
    return even + odd * z;
}

// 1 / n! for n = from, from + step, ..., the first times `sign`; with a step of two of alternating sign.
template <std::size_t terms>
consteval std::array<double, terms> inverse_factorials(int from, int step, double sign) {
    std::array<double, terms> result{};
    double factorial = 1.0;  // exact up to 22!
    int n = 1;
    for (std::size_t i = 0; i < terms; ++i) {
        for (; n < from + step * static_cast<int>(i); ++n) factorial *= n + 1;
        result[i] = sign / factorial;
        if (step == 2) sign = -sign;
    }
    return result;
}

// x = quarters pi/2 + angle, |angle| <= pi/4.
struct Reduced {
    Wide angle;
    int quarters;
};

Reduced reduce(double x) {
    constexpr double quarter = 0x1.921fb54442d18p+0;
    if (!(std::abs(x) <= 0x1p20)) {
        x = std::remainder(x, 4.0 * quarter);
        if (std::isnan(x)) return {{nan, 0.0}, 0};
    }
    if (std::abs(x) <= 0.5 * quarter) return {{x, 0.0}, 0};
    // pi/2 in parts of 33 bits, whose products with up to 20 bits are exact, and a rest (Cody & Waite 1980).
    constexpr double first = 0x1.921fb544p+0, second = 0x1.0b4611a6p-34, third = 0x1.3198a2ep-69,
                     rest = 0x1.b839a252049c1p-104;
    const double n = nearest(x * 0x1.45f306dc9c883p-1);
    const Wide less_second = exact_sum(x - n * first, -(n * second));
    const Wide less_third = exact_sum(less_second.high, -(n * third));
    const double low = (less_second.low + less_third.low) - n * rest;
    return {fast_sum(less_third.high, low), static_cast<int>(n)};
}

double sine_of(const Wide& angle) {
    static constexpr auto terms = inverse_factorials<8>(3, 2, -1.0);
    const double x = angle.high, z = x * x;
    if (z < 0x1p-54) return x;  // and so -0
    return x + (angle.low * (1.0 - 0.5 * z) + x * z * polynomial(z, terms));
}

double cosine_of(const Wide& angle) {
    static constexpr auto terms = inverse_factorials<8>(4, 2, 1.0);
    const double x = angle.high, z = x * x, half = 0.5 * z, less = 1.0 - half;
    return less + (((1.0 - less) - half) + (z * z * polynomial(z, terms) - x * angle.low));
}

// sin(x + more pi/2)
double sine_after(const Reduced& x, int more) {
    const int quarters = (x.quarters + more) & 3;
    const double value = quarters % 2 == 0 ? sine_of(x.angle) : cosine_of(x.angle);
    return quarters < 2 ? value : -value;
}

// atan(k / 16) from k = 2 on.
constexpr std::array<Wide, 15> arctangents{{{0x1.fd5ba9aac2f6ep-4, -0x1.cd37686760c17p-59},
                                            {0x1.7b97b4bce5b02p-3, 0x1.347b0b4f881cap-58},
                                            {0x1.f5b75f92c80ddp-3, 0x1.8ab6e3cf7afbdp-57},
                                            {0x1.362773707ebccp-2, -0x1.963a544b672d8p-57},
                                            {0x1.6f61941e4def1p-2, -0x1.c63aae6f6e918p-56},
                                            {0x1.a64eec3cc23fdp-2, -0x1.24dec1b50b7ffp-56},
                                            {0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56},
                                            {0x1.0657e94db30d0p-1, -0x1.d5b495f6349e6p-56},
                                            {0x1.1e00babdefeb4p-1, -0x1.928df287a668fp-58},
                                            {0x1.345f01cce37bbp-1, 0x1.1021137c71102p-55},
                                            {0x1.4978fa3269ee1p-1, 0x1.2419a87f2a458p-56},
                                            {0x1.5d58987169b18p-1, 0x1.0028e4bc5e7cap-57},
                                            {0x1.700a7c5784634p-1, -0x1.8c34d25aadef6p-56},
                                            {0x1.819d0b7158a4dp-1, -0x1.bf76229d3b917p-56},
                                            {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55}}};

// atan(a / b) for 0 <= a <= b, b > 0: near c = k / 16 it is atan(c) + atan((a - c b) / (b + c a)).
Wide arctangent(double a, double b) {
    static constexpr std::array<double, 8> terms{-1.0 / 3,  1.0 / 5,  -1.0 / 7,  1.0 / 9,
                                                 -1.0 / 11, 1.0 / 13, -1.0 / 15, 1.0 / 17};
    const double t = a / b;
    if (t < 0x1p-28) return {t, 0.0};
    if (b > 0x1p400 || b < 0x1p-400) {
        const double scale = b > 1.0 ? 0x1p-600 : 0x1p600;
        a *= scale;
        b *= scale;
    }
    if (t < 0.125) {
        const Wide back = exact_product(t, b);
        const double low = ((a - back.high) - back.low) / b;
        return fast_sum(t, low + t * (t * t) * polynomial(t * t, terms));
    }
    const double k = nearest(16.0 * t), c = 0.0625 * k;
    const Wide parts = halves(b);  // whose products with c are exact
    const double z = ((a - c * parts.high) - c * parts.low) / (b + c * a), square = z * z;
    const Wide& near = arctangents[static_cast<std::size_t>(k) - 2];
    return fast_sum(near.high, near.low + (z + z * square * polynomial(square, terms)));
}

constexpr double ln_2_high = 0x1.62e42feep-1, ln_2_low = 0x1.a39ef35793c76p-33;  // the first has 32 bits

}  // namespace

SineCosine sine_cosine(double x) {
    const Reduced reduced = reduce(x);
    return {sine_after(reduced, 0), sine_after(reduced, 1)};
}

double sin(double x) {
    return sine_after(reduce(x), 0);
}

double cos(double x) {
    return sine_after(reduce(x), 1);
}

double atan2(double y, double x) {
    if (std::isnan(x) || std::isnan(y)) return nan;
    double up = std::abs(y), along = std::abs(x);
    if (up == inf || along == inf) {
        up = up == inf ? 1.0 : 0.0;
        along = along == inf ? 1.0 : 0.0;
    }
    constexpr Wide quarter{0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54};
    const bool steep = up > along;
    Wide angle{0.0, 0.0};
    if (up > 0.0) angle = steep ? arctangent(along, up) : arctangent(up, along);
    double result = angle.high + angle.low;
    if (steep) {
        const double sign = std::signbit(x) ? 1.0 : -1.0;
        const Wide sum = fast_sum(quarter.high, sign * angle.high);
        result = sum.high + (sum.low + (quarter.low + sign * angle.low));
    } else if (std::signbit(x)) {
        const Wide sum = fast_sum(2.0 * quarter.high, -angle.high);
        result = sum.high + (sum.low + (2.0 * quarter.low - angle.low));
    }
    return std::copysign(result, y);
}

double hypot(double x, double y) {
    x = std::abs(x);
    y = std::abs(y);
    if (x == inf || y == inf) return inf;
    if (std::isnan(x) || std::isnan(y)) return nan;
    const double larger = std::max(x, y), smaller = std::min(x, y);
    if (smaller <= 0x1p-54 * larger) return larger + smaller;
    if (larger > 0x1p400) return 0x1p600 * hypot(0x1p-600 * x, 0x1p-600 * y);
    if (larger < 0x1p-400) return 0x1p-600 * hypot(0x1p600 * x, 0x1p600 * y);
    const Wide a = exact_square(larger), b = exact_square(smaller), sum = fast_sum(a.high, b.high);
    return std::sqrt(sum.high + (sum.low + (a.low + b.low)));
}

// |x| = 8^k 2^j m with m from 1 to 2: a root from a cubic, a step of Halley's method, and one of Newton's with the
// exact residual.
double cbrt(double x) {
    if (x == 0.0 || !std::isfinite(x)) return x;
    int exponent = 0;
    const double m = 2.0 * std::frexp(std::abs(x), &exponent);
    const int raised = exponent - 1 + 3 * 400, j = raised % 3, k = raised / 3 - 400;
    static constexpr std::array<double, 4> near_root{0.5558, 0.5808, -0.1587, 0.0221};
    static constexpr std::array<double, 3> roots{1.0, 1.26, 1.5874};
    double root = polynomial(m, near_root) * roots[static_cast<std::size_t>(j)];
    const double a = m * static_cast<double>(1 << j), rough = root * root * root;
    root *= (rough + 2.0 * a) / (2.0 * rough + a);
    const Wide square = exact_square(root), cube = exact_product(square.high, root);
    root -= ((cube.high - a) + (cube.low + square.low * root)) / (3.0 * square.high);
    return std::copysign(std::ldexp(root, k), x);
}

double exp(double x) {
    if (std::isnan(x)) return x;
    if (x > 709.79) return inf;
    if (x < -745.14) return 0.0;
    static constexpr auto terms = inverse_factorials<12>(2, 1, 1.0);
    const double n = nearest(x * 0x1.71547652b82fep+0);
    const Wide r = exact_sum(x - n * ln_2_high, -(n * ln_2_low));
    const double z = r.high;
    return std::ldexp(1.0 + (z + (r.low + z * z * polynomial(z, terms))), static_cast<int>(n));
}

// With m = 1 + f and s = f / (2 + f): log(m) = 2 artanh(s) = f - f^2 / 2 + s (f^2 / 2 + 2/3 s^2 + 2/5 s^4 + ...).
double log(double x) {
    if (std::isnan(x) || x == inf) return x;
    if (x == 0.0) return -inf;
    if (x < 0.0) return nan;
    int exponent = 0;
    double m = std::frexp(x, &exponent);
    if (m < 0x1.6a09e667f3bcdp-1) {
        m *= 2.0;
        --exponent;
    }
    static constexpr std::array<double, 10> terms{2.0 / 3,  2.0 / 5,  2.0 / 7,  2.0 / 9,  2.0 / 11,
                                                  2.0 / 13, 2.0 / 15, 2.0 / 17, 2.0 / 19, 2.0 / 21};
    const double f = m - 1.0, s = f / (2.0 + f), z = s * s, half = 0.5 * f * f, n = exponent;
    return n * ln_2_high - ((half - (s * (half + z * polynomial(z, terms)) + n * ln_2_low)) - f);
}

}  // namespace pushfactor::engine::elementary
