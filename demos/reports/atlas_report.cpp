// The stability atlas, maps of the outcomes of runs over two of their parameters: atlas.csv, and the maps that are
// complete. A piece is a cell, so that the full atlas, the quick one and a part share what they have in common.
#include "demos/platform/output_file.h"
#include "demos/platform/version.h"
#include "demos/reports/atlas/atlas.h"
#include "demos/runs/summary.h"
#include "demos/text/suggest.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pushfactor::demos::reports {

namespace {

using namespace atlas;

std::string key_of(const std::string& what, const AtlasCell& cell) {
    return fmt::format("atlas: {} of {}", what, run_key(cell.scene, cell.options));
}

Piece piece_of(const AtlasCell& cell) {
    return {key_of(cell.measure, cell), [cell](const StopCheck& check) {
                const auto [outcome, value] = run_cell(cell, check);
                return Json{{"outcome", outcome}, {"value", json_number(value)}};
            }};
}

// A page that plays the run of the cell, as a piece whose result is its text; and the name of its file.
Piece replay_piece_of(const AtlasCell& cell) {
    return {key_of("replay", cell),
            [cell](const StopCheck& check) { return Json(replay_of(cell.scene, cell.options, check)); }};
}

std::string replay_file(const AtlasMap& map, const AtlasCell& cell) {
    std::string name = fmt::format("{}_{}_{}_{}", map.x.option, cell.x, map.y.option, cell.y);
    std::ranges::replace(name, '/', '-');
    return "cells/" + name + ".html";
}

// All maps of the request, whether asked for by --only or not.
std::vector<AtlasMap> maps_of(const StudyRequest& request) {
    return request.grid ? std::vector{grid_map(*request.grid)} : atlas_maps(request.quick);
}

Pieces atlas_pieces(const StudyRequest& request) {
    Pieces pieces;
    for (const AtlasMap& map : maps_of(request)) {
        if (!request.grid && !request.wants(map.name)) continue;
        for (const AtlasCell& cell : cells_of(map)) pieces.push_back(piece_of(cell));
        if (!request.grid) continue;
        for (const AtlasCell& cell : cells_with_replay(map, *request.grid)) pieces.push_back(replay_piece_of(cell));
    }
    return pieces;
}

// Results of one map; empty if a cell is missing.
std::vector<CellResult> results_of(const AtlasMap& map, const StudyRun& run) {
    std::vector<CellResult> results;
    for (const AtlasCell& cell : cells_of(map)) {
        const auto found = run.find(piece_of(cell).key);
        if (!found) return {};
        results.push_back({found->at("outcome"), number_in(found->at("value"))});
    }
    return results;
}

void add_replays(const AtlasMap& map, StudyRun& run, SectionContent& plate) {
    const std::vector<AtlasCell> cells = cells_with_replay(map, *run.request().grid);
    if (cells.empty()) return;
    make_folder(run.folder() / "cells");
    for (const AtlasCell& cell : cells) {
        run.write(replay_file(map, cell), run.result(replay_piece_of(cell).key).get<std::string>());
        plate.replays.push_back(replay_file(map, cell));
    }
}

// A line per cell, with the command that reproduces it.
void add_lines(const AtlasMap& map, const std::vector<CellResult>& results, Table& table) {
    const std::vector<AtlasCell> cells = cells_of(map);
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const auto& [outcome, value] = results.at(i);
        table.rows.push_back({map.name, map.x.option, cells[i].x, map.y.option, cells[i].y, outcome,
                              map.measure.key, std::isnan(value) ? Cell() : Cell(value), command_of(cells[i])});
    }
}

void make_atlas(StudyRun& run) {
    Table table{{"map", "x_name", "x", "y_name", "y", "outcome", "measure", "value", "command"}};
    for (const AtlasMap& map : maps_of(run.request())) {
        const std::vector<CellResult> results = results_of(map, run);
        if (results.empty()) continue;
        add_lines(map, results, table);
        run.sections.push_back(atlas_section(map, results, run.folder()));
        if (run.request().grid) add_replays(map, run, run.sections.back().content);
    }
    run.write("atlas.csv", fmt::format("# pushfactor {}: stability atlas\n{}", version_number(), csv_text(table)));
    run.write_page(
        fmt::format("Outcomes of runs over two of their parameters: a cell is a run, its colour the outcome that "
                    "the run's summary names, judged over the last second. White dashed lines are theoretical "
                    "limits. atlas.csv has the command that reproduces each cell.{}",
                    run.quick() ? " This is the quick atlas: three values per axis." : ""));
}

}  // namespace

AtlasCell atlas::cell_at(const AtlasMap& map, const std::string& x, const std::string& y) {
    AtlasCell cell{map.scene, x, y, map.common, map.measure.key};
    cell.options.insert(cell.options.end(), {{map.x.option, x}, {map.y.option, y}});
    return cell;
}

std::vector<AtlasCell> atlas::cells_of(const AtlasMap& map) {
    std::vector<AtlasCell> cells;
    for (const std::string& y : map.y.values) {
        for (const std::string& x : map.x.values) cells.push_back(cell_at(map, x, y));
    }
    return cells;
}

std::string atlas::command_of(const AtlasCell& cell) {
    return command_text("run", cell.scene, cell.options);
}

CellResult atlas::run_cell(const AtlasCell& cell, const StopCheck& check) {
    const Choices choices = run_of(cell.scene, cell.options);
    Simulation run(choices);
    Measurements measurements(run);
    const bool finite = play_to_end(run, check, measurements);
    // The summary may have no such number, as a drift after 10 s in a shorter run.
    const Json summary = parse_json(summary_text(choices, run, measurements));
    const auto number = summary.find(cell.measure);
    const bool has_number = number != summary.end() && number->is_number();
    return {std::string(finite ? name_of(measurements.outcome()) : non_finite),
            has_number ? number->get<double>() : std::numeric_limits<double>::quiet_NaN()};
}

Study atlas_study() {
    return {.name = "atlas",
            .title = "stability atlas",
            .parts = names_of(atlas_maps()),
            .make = make_atlas,
            .pieces = atlas_pieces};
}

}  // namespace pushfactor::demos::reports
