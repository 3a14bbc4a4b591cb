#include "demos/scenes/exact_motions/ball_on_bar.h"

#include "engine/base/elementary.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace pushfactor::demos::scenes {

namespace elementary = engine::elementary;

namespace {

// The rates of a swing: the two equations solved for a'' and b''.
Swing rates(const BallOnBar& pendulum, const Swing& s) {
    const double l = pendulum.length;
    const double r = pendulum.radius;
    const double sin_a = elementary::sin(s.a), cos_a = elementary::cos(s.a);
    const double sin_b = elementary::sin(s.b), cos_b = elementary::cos(s.b);
    const double c = cos_a * cos_b + sin_a * sin_b;  // cos(a - b)
    const double d = sin_a * cos_b - cos_a * sin_b;  // sin(a - b)

    // Divided by l and by r: [l, r c; l c, 1.4 r] [a''; b''] = right side.
    const double right_a = -r * d * s.b_rate * s.b_rate - pendulum.gravity * sin_a;
    const double right_b = l * d * s.a_rate * s.a_rate - pendulum.gravity * sin_b;
    const double determinant = l * r * (1.4 - c * c);
    return {.a = s.a_rate,
            .b = s.b_rate,
            .a_rate = (1.4 * r * right_a - r * c * right_b) / determinant,
            .b_rate = (l * right_b - l * c * right_a) / determinant};
}

Swing moved(const Swing& s, const Swing& rate, double time) {
    return {s.a + time * rate.a, s.b + time * rate.b, s.a_rate + time * rate.a_rate, s.b_rate + time * rate.b_rate};
}

Swing runge_kutta(const BallOnBar& pendulum, const Swing& s, double h) {
    const Swing k1 = rates(pendulum, s);
    const Swing k2 = rates(pendulum, moved(s, k1, 0.5 * h));
    const Swing k3 = rates(pendulum, moved(s, k2, 0.5 * h));
    const Swing k4 = rates(pendulum, moved(s, k3, h));
    const Swing sum{k1.a + 2 * k2.a + 2 * k3.a + k4.a, k1.b + 2 * k2.b + 2 * k3.b + k4.b,
                    k1.a_rate + 2 * k2.a_rate + 2 * k3.a_rate + k4.a_rate,
                    k1.b_rate + 2 * k2.b_rate + 2 * k3.b_rate + k4.b_rate};
    return moved(s, sum, h / 6.0);
}

// Distance of the centre from the vertical [m].
double aside(const BallOnBar& pendulum, const Swing& swing) {
    return pendulum.length * elementary::sin(swing.a) + pendulum.radius * elementary::sin(swing.b);
}

// Times at which the centre passes the vertical, each found by the secant between two steps. Fewer if the bar is so
// short that the steps do not follow.
std::vector<double> crossings(const BallOnBar& pendulum, double amplitude, std::size_t count) {
    constexpr double h = 1.0 / 60.0;  // s; of fourth order, times wrong by less than 1e-7 of them
    Swing swing{.a = amplitude, .b = amplitude};
    std::vector<double> times;
    for (long n = 1; times.size() < count && std::isfinite(swing.a_rate + swing.b_rate); ++n) {
        const Swing next = runge_kutta(pendulum, swing, h);
        if ((aside(pendulum, swing) > 0.0) != (aside(pendulum, next) > 0.0)) {
            // Within a step the angle is nearly linear; some refinements reach rounding.
            const double angle = centre_angle(pendulum, swing), next_angle = centre_angle(pendulum, next);
            double share = angle / (angle - next_angle);
            for (int i = 0; i < 5; ++i) {
                const double there = centre_angle(pendulum, runge_kutta(pendulum, swing, share * h));
                share += there / (angle - next_angle);
            }
            times.push_back((static_cast<double>(n - 1) + share) * h);
        }
        swing = next;
    }
    return times;
}

}  // namespace

Swing advance(const BallOnBar& pendulum, Swing swing, double time, int steps) {
    for (int i = 0; i < steps; ++i) swing = runge_kutta(pendulum, swing, time / steps);
    return swing;
}

double centre_angle(const BallOnBar& pendulum, const Swing& swing) {
    const double below = pendulum.length * elementary::cos(swing.a) + pendulum.radius * elementary::cos(swing.b);
    return elementary::atan2(aside(pendulum, swing), below);
}

double period(const BallOnBar& pendulum, double amplitude) {
    constexpr std::size_t halves = 24;
    const std::vector<double> times = crossings(pendulum, amplitude, halves + 1);
    if (times.size() <= halves) return std::numeric_limits<double>::quiet_NaN();
    double weighted = 0.0;
    double weights = 0.0;
    for (std::size_t i = 0; i < halves; ++i) {
        const double u = (static_cast<double>(i) + 0.5) / halves;
        const double weight = elementary::exp(-1.0 / (u * (1.0 - u)));
        weighted += weight * (times[i + 1] - times[i]);
        weights += weight;
    }
    return 2.0 * weighted / weights;
}

double length_for_period(BallOnBar pendulum, double amplitude, double wanted) {
    // Begin with the pendulum whose ball is fixed to the bar, for a small swing: L + k^2 / L = g (T / 2 pi)^2.
    const double per_radian = wanted / (2.0 * std::numbers::pi);
    const double per_length = pendulum.gravity * per_radian * per_radian;
    pendulum.length = per_length / (1.0 + amplitude * amplitude / 8.0) - pendulum.radius;
    if (!(pendulum.length > 0.0)) return 0.0;
    // T^2 grows almost in proportion to l + r; the secant through both guesses then has the last digits.
    const double first = pendulum.length, first_period = period(pendulum, amplitude);
    const double ratio = wanted / first_period;
    pendulum.length = (first + pendulum.radius) * ratio * ratio - pendulum.radius;
    if (pendulum.length == first) return first;
    if (!(pendulum.length > 0.0)) return 0.0;
    const double slope = (period(pendulum, amplitude) - first_period) / (pendulum.length - first);
    return first + (wanted - first_period) / slope;
}

}  // namespace pushfactor::demos::scenes
