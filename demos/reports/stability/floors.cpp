// Floors of flush boxes.
#include "demos/reports/stability/chapters.h"
#include "demos/reports/stability/scenes/floor.h"

#include <fmt/format.h>

namespace pushfactor::demos::reports::stability {

namespace {

void add_rides(Chapter& chapter, double speed, const std::string& seconds, const std::string& outcome) {
    for (const double uneven : {0.0, 0.0005}) {
        for (const double angle : {0.0, 0.4}) {
            const std::string kind = uneven == 0.0 ? "flush" : "uneven";
            add_at_both_steps(chapter, [&](double step) {
                return Case{.name = fmt::format("seams-{}-{}-m-per-s-{}-rad", kind, speed, angle),
                            .own = seam_floor({.speed = speed, .angle = angle, .uneven = uneven}),
                            .options = {{"seconds", seconds}},
                            .wanted = outcome,
                            .checks = {{.measure = "twin_distance_m", .bar = 1e-6},
                                       {.measure = "twin_velocity_m_per_s", .bar = 1e-6}},
                            .expected = settling(outcome, {1.5 * seat, 1.5 * seat / step}),
                            .quick = speed == 4.0 && uneven == 0.0};
            });
        }
    }
}

}  // namespace

Chapter seams() {
    Chapter chapter{
        "seams",
        "Cubes, planks and balls on flush boxes, also with every other box 0.5 mm lower: as on a single "
        "box; but walls and steps stop them",
        {}};
    add_rides(chapter, 0.1, "3", "creep");  // as slow as that
    add_rides(chapter, 4.0, "0.8", "moving");
    add_rides(chapter, 50.0, "0.067", "moving");
    constexpr double slop = 0.002;  // m, of a cube of 1 m
    const auto add_stop = [&chapter](const std::string& name, const SceneDescription& scene, double beyond) {
        add_at_both_steps(chapter, [&](double step) {
            // Short steps leave default a speed of a tenth of its seat in a step, which nothing takes away.
            const bool creeps = step < 0.01 && beyond == slop;
            return Case{.name = name,
                        .own = scene,
                        .options = {{"seconds", "4"}},
                        .wanted = "rest",
                        .checks = {{.measure = "farthest_m", .bar = beyond, .target = way_to_stop}},
                        .expected = {{.preset = "default", .outcome = creeps ? "creep" : "rest"},
                                     {.preset = "exact", .outcome = "rest"}},
                        .quick = name == "cube-stopped-by-step"};
        });
    };
    add_stop("cube-stopped-by-wall", stopped_by_wall(4.0), slop);
    add_stop("slab-stopped-by-step", slab_stopped_by_step(4.0), slop);
    // At the step it has 1 m/s left. It tips about the edge with 0.73 rad/s, to 0.033 rad, and its centre goes on
    // by 0.015 m.
    add_stop("cube-stopped-by-step", cube_stopped_by_step(2.0), 0.02);
    return chapter;
}

}  // namespace pushfactor::demos::reports::stability
