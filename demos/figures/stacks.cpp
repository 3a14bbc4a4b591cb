// Figures 6 and 7: the stack of section 10.1 over time, and the intersecting stack of 10.2 under both methods.
#include "demos/figures/figure.h"
#include "demos/figures/picture_grid.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace pushfactor::demos::figures {

namespace {

// From the lowest cube to the topmost.
std::vector<std::string> upward_speeds(const Simulation& run) {
    std::vector<std::string> speeds;
    for (const engine::Body& body : run.scene().world.bodies) {
        if (body.is_static()) continue;
        const double speed = velocity(body).y();
        speeds.push_back(fmt::format("{:.1f}", std::abs(speed) < 0.05 ? 0.0 : speed));  // never "-0.0"
    }
    return speeds;
}

double top(const Simulation& run) {
    return run.scene().world.bodies.back().position.y();
}

}  // namespace

SectionContent stack_over_time(FigureOutput& output, const Figure& figure) {
    const OptionTexts paper{{"preset", "paper"}, {"seconds", "72"}};
    const OptionTexts ours{{"seconds", "72"}};
    PictureGrid grid{.runs = {run_of("stack", paper), run_of("stack", ours)}, .columns = 6};
    grid.titles = {"paper", "default"};
    grid.cell_aspect = 0.62;
    for (const std::size_t row : {0u, 1u}) {
        for (const int time : {0, 1, 20, 50, 66, 71}) {
            grid.cells.push_back({.row = row, .time = {time, 1}, .label = fmt::format("{} s", time)});
        }
    }
    std::vector<double> heights;
    grid.look = [&](const Cell& cell, const Simulation& run) {
        if (cell.time == Rational{71, 1}) heights.push_back(top(run));
    };
    SectionContent content = draw_figure(output, figure, grid);
    content.caption = fmt::format(
        "Five cubes of 2.4 m and 1.2 kg. Above: the original method with 25 iterations from zero, k = 0.2, 60 "
        "steps per second; after 71 s the centre of the topmost cube is at {:.2f} m. Below: the default settings "
        "(single-frame push, contact caching); it is at {:.2f} m and stays there.",
        heights[0], heights[1]);
    content.commands = {command_text(
        "render", "stack", {{"compare", "preset=paper,default"}, {"seconds", "71"}, {"at", "0,1,20,50,66,71"}})};
    return content;
}

SectionContent intersecting_stack(FigureOutput& output, const Figure& figure) {
    const OptionTexts original{{"preset", "paper"}, {"seconds", "1"}};
    const OptionTexts improved{{"preset", "paper"}, {"push", "single-frame"}, {"seconds", "1"}};
    PictureGrid grid{.runs = {run_of("intersecting-stack", original), run_of("intersecting-stack", improved)},
                     .columns = 3};
    grid.cell_aspect = 0.72;
    grid.overlay = OverlayItem{OverlayKind::velocities, 10.0};
    grid.cells = {{.row = 0, .time = {0, 1}, .label = "a) start"},
                  {.row = 0, .time = {1, 2}, .label = "b) original method, 0.5 s"},
                  {.row = 1, .time = {1, 2}, .label = "c) single-frame push, 0.5 s"}};
    std::vector<std::vector<std::string>> speeds;
    grid.look = [&](const Cell& cell, const Simulation& run) {
        if (cell.time == Rational{1, 2}) speeds.push_back(upward_speeds(run));
    };
    SectionContent content = draw_figure(output, figure, grid);
    const bool stands = std::ranges::all_of(speeds[1], [](const std::string& text) { return text == "0.0"; });
    content.caption = fmt::format(
        "Cubes of 2.4 m start inside each other by 0.4 m and in the ground by 1.2 m; preset paper (25 iterations "
        "from zero, k = 0.2, 60 steps per second). After half a second the original method has them fly upwards at "
        "{} m/s, from the lowest to the topmost. With the single-frame push and everything else equal they {}. "
        "Arrows: stored velocity, 10 m/s per metre.",
        fmt::join(speeds[0], ", "),
        stands ? "stand, slower than 0.05 m/s" : fmt::format("move at {} m/s", fmt::join(speeds[1], ", ")));
    content.commands = {command_text("render", "intersecting-stack",
                                     {{"preset", "paper"},
                                      {"compare", "push=persistent,single-frame"},
                                      {"at", "0,0.5"},
                                      {"camera", "fit"},
                                      {"overlay", "velocities:10"}})};
    return content;
}

}  // namespace pushfactor::demos::figures
