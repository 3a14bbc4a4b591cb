// Figures 5 to 10, and the effect of the push factor at different beta: runs at some times.
#include "demos/figures/picture_grid.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace pushfactor::demos::figures {

namespace {

void add_instants(PictureGrid& grid, std::size_t row, std::initializer_list<Rational> times) {
    for (const Rational& time : times) {
        grid.cells.push_back({.row = row, .time = time, .label = fmt::format("{} s", time.value())});
    }
}

int above_middle(const Simulation& run) {
    const auto& bodies = run.scene().world.bodies;
    const auto& described = run.scene().bodies;
    int count = 0;
    for (std::size_t i = 0; i < described.size(); ++i) {
        const bool object = described[i].mass && !described[i].name.starts_with("pendulum");
        if (object && bodies[i].position.y() > 0.0) ++count;
    }
    return count;
}

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

}  // namespace

// "Error caused by the push factor": the box of section 8.1 with k = 1, in four consecutive steps.
SectionContent push_error(FigureOutput& output, const Figure& figure) {
    PictureGrid grid{
        .runs = {run_of("push_error", {{"push", "persistent"}}), run_of("push_error", {{"push", "single-frame"}})},
        .titles = {"original", "single-frame"},
        .columns = 4,
        .cell_aspect = 1.25,
        .fit = false,
        .overlay = OverlayItem{OverlayKind::velocities, 12.0}};
    const Rational dt = grid.runs.front().settings.dt;
    for (const std::size_t row : {0u, 1u}) {
        for (const int frame : {0, 1, 2, 3}) {
            grid.cells.push_back(
                {.row = row, .time = dt * Rational{frame, 1}, .label = fmt::format("frame {}", frame + 1)});
        }
    }
    std::vector<double> depths, speeds;
    grid.look = [&](const Cell& cell, const Simulation& run) {
        const engine::Body& box = run.scene().world.bodies[1];
        if (cell.time == dt) depths.push_back(0.5 - box.position.y());
        if (cell.time == dt * Rational{3, 1}) speeds.push_back(velocity(box).y());
    };
    SectionContent content = draw_figure(output, figure, grid);
    content.caption = fmt::format(
        "A box of 1 m falls at 9 m/s, one step of 1/30 s from frame to frame, with beta = 1 (k in 8.1). In "
        "frame 2 it is {:.3f} m deep, and the push factor puts it onto the floor in frame 3. In the original "
        "method (above) the velocity that did so stays: {:.2f} m/s upwards in frame 4. The single-frame push "
        "(below) leaves {:.2f} m/s. Arrows: stored velocity, 12 m/s per metre.",
        depths[0], speeds[0], speeds[1]);
    content.commands = {
        "pushfactor render assets/scenes/push_error.json --compare push=persistent,single-frame --fps 30 --overlay "
        "velocities:12"};
    return content;
}

// The stack of section 10.1 over time.
SectionContent stack_over_time(FigureOutput& output, const Figure& figure) {
    PictureGrid grid{
        .runs = {run_of("stack", {{"preset", "paper"}, {"seconds", "72"}}), run_of("stack", {{"seconds", "72"}})},
        .titles = {"paper", "default"},
        .columns = 6,
        .cell_aspect = 0.62};
    for (const std::size_t row : {0u, 1u})
        add_instants(grid, row, {{0, 1}, {1, 1}, {20, 1}, {50, 1}, {66, 1}, {71, 1}});
    std::vector<double> heights;
    grid.look = [&](const Cell& cell, const Simulation& run) {
        if (cell.time == Rational{71, 1}) heights.push_back(run.scene().world.bodies.back().position.y());
    };
    SectionContent content = draw_figure(output, figure, grid);
    content.caption = fmt::format(
        "Five cubes of 2.4 m and 1.2 kg. Above: the original method with 25 iterations from zero, beta = 0.2, 60 "
        "steps per second; after 71 s the centre of the topmost cube is at {:.2f} m. Below: the default settings "
        "(single-frame push, contact caching); it is at {:.2f} m and stays there.",
        heights[0], heights[1]);
    content.commands = {command_text(
        "render", "stack", {{"compare", "preset=paper,default"}, {"seconds", "71"}, {"at", "0,1,20,50,66,71"}})};
    return content;
}

