// Figure 5, "Error caused by the push factor": the box of section 8.1 with k = 1, in four consecutive steps.
#include "demos/figures/figure.h"
#include "demos/figures/picture_grid.h"

#include <fmt/format.h>

namespace pushfactor::demos::figures {

SectionContent push_error(FigureOutput& output, const Figure& figure) {
    const OptionTexts original{{"push", "persistent"}};
    const OptionTexts improved{{"push", "single-frame"}};
    PictureGrid grid{.runs = {run_of("push_error", original), run_of("push_error", improved)}, .columns = 4};
    grid.titles = {"original", "single-frame"};
    grid.fit = false;
    grid.cell_aspect = 1.25;
    grid.overlay = OverlayItem{OverlayKind::velocities, 12.0};
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
        "A box of 1 m falls at 9 m/s, one step of 1/30 s from frame to frame, with k = 1 (called beta in 5.2). In "
        "frame 2 it is {:.3f} m deep, and the push factor puts it onto the floor in frame 3. In the original "
        "method (above) the velocity that did so stays: {:.2f} m/s upwards in frame 4. The single-frame push "
        "(below) leaves {:.2f} m/s. Arrows: stored velocity, 12 m/s per metre.",
        depths[0], speeds[0], speeds[1]);
    content.commands = {
        "pushfactor render assets/scenes/push_error.json --compare push=persistent,single-frame --fps 30 --overlay "
        "velocities:12"};
    return content;
}

}  // namespace pushfactor::demos::figures
