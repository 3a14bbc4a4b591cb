// Cases of sliding, rolling and static friction, of hovering bodies without friction, and floors of flush boxes.
#include "demos/reports/stability/cases.h"
#include "demos/reports/stability/measures/slab_slide.h"
#include "demos/reports/stability/scenes/scenes.h"

#include <fmt/format.h>

#include <cmath>

namespace pushfactor::demos::reports::stability {

namespace {

// Allowed error of a sliding distance, as a factor of speed x step: a step uses its final speed for its whole
// length, and the body stops within the last one.
constexpr double first_order = 1.5;

const Check straight_on{"sideways_m", 1e-6};
const Check no_spin{"vertical_spin_rad_per_s", 1e-6};
const Check not_turned{"turned_rad", 1e-6};

// Checks that do not depend on the step.
auto always(const Checks& checks) {
    return [checks](double) { return checks; };
}

auto both(const std::string& outcome) {
    return [outcome](double) { return of_both(outcome); };
}

Chapter slopes() {
    constexpr double friction = 0.5;
    Chapter chapter{"slopes",
                    "Cubes turned about the normal of a slope, friction 0.5: they hold, or slide with g (sin - mu "
                    "cos); balls roll with 5/7 g sin until that needs more than mu"};
    const auto sliding_on = [](double angle) {
        return usual_gravity * (std::sin(angle) - friction * std::cos(angle));
    };
    for (const double angle : {0.3, 0.45, 0.5, 0.6}) {
        const double sliding = sliding_on(angle);
        const bool slides = sliding > 0.0;
        const std::string outcome = slides ? "moving" : "rest";
        chapter.add_at_both_steps(
            fmt::format("slope-{}-rad", angle), slope(angle), "3", outcome,
            always({{"acceleration_m_per_s2", 1e-6, slides ? sliding : 0.0}, no_spin}),
            [&](double step) {
                return settling(outcome, {{}, slides ? std::optional(seat / step) : std::nullopt});
            },
            angle == 0.6);
    }
    chapter.add_at_both_steps("slope-0.45-rad-60-s", slope(0.45), "70", "rest",
                              always({{"drift_after_10_s_m", 1e-9}, no_spin}), both("rest"));
    for (const double angle : {0.6, 1.0, 1.2}) {
        const bool slips = std::tan(angle) > 3.5 * friction;
        const double rolling = 5.0 / 7.0 * usual_gravity * std::sin(angle);
        chapter.add_at_both_steps(fmt::format("balls-on-slope-{}-rad", angle),
                                  balls_on_slope(angle, slips ? 0.0 : 2.0), "1", "moving",
                                  always({{"acceleration_m_per_s2", 1e-6, slips ? sliding_on(angle) : rolling}}),
                                  both("moving"), angle == 1.0);
    }
    return chapter;
}

Chapter directions() {
    constexpr double speed = 3.0;     // m/s
    constexpr double friction = 0.3;  // mu
    constexpr double way = speed * speed / (2.0 * friction * usual_gravity);
    Chapter chapter{"directions",
                    "Cubes that slide at 3 m/s in 16 directions relative to their edges, friction 0.3: v^2 / (2 mu "
                    "g) straight on, without turning"};
    const auto add = [&chapter](const std::string& name, const SceneDescription& scene, bool quick = false) {
        chapter.add_at_both_steps(
            name, scene, "3", "rest",
            [](double step) -> Checks {
                return {{"slide_m", first_order * speed * step, way}, straight_on, no_spin, not_turned};
            },
            [](double step) {
                return settling("rest", {{}, seat, seat / step, seat});
            },
            quick);
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
                    "quadrature says at any step"};
    // First order: half a step at the first speed. exact has a square instead of the cone, whose second tangent
    // slows a spinning body too much.
    chapter.add_at_both_steps(
        "spinning-slab", spinning_slab(speed, spin, Slab{}.friction), "4", "rest",
        [&](double step) -> Checks {
            return {{"slide_m", 0.01 * way + 0.5 * speed * step, way}};
        },
        [](double) -> Expectations {
            return {{"default", "rest"}, {"exact", "rest", {1.0}}};
        },
        true);
    return chapter;
}

Chapter rolls() {
    constexpr double speed = 3.0;     // m/s
    constexpr double friction = 0.3;  // mu
    constexpr double seconds = 1.0;
    // It slides until it rolls, with 5/7 of its speed.
    constexpr double sliding = 2.0 * speed / (7.0 * friction * usual_gravity);  // s
    constexpr double rolls_at = 5.0 / 7.0 * speed;                              // m/s
    constexpr double way = 0.5 * (speed + rolls_at) * sliding + rolls_at * (seconds - sliding);
    Chapter chapter{"rolling",
                    "Balls that slide in 16 directions begin to roll at 5/7 of their speed; cubes that turn on the "
                    "spot stop after w^2 / (2 mu g r / I)"};
    chapter.add_at_both_steps(
        "balls-16-directions", balls_in_16_directions(speed, friction), "1", "moving",
        [](double step) -> Checks {
            return {
                {"last_speed_m_per_s", 1e-6, rolls_at}, {"slide_m", first_order * speed * step, way}, straight_on};
        },
        both("moving"), true);
    constexpr double spin = 10.0;  // rad/s
    // Friction at the corners, sqrt(2) / 2 m from the axis, over the moment of inertia, both of 1 kg.
    const double slowing = friction * usual_gravity * std::sqrt(0.5) * 6.0;  // rad/s^2
    chapter.add_at_both_steps(
        "spinning-cubes", spinning_cubes(spin, friction), "3", "rest",
        [&](double step) -> Checks {
            return {{"turned_rad", first_order * spin * step, spin * spin / (2.0 * slowing)}, {"farthest_m", 1e-6}};
        },
        [](double) {
            return settling("rest", {{}, seat});
        },
        true);
    return chapter;
}

Chapter hovering() {
    Chapter chapter{"hovering",
                    "Cubes 1 and 5 mm above a plane whose weight a force holds: nothing slows or turns them"};
    chapter.add_at_both_steps("hovering-cubes", hovering_cubes(), "5", "moving",
                              always({{"deflection_m_per_s", 1e-12}, {"spin_rad_per_s", 1e-12}}), both("moving"),
                              true);
    return chapter;
}

void add_rides(Chapter& chapter, double speed, const std::string& seconds, const std::string& outcome) {
    for (const double uneven : {0.0, 0.0005}) {
        for (const double angle : {0.0, 0.4}) {
            chapter.add_at_both_steps(
                fmt::format("seams-{}-{}-m-per-s-{}-rad", uneven == 0.0 ? "flush" : "uneven", speed, angle),
                seam_floor({.speed = speed, .angle = angle, .uneven = uneven}), seconds, outcome,
                always({{"twin_distance_m", 1e-6}, {"twin_velocity_m_per_s", 1e-6}}),
                [&](double step) {
                    return settling(outcome, {1.5 * seat, 1.5 * seat / step});
                },
                speed == 4.0 && uneven == 0.0);
        }
    }
}

Chapter seams() {
    Chapter chapter{"seams",
                    "Cubes, planks and balls on flush boxes, also with every other box 0.5 mm lower: as on a "
                    "single box; but walls and steps stop them"};
    add_rides(chapter, 0.1, "3", "creep");  // 0.1 m/s counts as creeping
    add_rides(chapter, 4.0, "0.8", "moving");
    add_rides(chapter, 50.0, "0.067", "moving");
    constexpr double slop = 0.002;  // m, of a cube of 1 m
    const auto add_stop = [&chapter](const std::string& name, const SceneDescription& scene, double beyond) {
        chapter.add_at_both_steps(
            name, scene, "4", "rest", always({{"farthest_m", beyond, way_to_stop}}),
            [&](double step) -> Expectations {
                // With short steps default keeps a speed of a tenth of `seat` per step, which nothing removes.
                return {{"default", step < 0.01 && beyond == slop ? "creep" : "rest"}, {"exact", "rest"}};
            },
            name == "cube-stopped-by-step");
    };
    add_stop("cube-stopped-by-wall", stopped_by_wall(4.0), slop);
    add_stop("slab-stopped-by-step", slab_stopped_by_step(4.0), slop);
    // At the step it has 1 m/s left. It tips about the edge with 0.73 rad/s, to 0.033 rad, and its centre goes on
    // by 0.015 m.
    add_stop("cube-stopped-by-step", cube_stopped_by_step(2.0), 0.02);
    return chapter;
}

}  // namespace

std::vector<Chapter> sliding_chapters() {
    return {slopes(), directions(), slab(), rolls(), hovering(), seams()};
}

}  // namespace pushfactor::demos::reports::stability
