// Not in the paper: the effect of the push factor at different beta, step by step.
#include "demos/figures/figure.h"
#include "demos/figures/picture_grid.h"

#include <fmt/format.h>

namespace pushfactor::demos::figures {

SectionContent push_against_beta(FigureOutput& output, const Figure& figure) {
    struct Row {
        std::string push, beta;
    };
    const std::vector<Row> rows{
        {"persistent", "0.2"}, {"single-frame", "0.05"}, {"single-frame", "0.2"}, {"single-frame", "0.8"}};
    PictureGrid grid{.columns = 10};
    grid.cell_aspect = 0.42;
    for (const Row& row : rows) {
        grid.runs.push_back(
            run_of("intersecting-stack", {{"push", row.push}, {"beta", row.beta}, {"seconds", "1"}}));
        grid.titles.push_back(fmt::format("{}\nβ = {}", row.push, row.beta));
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
