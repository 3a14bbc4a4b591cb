#include "demos/figures/strip.h"

#include "demos/options/simulation_options.h"
#include "demos/pictures/composition.h"
#include "demos/pictures/draw_list.h"
#include "demos/pictures/layout.h"
#include "demos/pictures/overlays/overlay.h"
#include "demos/pictures/replay/replay.h"
#include "demos/platform/progress.h"
#include "demos/text/errors.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace pushfactor::demos::figures {

namespace {

using pictures::Layout;
using pictures::Size;

long step_of(const Rational& time, const Settings& settings) {
    return static_cast<long>((time / settings.dt).numerator);
}

// Calls `show` with the index of each cell and its run at the cell's time.
template <typename Show>
void play(const Strip& strip, const Show& show) {
    for (std::size_t r = 0; r < strip.runs.size(); ++r) {
        const Choices& choices = strip.runs[r];
        Simulation run(choices);
        for (std::size_t i = 0; i < strip.cells.size(); ++i) {
            if (strip.cells[i].row != r) continue;
            while (run.sample().step < step_of(strip.cells[i].time, choices.settings)) {
                stop_if_interrupted("the figure is not written");
                run.advance();
            }
            show(i, run);
        }
    }
}

// `label` is the height of a cell's label as a share of the cell's.
View camera_of(const Strip& strip, double aspect, double label) {
    const View view = strip.view.value_or(strip.runs.front().description.view);
    if (!strip.fit) return view;
    pictures::Outline outline;
    Eigen::AlignedBox3d near;
    play(strip, [&](std::size_t, const Simulation& run) {
        if (near.isEmpty()) near = pictures::surroundings(run.scene());
        pictures::add_moving(run.scene(), near, outline);
    });
    const BuiltScene scene = build_scene(strip.runs.front());
    pictures::add_support(scene, outline);
    const pictures::Subject subject = pictures::with_room(pictures::subject_of(scene, outline), label, 0.0);
    return pictures::composed(view, subject, aspect);
}

// What tells the run of a row from the others: its title, or the first option in which they differ.
std::string label_of(const Strip& strip, std::size_t row) {
    if (strip.runs.size() < 2) return "";
    if (row < strip.titles.size()) {
        std::string title = strip.titles[row];
        std::ranges::replace(title, '\n', ' ');
        return title;
    }
    for (const SimulationOption& option : simulation_options()) {
        const std::string own = option.get(strip.runs[row].settings);
        const auto is_other = [&](const Choices& run) { return option.get(run.settings) != own; };
        if (std::ranges::any_of(strip.runs, is_other)) return std::string(option.name) + " " + own;
    }
    return "";
}

// Row titles, each vertically centred on its row.
void write_titles(const Strip& strip, const Layout& layout, int margin, float size,
                  const pictures::Lettering& lettering, renderer::Image& image) {
    for (std::size_t row = 0; row < strip.titles.size(); ++row) {
        const renderer::Rectangle place = layout.place(row * static_cast<std::size_t>(layout.columns));
        std::istringstream lines(strip.titles[row]);
        float y = place.y + 0.5f * place.height;
        for (std::string line; std::getline(lines, line); y += 1.5f * size) {
            lettering.text(image, line, {0.5f * static_cast<float>(margin), y}, size, true);
        }
    }
}

// The runs side by side, all up to the last time of the strip.
void write_replay(const Strip& strip, const std::string& command, const std::filesystem::path& file) {
    std::vector<ComparedRun> panels;
    std::vector<Simulation> runs;
    runs.reserve(strip.runs.size());
    std::vector<const Simulation*> shown;
    for (std::size_t r = 0; r < strip.runs.size(); ++r) {
        panels.push_back({.label = label_of(strip, r), .choices = strip.runs[r]});
        FrameChoices& frames = panels.back().choices.frames;
        frames.camera = {.view = strip.view, .fit = strip.fit};
        if (strip.overlay) frames.overlay = {*strip.overlay};
        shown.push_back(&runs.emplace_back(panels.back().choices));
    }
    Rational end;
    for (const Cell& cell : strip.cells) {
        if (cell.time.value() > end.value()) end = cell.time;
    }
    pictures::Replay replay({.file = file, .command = command}, panels, shown);
    replay.record();
    for (long step = 1; step <= step_of(end, panels.front().choices.settings); ++step) {
        stop_if_interrupted("the figure is not written");
        for (Simulation& run : runs) run.advance();
        replay.record();
    }
    replay.finish();
}

}  // namespace

renderer::Image draw_strip(FigureOutput& output, const Strip& strip) {
    const int margin = strip.titles.empty() ? 0 : output.width() / 11;
    const int rows = (static_cast<int>(strip.cells.size()) + strip.columns - 1) / strip.columns;
    const int across = (output.width() - margin) / strip.columns;
    const Size sheet{output.width() - margin, rows * static_cast<int>(across / strip.cell_aspect)};
    const Layout layout = pictures::grid(sheet, strip.columns, rows);
    const double aspect = static_cast<double>(layout.cell.width) / layout.cell.height;
    const float size = static_cast<float>(output.width()) / 95.0f;
    const View view = camera_of(strip, aspect, 1.8 * size / layout.cell.height);

    std::vector<renderer::Image> images(strip.cells.size());
    play(strip, [&](std::size_t i, const Simulation& run) {
        renderer::Picture picture = pictures::draw_list(run.scene(), view);
        picture.mark_scale = static_cast<float>(rows);
        if (strip.overlay) {
            pictures::add_overlay(run.scene(), strip.overlay->kind, *strip.overlay->units_a_metre, picture);
        }
        images[i] = output.studio().draw(picture, layout.cell, output.samples());
        if (strip.look) strip.look(strip.cells[i], run);
    });
    renderer::Image image = pictures::assemble(layout, images);
    const pictures::Lettering& lettering = output.studio().lettering();
    for (std::size_t i = 0; i < strip.cells.size(); ++i) {
        lettering.name(image, layout.place(i), strip.cells[i].label, size);
    }
    if (margin == 0) return image;
    renderer::Image with_margin = renderer::blank_image(output.width(), sheet.height, glm::vec3(1.0f));
    renderer::paste(with_margin, image, margin, 0);
    write_titles(strip, layout, margin, size, lettering, with_margin);
    return with_margin;
}

Plate draw_plate(FigureOutput& output, const Figure& figure, const Strip& strip) {
    Plate plate;
    const std::string name(figure.name);
    plate.pictures.push_back(output.save(draw_strip(output, strip), name));
    write_replay(strip, "pushfactor figures " + name, output.file(name + ".html"));
    plate.replays.push_back(name + ".html");
    return plate;
}

}  // namespace pushfactor::demos::figures
