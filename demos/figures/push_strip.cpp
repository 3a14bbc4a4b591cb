// Not in the paper: what the push factor does at different shares beta, step by step.
#include "demos/figures/figure.h"
#include "demos/figures/strip.h"

#include <fmt/format.h>

namespace pushfactor::demos::figures {

Plate push_against_beta(Workshop& workshop, const Figure& figure) {
    struct Row {
        std::string push, beta;
    };
    const std::vector<Row> rows{{"persistent", "0.05"},
                                {"persistent", "0.2"},
                                {"single-frame", "0.05"},
                                {"single-frame", "0.2"},
                                {"single-frame", "0.8"}};
    Strip strip{.columns = 6};
    strip.cell_aspect = 0.8;
    for (const Row& row : rows) {
        strip.runs.push_back(run_of("intersecting-stack", {{"push", row.push}, {"beta", row.beta}, {"seconds", "1"}}));
        for (const int step : {0, 1, 2, 4, 8, 15}) {
            strip.cells.push_back({.row = strip.runs.size() - 1,
                                   .time = make_rational(step, 60),
                                   .label = step == 0 ? fmt::format("{} {}", row.push, row.beta)
                                                      : fmt::format("{} step{}", step, step == 1 ? "" : "s")});
        }
    }
    std::vector<double> tops;
    strip.look = [&](const Cell& cell, const Simulation& run) {
        if (cell.time == Rational{1, 4}) tops.push_back(run.scene().world.bodies.back().position.y());
    };
    Plate plate;
    plate.pictures.push_back(workshop.save(draw_strip(workshop, strip), std::string(figure.name)));
    plate.caption = fmt::format(
        "The intersecting stack after 0, 1, 2, 4, 8 and 15 steps of 1/60 s. A persistent push throws the cubes the "
        "harder, the larger beta is; a single-frame push only sets them down the sooner: each step leaves 1 - beta of an "
        "overlap. Centre of the topmost cube after 15 steps, from above: {:.2f}, {:.2f}, {:.2f}, {:.2f} and {:.2f} m; at "
        "rest on each other without overlap it is 10.8 m.",
        tops[0], tops[1], tops[2], tops[3], tops[4]);
    plate.commands = {command_text("render", "intersecting-stack",
                                   {{"push", "single-frame"}, {"compare", "beta=0.05,0.2,0.8"}, {"seconds", "0.25"}})};
    return plate;
}

}  // namespace pushfactor::demos::figures
