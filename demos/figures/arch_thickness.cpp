// Not in the paper: how thin an arch of free blocks can be, by bisection of runs, and by limit analysis.
#include "demos/figures/figure_output.h"
#include "demos/runs/session.h"
#include "demos/scenes/named/arch.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace pushfactor::demos::figures {

namespace {

constexpr std::array voussoirs{5, 7, 9, 11, 15, 21, 31};
constexpr double run_seconds = 4.0;
constexpr double fallen = 0.02;       // of the height of the crown
constexpr double never_slips = 10.0;  // friction coefficient of the thinnest arches
constexpr double thickness = 0.12;    // of the arches with the least friction
constexpr int halvings = 9;

// Whether no voussoir leaves its place.
bool stands(int count, double thick, double friction) {
    Simulation run(run_of("arch", {{"preset", "exact"},
                                   {"voussoirs", std::to_string(count)},
                                   {"thickness", fmt::format("{}", thick)},
                                   {"friction", fmt::format("{}", friction)},
                                   {"seconds", fmt::format("{}", run_seconds)}}));
    const std::vector<engine::Body> start = run.scene().world.bodies;
    const double crown = std::max_element(start.begin(), start.end(), [](const auto& a, const auto& b) {
                             return a.position.y() < b.position.y();
                         })->position.y();
    bool in_place = true;
    play(run, [&](const Simulation& now) {
        in_place = std::ranges::equal(now.scene().world.bodies, start, [&](const auto& body, const auto& at_start) {
            return (body.position - at_start.position).norm() <= fallen * crown;
        });
        return in_place && before_end(now);
    });
    return in_place;
}

// Between a value at which the arch falls and one at which it stands.
template <typename Stands>
double bisect(double falls, double holds, const Stands& stands_at) {
    for (int i = 0; i < halvings; ++i) {
        const double middle = 0.5 * (falls + holds);
        (stands_at(middle) ? holds : falls) = middle;
    }
    return 0.5 * (falls + holds);
}

}  // namespace

SectionContent arch_thickness(FigureOutput& output, const Figure& figure) {
    Table table{{"voussoirs", "least_thickness", "least_thickness_limit_analysis", "least_friction",
                 "least_friction_limit_analysis", "milankovitch"}};
    double farthest = 0.0;
    for (const int count : voussoirs) {
        const scenes::ArchShape shape{.voussoirs = count, .thickness = thickness};
        const double thinnest = least_thickness(shape, never_slips), smoothest = least_friction(shape);
        const double thin =
            bisect(0.6 * thinnest, 1.4 * thinnest, [&](double value) { return stands(count, value, never_slips); });
        const double smooth =
            bisect(0.6 * smoothest, 1.4 * smoothest, [&](double value) { return stands(count, thickness, value); });
        farthest = std::max({farthest, std::abs(thin / thinnest - 1.0), std::abs(smooth / smoothest - 1.0)});
        table.rows.push_back({count, thin, thinnest, smooth, smoothest, scenes::milankovitch});
    }
    const std::string caption = fmt::format(
        "The thinnest semicircular arch that stands, as a share of its mean radius, against the number of its "
        "voussoirs, and the least friction of one of {} of the radius. Dots: bisection of runs of {:.0f} s with "
        "the exact preset. Line: limit analysis of the same blocks (Heyman). Dashed: a semicircle of very many "
        "blocks, {} (Milankovitch 1907). They differ by {:.2g} % at most.",
        thickness, run_seconds, scenes::milankovitch, 100.0 * farthest);
    return output.plot(
        figure, table, 1.6,
        {.caption = caption,
         .commands = {
             "pushfactor run arch --preset exact --voussoirs 31 --thickness 0.12 --seconds 60",
             "pushfactor run arch --preset exact --voussoirs 31 --thickness 0.09 --friction 10 --seconds 4"}});
}

}  // namespace pushfactor::demos::figures
