#include "demos/figures/picture_grid.h"

#include "demos/base/platform/progress.h"
#include "demos/base/text/wrapped.h"
#include "demos/options/simulation_options.h"
#include "demos/pictures/camera/framing.h"
#include "demos/pictures/camera/layout.h"
#include "demos/pictures/camera/survey.h"
#include "demos/pictures/draw_list.h"
#include "demos/pictures/overlays/overlay.h"
#include "demos/pictures/replay/replay.h"

#include <algorithm>
#include <sstream>

namespace pushfactor::demos::figures {

namespace {

using pictures::Layout;
using pictures::Size;

long step_of(const Rational& time, const Choices& run) {
    return static_cast<long>((time / run.settings.dt).numerator);
}

bool goes_on(const Simulation&) {
    stop_if_interrupted("the figure is not written");
    return true;
}

// Calls `show` with the index of each cell and its run at the cell's time.
void play_cells(const PictureGrid& grid, const std::function<void(std::size_t cell, const Simulation& run)>& show) {
    for (std::size_t r = 0; r < grid.runs.size(); ++r) {
        Simulation run(grid.runs[r]);
        for (std::size_t i = 0; i < grid.cells.size(); ++i) {
            if (grid.cells[i].row != r) continue;
            const long step = step_of(grid.cells[i].time, grid.runs[r]);
            play(run, [step](const Simulation& now) { return goes_on(now) && now.sample().step < step; });
            show(i, run);
        }
    }
}

// `label` is the height of a cell's label as a share of the cell's.
View camera_of(const PictureGrid& grid, double aspect, double label) {
    const View view = grid.runs.front().description.view;
    if (!grid.fit) return view;
    pictures::Outline outline;
    Eigen::AlignedBox3d near;
    play_cells(grid, [&](std::size_t, const Simulation& run) {
        if (near.isEmpty()) near = pictures::surroundings(pictures::movable_balls(run.scene()));
        pictures::add_moving(run.scene(), near, outline);
    });
    const BuiltScene scene = build_scene(grid.runs.front());
    pictures::add_support(scene, outline);
    pictures::Subject subject = pictures::with_room(pictures::subject_of(scene, outline), label, 0.0);
    subject.shadow.clear();  // cells are compared: the bodies are in the middle of each
    return pictures::composed(view, subject, aspect);
}

// What tells the run of a row from the others: its title, or the first option in which they differ.
std::string label_of(const PictureGrid& grid, std::size_t row) {
    if (grid.runs.size() < 2) return "";
    if (row < grid.titles.size()) {
        std::string title = grid.titles[row];
        std::ranges::replace(title, '\n', ' ');
        return title;
    }
    for (const SimulationOption& option : simulation_options()) {
        const std::string own = option.get(grid.runs[row].settings);
        const auto is_other = [&](const Choices& run) { return option.get(run.settings) != own; };
        if (std::ranges::any_of(grid.runs, is_other)) return std::string(option.name) + " " + own;
    }
    return "";
}

// Room for texts around the cells [pixels].
struct Room {
    float size = 16.0f;  // of the font
    int left = 0;        // of the titles of the rows
    int below = 0;       // of the labels of a row of cells, for print; on a screen these are in the cells
    int legend = 0;      // under all cells, for print
};

float width_of(const std::string& lines, float size, const pictures::Lettering& lettering) {
    float widest = 0.0f;
    std::istringstream stream(lines);
    for (std::string line; std::getline(stream, line);) widest = std::max(widest, lettering.width(line, size));
    return widest;
}

std::vector<std::string> label_lines(const PictureGrid& grid, std::size_t cell, float size, int across,
                                     const pictures::Lettering& lettering) {
    return wrapped(grid.cells[cell].label, [&](const std::string& line) {
        return lettering.width(line, size) <= static_cast<float>(across);
    });
}

Room room_of(const FigureOutput& output, const PictureGrid& grid, const pictures::Lettering& lettering) {
    Room room{.size = output.letters(95.0f)};
    if (!output.format().print) {
        if (!grid.titles.empty()) room.left = output.width() / 11;
        return room;
    }
    for (const std::string& title : grid.titles) {
        const float wide = width_of(title, room.size, lettering) + room.size;
        room.left = std::max(room.left, static_cast<int>(wide));
    }
    const int across = (output.width() - room.left) / grid.columns;
    std::size_t most = 1;
    for (std::size_t i = 0; i < grid.cells.size(); ++i)
        most = std::max(most, label_lines(grid, i, room.size, across, lettering).size());
    room.below = static_cast<int>(room.size * (0.6f + 1.2f * static_cast<float>(most)));
    if (grid.overlay) room.legend = static_cast<int>(pictures::legend_height(1, room.size));
    return room;
}

// Each vertically centred on its row.
void add_titles(const PictureGrid& grid, const Room& room, const std::vector<renderer::Rectangle>& cells,
                Sheet& sheet) {
    for (std::size_t row = 0; row < grid.titles.size(); ++row) {
        const renderer::Rectangle& place = cells[row * static_cast<std::size_t>(grid.columns)];
        std::istringstream lines(grid.titles[row]);
        float y = place.y + 0.5f * place.height;
        for (std::string line; std::getline(lines, line); y += 1.5f * room.size) {
            sheet.texts.push_back({line, {0.5f * static_cast<float>(room.left), y}, room.size, true});
        }
    }
}

// Under each cell, for print.
void add_labels(const PictureGrid& grid, const Room& room, const std::vector<renderer::Rectangle>& cells,
                const pictures::Lettering& lettering, Sheet& sheet) {
    for (std::size_t i = 0; i < cells.size(); ++i) {
        float y = cells[i].y + cells[i].height + 1.2f * room.size;
        for (const std::string& line :
             label_lines(grid, i, room.size, static_cast<int>(cells[i].width), lettering)) {
            sheet.texts.push_back({line, {cells[i].x + 0.5f * cells[i].width, y}, room.size, true});
            y += 1.2f * room.size;
        }
    }
}

// The runs side by side, all up to the last time of the grid.
void write_replay(const PictureGrid& grid, const std::string& command, const std::filesystem::path& file) {
    Sequence sequence;
    for (std::size_t r = 0; r < grid.runs.size(); ++r) {
        sequence.panels.push_back({.label = label_of(grid, r), .choices = grid.runs[r]});
        FrameChoices& frames = sequence.panels.back().choices.frames;
        frames.camera = {.fit = grid.fit};
        if (grid.overlay) frames.overlay = {*grid.overlay};
    }
    long end = 0;
    for (const Cell& cell : grid.cells) end = std::max(end, step_of(cell.time, grid.runs.front()));
    sequence.frames.resize(grid.runs.size(), Frames(1, static_cast<std::size_t>(end) + 1));
    Session session(sequence);
    pictures::Replay replay({.file = file, .command = command}, session);
    session.play_frames({&replay}, goes_on);
    replay.finish();
}

Sheet draw_grid(FigureOutput& output, const PictureGrid& grid) {
    const pictures::Lettering& lettering = output.offscreen().lettering();
    const Room room = room_of(output, grid, lettering);
    const int rows = (static_cast<int>(grid.cells.size()) + grid.columns - 1) / grid.columns;
    const int across = (output.width() - room.left) / grid.columns;
    const Size size{output.width() - room.left, rows * static_cast<int>(across / grid.cell_aspect)};
    const Layout layout = pictures::grid(size, grid.columns, rows);
    const double aspect = layout.cell_aspect();
    // A label in the cell needs room at the top of it.
    const double label = room.below > 0 ? 0.0 : 1.8 * room.size / layout.cell.height;
    const View view = camera_of(grid, aspect, label);

    const int all_rows = size.height + rows * room.below;
    Sheet sheet = Sheet::blank(output.width(), all_rows + room.legend, output.format());
    std::vector<renderer::Rectangle> cells(grid.cells.size());
    for (std::size_t i = 0; i < cells.size(); ++i) {
        cells[i] = layout.place(i);
        cells[i].x += static_cast<float>(room.left);
        cells[i].y += static_cast<float>(static_cast<int>(i) / grid.columns * room.below);
    }
    play_cells(grid, [&](std::size_t i, const Simulation& run) {
        renderer::Picture picture = pictures::draw_list(run.scene(), view);
        picture.mark_scale = static_cast<float>(rows);
        if (grid.overlay) {
            pictures::add_overlay(run.scene(), grid.overlay->kind, *grid.overlay->units_a_metre, picture);
        }
        sheet.paste(output.offscreen(), std::move(picture), layout.cell, output.samples(),
                    static_cast<int>(cells[i].x), static_cast<int>(cells[i].y));
        if (grid.look) grid.look(grid.cells[i], run);
    });
    add_titles(grid, room, cells, sheet);
    if (room.below > 0) {
        add_labels(grid, room, cells, lettering, sheet);
    } else {
        for (std::size_t i = 0; i < cells.size(); ++i) {
            for (SheetLayer& layer : sheet.layers)
                lettering.name(layer.image, cells[i], grid.cells[i].label, room.size);
        }
    }
    if (grid.overlay) {
        const pictures::Scale scale{grid.overlay->kind, *grid.overlay->units_a_metre};
        const pictures::LegendLine line =
            legend_line(pictures::entries_of(scale.kind).front(), scale, view, layout.cell.height);
        const renderer::Rectangle strip{0.0f, static_cast<float>(all_rows), static_cast<float>(output.width()),
                                        static_cast<float>(room.legend)};
        const renderer::Rectangle& place = room.legend > 0 ? strip : cells.back();
        for (SheetLayer& layer : sheet.layers) lettering.legend(layer.image, place, {line}, room.size);
    }
    return sheet;
}

}  // namespace

SectionContent draw_figure(FigureOutput& output, const Figure& figure, const PictureGrid& grid) {
    SectionContent content = output.save(draw_grid(output, grid), figure);
    const std::string name(figure.name);
    write_replay(grid, "pushfactor figures " + name, output.file(name + ".html"));
    content.replays.push_back(name + ".html");
    return content;
}

}  // namespace pushfactor::demos::figures
