// What slides, rolls or holds by friction.
#include "demos/reports/stability/scenes/friction.h"

#include "demos/reports/stability/chapters.h"
#include "demos/reports/stability/measures/slab_slide.h"
#include "demos/reports/stability/scenes/pieces.h"

#include <fmt/format.h>

#include <cmath>

namespace pushfactor::demos::reports::stability {

namespace {

// A step takes the speed of its end for its whole length, and the last one stops within it: times this, of speed
// times step, a way of first order may be off.
constexpr double first_order = 1.5;

const Check straight_on{.measure = "sideways_m", .bar = 1e-6};
const Check no_spin{.measure = "vertical_spin_rad_per_s", .bar = 1e-6};
const Check not_turned{.measure = "turned_rad", .bar = 1e-6};

}  // namespace

Chapter directions() {
    constexpr double speed = 3.0;     // m/s
    constexpr double friction = 0.3;  // mu
    constexpr double way = speed * speed / (2.0 * friction * usual_gravity);
    Chapter chapter{"directions",
                    "Cubes that slide at 3 m/s in 16 directions relative to their edges, friction 0.3: v^2 / (2 mu "
                    "g) straight on, without turning",
                    {}};
    const auto add = [&chapter](const std::string& name, const SceneDescription& scene, bool quick = false) {
        add_at_both_steps(chapter, [&](double step) {
            return Case{.name = name,
                        .own = scene,
                        .options = {{"seconds", "3"}},
                        .wanted = "rest",
                        .checks = {{.measure = "slide_m", .bar = first_order * speed * step, .target = way},
                                   straight_on,
                                   no_spin,
                                   not_turned},
                        .expected = settling("rest", {{}, seat, seat / step, seat}),
                        .quick = quick};
        });
    };
    add("cone-16-directions", cubes_in_16_directions(speed, friction, false), true);
    add("cone-16-directions-on-a-box", cubes_in_16_directions(speed, friction, true));
    add("cubes-turned-16-ways", cubes_turned_16_ways(speed, friction));
    return chapter;
}

Chapter slab() {
    constexpr double speed = 3.0;  // m/s
    constexpr double spin = 10.0;  // rad/s
    const double way = slide_of({}, speed, spin);
    Chapter chapter{"slab",
                    "A slab 1 x 0.2 x 1 m that slides at 3 m/s and turns by 10 rad/s, friction 0.3: goes as far as "
                    "quadrature says at any step",
                    {}};
    // A step less than the way has half a step of the first speed. exact has a square for the cone, whose second
    // tangent holds what turns.
    add_at_both_steps(chapter, [&](double step) {
        return Case{.name = "spinning-slab",
                    .own = spinning_slab(speed, spin, Slab{}.friction),
                    .options = {{"seconds", "4"}},
                    .wanted = "rest",
                    .checks = {{.measure = "slide_m", .bar = 0.01 * way + 0.5 * speed * step, .target = way}},
                    .expected = {{.preset = "default", .outcome = "rest"},
                                 {.preset = "exact", .outcome = "rest", .reached = {1.0}}},
                    .quick = true};
    });
    return chapter;
}

Chapter rolls() {
    constexpr double speed = 3.0;     // m/s
    constexpr double friction = 0.3;  // mu
    constexpr double seconds = 1.0;
    // It slides until its surface runs as fast as it does: then 5/7 of its speed are left.
    constexpr double sliding = 2.0 * speed / (7.0 * friction * usual_gravity);  // s
    constexpr double rolls_at = 5.0 / 7.0 * speed;                              // m/s
    constexpr double way = 0.5 * (speed + rolls_at) * sliding + rolls_at * (seconds - sliding);
    Chapter chapter{"rolling",
                    "Balls that slide in 16 directions begin to roll at 5/7 of their speed; cubes that turn on the "
                    "spot stop after w^2 / (2 mu g r / I)",
                    {}};
    add_at_both_steps(chapter, [&](double step) {
        return Case{.name = "balls-16-directions",
                    .own = balls_in_16_directions(speed, friction),
                    .options = {{"seconds", "1"}},
                    .wanted = "moving",
                    .checks = {{.measure = "last_speed_m_per_s", .bar = 1e-6, .target = rolls_at},
                               {.measure = "slide_m", .bar = first_order * speed * step, .target = way},
                               straight_on},
                    .expected = of_both("moving"),
                    .quick = true};
    });
    constexpr double spin = 10.0;  // rad/s
    // Friction at the corners, sqrt(2) / 2 m from the axis, over the moment of inertia, both of 1 kg.
    const double slowing = friction * usual_gravity * std::sqrt(0.5) * 6.0;  // rad/s^2
    add_at_both_steps(chapter, [&](double step) {
        return Case{.name = "spinning-cubes",
                    .own = spinning_cubes(spin, friction),
                    .options = {{"seconds", "3"}},
                    .wanted = "rest",
                    .checks = {{.measure = "turned_rad",
                                .bar = first_order * spin * step,
                                .target = spin * spin / (2.0 * slowing)},
                               {.measure = "farthest_m", .bar = 1e-6}},
                    .expected = settling("rest", {{}, seat}),
                    .quick = true};
    });
    return chapter;
}

Chapter slopes() {
    constexpr double friction = 0.5;
    Chapter chapter{"slopes",
                    "Cubes turned about the normal of a slope, friction 0.5: they hold, or slide with g (sin - mu "
                    "cos); balls roll with 5/7 g sin until that needs more than mu",
                    {}};
    for (const double angle : {0.3, 0.45, 0.5, 0.6}) {
        const double sliding = usual_gravity * (std::sin(angle) - friction * std::cos(angle));
        const bool slides = sliding > 0.0;
        const std::string outcome = slides ? "moving" : "rest";
        add_at_both_steps(chapter, [&](double step) {
            return Case{
                .name = fmt::format("slope-{}-rad", angle),
                .own = slope(angle),
                .options = {{"seconds", "3"}},
                .wanted = outcome,
                .checks = {{.measure = "acceleration_m_per_s2", .bar = 1e-6, .target = slides ? sliding : 0.0},
                           no_spin},
                .expected = settling(outcome, {{}, slides ? std::optional(seat / step) : std::nullopt}),
                .quick = angle == 0.6};
        });
    }
    add_at_both_steps(chapter, [&](double) {
        return Case{.name = "slope-0.45-rad-60-s",
                    .own = slope(0.45),
                    .options = {{"seconds", "70"}},
                    .wanted = "rest",
                    .checks = {{.measure = "drift_after_10_s_m", .bar = 1e-9}, no_spin},
                    .expected = of_both("rest")};
    });
    for (const double angle : {0.6, 1.0, 1.2}) {
        const bool slips = std::tan(angle) > 3.5 * friction;
        const double sliding = usual_gravity * (std::sin(angle) - friction * std::cos(angle));
        const double rolling = 5.0 / 7.0 * usual_gravity * std::sin(angle);
        add_at_both_steps(chapter, [&](double) {
            return Case{
                .name = fmt::format("balls-on-slope-{}-rad", angle),
                .own = balls_on_slope(angle, slips ? 0.0 : 2.0),
                .options = {{"seconds", "1"}},
                .wanted = "moving",
                .checks = {{.measure = "acceleration_m_per_s2", .bar = 1e-6, .target = slips ? sliding : rolling}},
                .expected = of_both("moving"),
                .quick = angle == 1.0};
        });
    }
    return chapter;
}

Chapter hovering() {
    Chapter chapter{
        "hovering", "Cubes 1 and 5 mm above a plane whose weight a force holds: nothing slows or turns them", {}};
    add_at_both_steps(chapter, [&](double) {
        return Case{.name = "hovering-cubes",
                    .own = hovering_cubes(),
                    .options = {{"seconds", "5"}},
                    .wanted = "moving",
                    .checks = {{.measure = "deflection_m_per_s", .bar = 1e-12},
                               {.measure = "spin_rad_per_s", .bar = 1e-12}},
                    .expected = of_both("moving"),
                    .quick = true};
    });
    return chapter;
}

}  // namespace pushfactor::demos::reports::stability
