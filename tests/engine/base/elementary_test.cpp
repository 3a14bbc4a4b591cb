#include "engine/base/elementary.h"

#include "engine/base/wide.h"
#include "tests/catch.h"
#include "tests/random.h"

#include <cmath>
#include <limits>
#include <numbers>

using namespace pushfactor;
using engine::Wide;
namespace elementary = engine::elementary;

namespace {

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr int draws = 200'000;

// How far `value` is from `exact`, in units of the last place of what `exact` rounds to.
double units_off(double value, long double exact) {
    const auto rounded = static_cast<double>(exact);
    if (!std::isfinite(rounded) || rounded == 0.0) return value == rounded ? 0.0 : inf;
    const int exponent = std::max(std::ilogb(rounded) - 52, -1074);
    return static_cast<double>(std::abs(static_cast<long double>(value) - exact) / std::ldexp(1.0L, exponent));
}

// The largest error for random arguments from 10^low to 10^high of either sign.
template <typename Function, typename Exact>
double worst(const Function& function, const Exact& exact, double low, double high) {
    tests::Random random(1);
    double largest = 0.0;
    for (int i = 0; i < draws; ++i) {
        const double x = std::pow(10.0, random.in(low, high)) * (i % 2 == 0 ? 1.0 : -1.0);
        largest = std::max(largest, units_off(function(x), exact(x)));
    }
    return largest;
}

bool same(double a, double b) {
    return std::isnan(a) ? std::isnan(b) : a == b && std::signbit(a) == std::signbit(b);
}

}  // namespace

TEST_CASE("elementary functions are less than one unit of the last place off") {
    using L = long double;
    static_assert(std::numeric_limits<L>::digits > 60, "has to be wider than double");
    CHECK(worst(
              elementary::sin, [](L x) { return std::sin(x); }, -8, 6) < 1.0);  // measured 0.80
    CHECK(worst(
              elementary::cos, [](L x) { return std::cos(x); }, -8, 6) < 1.0);  // 0.85
    CHECK(worst(
              elementary::cbrt, [](L x) { return std::cbrt(x); }, -300, 300) < 1.0);  // 0.50
    CHECK(worst(
              elementary::exp, [](L x) { return std::exp(x); }, -8, 2.84) < 1.0);  // 0.92
    const auto log_of_size = [](double x) { return elementary::log(std::abs(x)); };
    CHECK(worst(
              log_of_size, [](L x) { return std::log(std::abs(x)); }, -300, 300) < 1.0);  // 0.74
    CHECK(worst(
              log_of_size, [](L x) { return std::log(std::abs(x)); }, -0.3, 0.3) < 1.0);  // 0.84

    tests::Random random(2);
    double of_atan2 = 0.0, of_hypot = 0.0;
    for (int i = 0; i < draws; ++i) {
        const double range = i % 3 == 0 ? 0.3 : i % 3 == 1 ? 8.0 : 140.0;
        const double y = std::pow(10.0, random.in(-range, range)) * (random.in(-1, 1) < 0.0 ? -1.0 : 1.0);
        const double x = std::pow(10.0, random.in(-range, range)) * (random.in(-1, 1) < 0.0 ? -1.0 : 1.0);
        of_atan2 = std::max(of_atan2, units_off(elementary::atan2(y, x), std::atan2(L{y}, L{x})));
        of_hypot = std::max(of_hypot, units_off(elementary::hypot(y, x), std::hypot(L{y}, L{x})));
    }
    CHECK(of_atan2 < 1.0);  // 0.72
    CHECK(of_hypot < 1.0);  // 0.85
}

TEST_CASE("sin and cos keep their digits next to their zeros, and both together are the same") {
    for (int n = 1; n < 660'000; n += n < 20'000 ? 1 : 97) {
        const auto zero = static_cast<double>(n * (std::numbers::pi_v<long double> / 2.0L));
        for (const double x : {std::nextafter(zero, 0.0), zero, std::nextafter(zero, inf)}) {
            REQUIRE(units_off(elementary::sin(x), std::sin(static_cast<long double>(x))) < 1.0);
            REQUIRE(units_off(elementary::cos(x), std::cos(static_cast<long double>(x))) < 1.0);
            const auto [sine, cosine] = elementary::sine_cosine(x);
            REQUIRE(same(sine, elementary::sin(x)));
            REQUIRE(same(cosine, elementary::cos(x)));
        }
    }
}

TEST_CASE("angles of millions of turns are reduced by the rounded pi") {
    for (double x = 0x1p21; x < 1e15; x *= 7.3) {
        CHECK(std::abs(elementary::sin(x) - static_cast<double>(std::sin(static_cast<long double>(x)))) <
              0x1p-54 * x + 1e-15);
    }
}

TEST_CASE("special values of elementary functions are those of IEEE 754") {
    for (const double zero : {0.0, -0.0}) {
        CHECK(same(elementary::sin(zero), zero));
        CHECK(same(elementary::cos(zero), 1.0));
        CHECK(same(elementary::cbrt(zero), zero));
        CHECK(same(elementary::exp(zero), 1.0));
        CHECK(same(elementary::log(zero), -inf));
        CHECK(same(elementary::hypot(zero, -0.0), 0.0));
    }
    for (const double none : {inf, -inf, nan}) {
        CHECK(std::isnan(elementary::sin(none)));
        CHECK(std::isnan(elementary::cos(none)));
    }
    CHECK(same(elementary::exp(-inf), 0.0));
    CHECK(same(elementary::exp(inf), inf));
    CHECK(same(elementary::log(inf), inf));
    CHECK(same(elementary::log(1.0), 0.0));
    CHECK(std::isnan(elementary::log(-1.0)));
    CHECK(same(elementary::cbrt(-inf), -inf));
    CHECK(same(elementary::cbrt(-27.0), -3.0));
    CHECK(same(elementary::hypot(-inf, nan), inf));
    CHECK(std::isnan(elementary::hypot(nan, 1.0)));
    CHECK(same(elementary::hypot(1e308, 1e308), std::hypot(1e308, 1e308)));
    CHECK(same(elementary::hypot(5e-324, 0.0), 5e-324));
    for (const double y : {0.0, -0.0, 1.0, -1.0, inf, -inf, nan}) {
        for (const double x : {0.0, -0.0, 1.0, -1.0, inf, -inf, nan}) {
            INFO(y << ", " << x);
            CHECK(same(elementary::atan2(y, x), std::atan2(y, x)));
        }
    }
}

TEST_CASE("wide numbers keep twice the digits of a double") {
    tests::Random random(3);
    for (int i = 0; i < 10'000; ++i) {
        const Wide a = Wide(random.in(-1, 1)) + random.in(-1, 1) * 0x1p-54;
        const Wide b = Wide(random.in(0.1, 1)) + random.in(-1, 1) * 0x1p-54;
        const Wide back = a / b * b - a, gone = (a + b) - b - a;
        REQUIRE(std::abs(back.high) < 1e-31);
        REQUIRE(std::abs(gone.high) < 1e-31);
        const Wide both = (a + b) * (a - b) - (a * a - b * b);
        REQUIRE(std::abs(both.high) < 1e-31);
    }
    const Wide third = Wide(1.0) / 3.0;
    CHECK(third.high + third.low == third.high);
    CHECK((third * 3.0).high == 1.0);
}