// The intersecting stack of section 10.2 under both methods.
SectionContent intersecting_stack(FigureOutput& output, const Figure& figure) {
    const auto run_with = [](const char* push) {
        return run_of("intersecting-stack", {{"preset", "paper"}, {"push", push}, {"seconds", "1"}});
    };
    PictureGrid grid{.runs = {run_with("persistent"), run_with("single-frame")},
                     .cells = {{.row = 0, .time = {0, 1}, .label = "a) start"},
                               {.row = 0, .time = {1, 2}, .label = "b) original method, 0.5 s"},
                               {.row = 1, .time = {1, 2}, .label = "c) single-frame push, 0.5 s"}},
                     .columns = 3,
                     .cell_aspect = 0.72,
                     .overlay = OverlayItem{OverlayKind::velocities, 10.0}};
    std::vector<std::vector<std::string>> speeds;
    grid.look = [&](const Cell& cell, const Simulation& run) {
        if (cell.time == Rational{1, 2}) speeds.push_back(upward_speeds(run));
    };
    SectionContent content = draw_figure(output, figure, grid);
    const bool stands = std::ranges::all_of(speeds[1], [](const std::string& text) { return text == "0.0"; });
    content.caption = fmt::format(
        "Cubes of 2.4 m start inside each other by 0.4 m and in the ground by 1.2 m; preset paper (25 iterations "
        "from zero, beta = 0.2, 60 steps per second). After half a second the original method has them fly upwards "
        "at "
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

SectionContent funnel(FigureOutput& output, const Figure& figure) {
    PictureGrid grid{.runs = {run_of("funnel", {{"seconds", "30"}})}, .columns = 2, .cell_aspect = 1.6};
    add_instants(grid, 0, {{2, 1}, {30, 1}});
    double energy = 0.0;
    grid.look = [&](const Cell&, const Simulation& run) { energy = run.sample().kinetic_energy; };
    SectionContent content = draw_figure(output, figure, grid);
    content.caption = fmt::format(
        "Twenty balls of 1 m and 1 kg in a pyramid of four infinite planes, inclined by 45 degrees (the paper "
        "gives no numbers). Default settings; the kinetic energy after 30 s is {:.1e} J.",
        energy);
    content.commands = {command_text("render", "funnel", {{"seconds", "30"}, {"at", "2,30"}})};
    return content;
}

SectionContent pendulum_grid(FigureOutput& output, const Figure& figure) {
    const OptionTexts options{{"poke", "60"}, {"poke-at", "2"}, {"seconds", "4"}};
    PictureGrid grid{.runs = {run_of("pendulum-grid", options)}, .columns = 3};
    add_instants(grid, 0, {{2, 1}, {5, 2}, {3, 1}});
    std::vector<int> held;
    grid.look = [&](const Cell&, const Simulation& run) { held.push_back(above_middle(run)); };
    SectionContent content = draw_figure(output, figure, grid);
    content.caption = fmt::format(
        "Five by five pendulums, each attached to one point in space by a bar and to nothing else, hold {} "
        "objects. From 2 s on a force of 60 N presses on one of the spheres; it pushes the pendulums aside and "
        "falls through. After 3 s {} objects are held. Default settings.",
        held.front(), held.back());
    content.commands = {
        command_text("render", "pendulum-grid", {{"poke", "60"}, {"poke-at", "2"}, {"at", "2,2.5,3"}})};
    return content;
}

SectionContent pendulum_wave(FigureOutput& output, const Figure& figure) {
    PictureGrid grid{.runs = {run_of("pendulum-wave", {{"seconds", "120"}})}, .columns = 3, .cell_aspect = 1.5};
    add_instants(grid, 0, {{0, 1}, {12, 1}, {30, 1}, {40, 1}, {60, 1}, {120, 1}});
    SectionContent content = draw_figure(output, figure, grid);
    content.caption =
        "Fifty balls, the top of each attached to a fixed point by a bar; ball k makes 40 + k swings in two "
        "minutes. After 30, 40 and 60 s they form four, three and two groups, after 120 s one. Default settings, "
        "60 steps per second.";
    content.commands = {command_text("render", "pendulum-wave", {{"seconds", "120"}, {"at", "0,12,30,40,60,120"}})};
    return content;
}

// Not in the paper: the effect of the push factor at different beta, step by step.
SectionContent push_against_beta(FigureOutput& output, const Figure& figure) {
    const std::vector<std::pair<std::string, std::string>> push_and_beta{
        {"persistent", "0.2"}, {"single-frame", "0.05"}, {"single-frame", "0.2"}, {"single-frame", "0.8"}};
    PictureGrid grid{.columns = 10, .cell_aspect = 0.42};
    for (const auto& [push, beta] : push_and_beta) {
        grid.runs.push_back(run_of("intersecting-stack", {{"push", push}, {"beta", beta}, {"seconds", "1"}}));
        grid.titles.push_back(fmt::format("{}\nβ = {}", push, beta));
        for (const int step : {0, 1, 2, 3, 4, 6, 8, 10, 12, 16}) {
            grid.cells.push_back(
                {.row = grid.runs.size() - 1, .time = make_rational(step, 60), .label = fmt::format("{}", step)});
        }
    }
    std::vector<double> tops;
    grid.look = [&](const Cell& cell, const Simulation& run) {
        if (cell.time == Rational{4, 15}) tops.push_back(run.scene().world.bodies.back().position.y());
    };
    SectionContent content = draw_figure(output, figure, grid);
    content.caption = fmt::format(
        "The intersecting stack after so many steps of 1/60 s. A persistent push throws the cubes apart; a "
        "single-frame push sets them down, and the sooner, the larger beta is: each step leaves 1 - beta of an "
        "overlap. Centre of the topmost cube after 16 steps, from above: {:.2f}, {:.2f}, {:.2f} and {:.2f} m; at "
        "rest on each other without overlap it is 10.8 m. Otherwise default settings.",
        tops[0], tops[1], tops[2], tops[3]);
    content.commands = {
        command_text("render", "intersecting-stack",
                     {{"push", "single-frame"}, {"compare", "beta=0.05,0.2,0.8"}, {"seconds", "0.5"}})};
    return content;
}

}  // namespace pushfactor::demos::figures
