// Figures 8 to 10: the other scenes of section 10.3.
#include "demos/figures/figure.h"
#include "demos/figures/picture_grid.h"

#include <fmt/format.h>

#include <algorithm>

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

}  // namespace

SectionContent funnel(FigureOutput& output, const Figure& figure) {
    const OptionTexts options{{"seconds", "30"}};
    PictureGrid grid{.runs = {run_of("funnel", options)}, .columns = 2};
    grid.cell_aspect = 1.6;
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
    add_instants(grid, 0, {{2, 1}, {14, 5}, {31, 10}});
    std::vector<int> held;
    grid.look = [&](const Cell&, const Simulation& run) { held.push_back(above_middle(run)); };
    SectionContent content = draw_figure(output, figure, grid);
    content.caption = fmt::format(
        "Five by five pendulums, each attached to one point in space by a bar and to nothing else, hold {} "
        "objects. From 2 s on a force of 60 N presses on one of the spheres; it pushes the pendulums aside and "
        "falls through. After 3.1 s {} objects are held. Default settings.",
        held.front(), held.back());
    content.commands = {
        command_text("render", "pendulum-grid", {{"poke", "60"}, {"poke-at", "2"}, {"at", "2,2.8,3.1"}})};
    return content;
}

SectionContent pendulum_wave(FigureOutput& output, const Figure& figure) {
    const OptionTexts options{{"seconds", "120"}};
    PictureGrid grid{.runs = {run_of("pendulum-wave", options)}, .columns = 3};
    grid.cell_aspect = 1.5;
    add_instants(grid, 0, {{0, 1}, {12, 1}, {30, 1}, {40, 1}, {60, 1}, {120, 1}});
    SectionContent content = draw_figure(output, figure, grid);
    content.caption =
        "Fifty balls, the top of each attached to a fixed point by a bar; ball k makes 40 + k swings in two "
        "minutes. After 30, 40 and 60 s they form four, three and two groups, after 120 s one. Default settings, "
        "60 steps per second.";
    content.commands = {command_text("render", "pendulum-wave", {{"seconds", "120"}, {"at", "0,12,30,40,60,120"}})};
    return content;
}

}  // namespace pushfactor::demos::figures
